#include "motion/hypothesis_group.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <limits>

// As in lanes.h: what passes vectors is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace steadyhand {
namespace {

constexpr double NOISE = 0.0032; ///< white part of a tracker's error, amplitudes
/// Of an outlier, amplitudes: jumps of some centimetres.
constexpr double OUTLIER_DEVIATION = 0.21;
const double LOG_IMPOSSIBLE = std::log(1e-30);
/// Durations that a hypothesis may come to.
const double LOG_SHORTEST = std::log(0.12);
const double LOG_LONGEST = std::log(6.0);

using Group = HypothesisGroup;
using Hypothesis = GestureHypothesis;
/// Of a deviation and its rate, lane by lane.
struct LaneDamping {
	LaneVector xx, xv, vx, vv, noise_x, noise_xv, noise_v;

	/// Each as in its regime, or of its error; variance: of what is damped, where it comes to rest.
	template <typename Kind>
	STEADYHAND_INLINE LaneDamping(
			const Dampings &by, const std::array<Kind, LANES> &kinds, const LaneVector &variance) :
			xx(of(by.xx, kinds)),
			xv(of(by.xv, kinds)), vx(of(by.vx, kinds)), vv(of(by.vv, kinds)),
			noise_x(variance * of(by.noise_x, kinds)), noise_xv(variance * of(by.noise_xv, kinds)),
			noise_v(variance * of(by.noise_v, kinds)) {}
	template <typename Kind>
	STEADYHAND_INLINE static LaneVector of(const Lanes &by_kind, const std::array<Kind, LANES> &kinds) {
		return each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA { return by_kind[index_of(kinds[l])]; });
	}
	/// [x, v] becomes F [x, v].
	STEADYHAND_INLINE void apply(Lanes &r_x, Lanes &r_v) const {
		const LaneVector x = load(r_x), v = load(r_v);
		store(r_x, xx * x + xv * v);
		store(r_v, vx * x + vv * v);
	}
	/// The covariance of x and v becomes F P F' + Q.
	STEADYHAND_INLINE void apply(Lanes &r_x, Lanes &r_xv, Lanes &r_v) const {
		const LaneVector x = load(r_x), both = load(r_xv), v = load(r_v);
		const LaneVector x_x = xx * x + xv * both, x_v = xx * both + xv * v;
		const LaneVector v_x = vx * x + vv * both, v_v = vx * both + vv * v;
		store(r_x, xx * x_x + xv * x_v + noise_x);
		store(r_xv, vx * x_x + vv * x_v + noise_xv);
		store(r_v, vx * v_x + vv * v_v + noise_v);
	}
};

} // namespace

struct HypothesisGroup::Filter {
	Group &group;
	const ElementCurve &curve;
	double t_s;

	Lanes &covariance(std::size_t i, std::size_t j) const {
		return group.covariance_[Hypothesis::entry(i, j)];
	}
	/// f(phase) in 0..1
	[[nodiscard]] STEADYHAND_INLINE LaneVector way(const LaneVector &phase) const {
		const LaneVector elements = curve.at(phase).value;
		const LaneVector shape = load(group.mean_[Hypothesis::SHAPE]);
		return within_one(elements + shape * (LaneMinimumJerk(within_one(phase)).value - elements));
	}
	[[nodiscard]] STEADYHAND_INLINE LaneVector phase() const {
		return (t_s - load(group.mean_[Hypothesis::ONSET])) * load(group.rate_per_s_);
	}
	/// 1 of those on their way, 0 of the others.
	[[nodiscard]] STEADYHAND_INLINE LaneVector on_its_way() const {
		return each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA { return group.on_its_way_[l] ? 1.0 : 0.0; });
	}

	/// F differs from unity in two pairs of states alone: a deviation and its rate, of the hand and of the
	/// tracker.
	STEADYHAND_INLINE void predict(const Passages &passages) const {
		const LaneVector hands = each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA {
			return regime_numbers(group.regime_[l]).hand.amplitudes;
		});
		LaneVector errors = each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA {
			return error_numbers(group.error_[l]).at_start.amplitudes;
		});
		const LaneVector on_way = on_its_way() * each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA {
			return error_numbers(group.error_[l]).on_way;
		});
		if (any(on_way > 0.0)) {
			errors += on_way * way(phase());
		}
		const LaneDamping hand(passages.hand, group.regime_, hands * hands),
				error(passages.error, group.error_, errors * errors);
		using H = Hypothesis;
		hand.apply(group.mean_[H::HAND], group.mean_[H::HAND_RATE]);
		error.apply(group.mean_[H::ERROR], group.mean_[H::ERROR_RATE]);
		hand.apply(covariance(H::HAND, H::HAND), covariance(H::HAND_RATE, H::HAND),
				covariance(H::HAND_RATE, H::HAND_RATE));
		error.apply(covariance(H::ERROR, H::ERROR), covariance(H::ERROR_RATE, H::ERROR),
				covariance(H::ERROR_RATE, H::ERROR_RATE));
		for (const std::size_t i : { H::HAND, H::HAND_RATE }) {
			error.apply(covariance(H::ERROR, i), covariance(H::ERROR_RATE, i));
		}
		unrolled<H::STATES - H::ERROR>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			hand.apply(covariance(H::ERROR + i, H::HAND), covariance(H::ERROR + i, H::HAND_RATE));
		});
		unrolled<H::STATES - H::ONSET>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			error.apply(covariance(H::ONSET + i, H::ERROR), covariance(H::ONSET + i, H::ERROR_RATE));
		});
	}

	STEADYHAND_INLINE void absorb(double x, const Trust &trust, Lanes &r_log_weights) const {
		using H = Hypothesis;
		constexpr std::size_t FIRST = H::ONSET, SLOPES = H::STATES - FIRST;
		// What the tracker should show, and by how much that changes with each state.
		const LaneVector rate = load(group.rate_per_s_), shape = load(group.mean_[H::SHAPE]);
		const LaneVector is_under_way = on_its_way(), now = is_under_way > 0.0 ? phase() : LaneVector{};
		const LaneVector lags = is_under_way > 0.0 ? load(group.mean_[H::LAG]) : LaneVector{};
		const LaneVector way_now = any(lags > 0.0) ? (lags > 0.0 ? way(now) : LaneVector{}) : LaneVector{};
		const LaneVector then = now - lags * way_now * rate, phases = then > 0.0 ? then : LaneVector{};
		const LaneVector gone = then > 0.0 ? way_now : LaneVector{};
		const LaneCurvePoint element = curve.at(phases);
		const LaneVector elements = element.value, element_slopes = element.slope;
		const LaneMinimumJerk smooth(within_one(phases));
		const LaneVector gain = 1.0 + load(group.mean_[H::GAIN]);
		const LaneVector value = elements + shape * (smooth.value - elements);
		const LaneVector slope = gain * (element_slopes + shape * (smooth.first - element_slopes));
		std::array<LaneVector, SLOPES> slopes;
		slopes[H::ONSET - FIRST] = -slope * rate;
		slopes[H::LOG_DURATION - FIRST] = -slope * phases;
		slopes[H::GAIN - FIRST] = value;
		slopes[H::SHAPE - FIRST] = gain * (smooth.value - elements);
		slopes[H::LAG - FIRST] = -slope * gone * rate;
		const LaneVector innovation =
				x - (gain * value + load(group.mean_[H::HAND]) + load(group.mean_[H::ERROR]));

		std::array<LaneVector, H::STATES> seen;
		unrolled<H::STATES>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			seen[i] = load(covariance(std::max<std::size_t>(i, H::HAND), H::HAND)) +
					load(covariance(std::max<std::size_t>(i, H::ERROR), std::min<std::size_t>(i, H::ERROR)));
			unrolled<SLOPES>([&](auto j) STEADYHAND_INLINE_LAMBDA {
				constexpr std::size_t K = FIRST + j;
				seen[i] += slopes[j] *
						load(covariance(std::max<std::size_t>(i, K), std::min<std::size_t>(i, K)));
			});
		});
		LaneVector variance = seen[H::HAND] + seen[H::ERROR] + (NOISE * NOISE + trust.jitter * trust.jitter);
		for (std::size_t j = FIRST; j < H::STATES; ++j) {
			variance += slopes[j - FIRST] * seen[j];
		}
		const LaneVector precision = 1.0 / variance;
		const LaneVector broad_precision = 1.0 / (variance + OUTLIER_DEVIATION * OUTLIER_DEVIATION);
		const LaneVector half_squared = 0.5 * innovation * innovation;
		// Beside the broad density's exponential, which alone is left of what is far off.
		const LaneVector good = exponential(half_squared * (broad_precision - precision)) *
				(1.0 - trust.outlier) * square_root(precision);
		const LaneVector bad = trust.outlier * square_root(broad_precision);
		const LaneVector sum = good + bad + std::numeric_limits<double>::min();
		const LaneVector good_share = good / sum;
		const LaneVector log_likelihood = logarithm(sum) - half_squared * broad_precision;
		for (std::size_t l = 0; l < LANES; ++l) {
			r_log_weights[l] += trust.weight * std::max(log_likelihood[l], LOG_IMPOSSIBLE);
		}

		const LaneVector step = good_share * innovation * precision;
		const LaneVector less =
				good_share * precision * (1.0 - 2.0 * (1.0 - good_share) * half_squared * precision);
		unrolled<H::STATES>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			store(group.mean_[i], load(group.mean_[i]) + seen[i] * step);
			const LaneVector share = seen[i] * less;
			unrolled<i + 1>([&](auto j) STEADYHAND_INLINE_LAMBDA {
				store(covariance(i, j), load(covariance(i, j)) - share * seen[j]);
			});
		});
		LaneVector log_duration = load(group.mean_[H::LOG_DURATION]), lag = load(group.mean_[H::LAG]);
		log_duration = log_duration < LOG_SHORTEST ? all(LOG_SHORTEST) : log_duration;
		log_duration = log_duration > LOG_LONGEST ? all(LOG_LONGEST) : log_duration;
		lag = lag < 0.0 ? LaneVector{} : lag;
		store(group.mean_[H::LOG_DURATION], log_duration);
		store(group.mean_[H::LAG], lag);
		store(group.rate_per_s_, exponential(-log_duration));
	}
};

STEADYHAND_WIDE void HypothesisGroup::predict(
		const ElementCurve &curve, double t_s, const Passages &passages) {
	Filter{ *this, curve, t_s }.predict(passages);
}

STEADYHAND_WIDE void HypothesisGroup::absorb(
		const ElementCurve &curve, double t_s, double x, const Trust &trust, Lanes &r_log_weights) {
	Filter{ *this, curve, t_s }.absorb(x, trust, r_log_weights);
}

void HypothesisGroup::set(std::size_t lane, const GestureHypothesis &hypothesis) {
	for (std::size_t i = 0; i < GestureHypothesis::STATES; ++i) {
		mean_[i][lane] = hypothesis.mean_[i];
	}
	for (std::size_t i = 0; i < GestureHypothesis::ENTRIES; ++i) {
		covariance_[i][lane] = hypothesis.covariance_[i];
	}
	rate_per_s_[lane] = hypothesis.rate_per_s_;
	regime_[lane] = hypothesis.regime_;
	error_[lane] = hypothesis.error_;
	on_its_way_[lane] = hypothesis.on_its_way_;
}

GestureHypothesis HypothesisGroup::hypothesis(std::size_t lane) const {
	GestureHypothesis h;
	for (std::size_t i = 0; i < GestureHypothesis::STATES; ++i) {
		h.mean_[i] = mean_[i][lane];
	}
	for (std::size_t i = 0; i < GestureHypothesis::ENTRIES; ++i) {
		h.covariance_[i] = covariance_[i][lane];
	}
	h.rate_per_s_ = rate_per_s_[lane];
	h.regime_ = regime_[lane];
	h.error_ = error_[lane];
	h.on_its_way_ = on_its_way_[lane];
	return h;
}

} // namespace steadyhand
