#include "phase/hypothesis_group.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

constexpr double NOISE = 0.0032; ///< white part of a tracker's error, amplitudes
/// Of an outlier, amplitudes: jumps of some centimetres.
constexpr double OUTLIER_DEVIATION = 0.21;
const double LOG_IMPOSSIBLE = std::log(1e-30);
/// Durations that a hypothesis may come to.
const double LOG_SHORTEST = std::log(0.12);
const double LOG_LONGEST = std::log(8.0);

// By index_of.
template <class Numbers, class Number> constexpr Lanes of_each(const Numbers &numbers, Number number) {
	Lanes lanes{};
	for (std::size_t i = 0; i < numbers.size(); ++i) {
		lanes[i] = number(numbers[i]);
	}
	return lanes;
}
constexpr Lanes HANDS = of_each(REGIME_NUMBERS, [](const auto &regime) { return regime.hand.amplitudes; });
constexpr Lanes ERRORS_AT_START =
		of_each(ERROR_NUMBERS, [](const auto &error) { return error.at_start.amplitudes; });
constexpr Lanes ERRORS_ON_WAY = of_each(ERROR_NUMBERS, [](const auto &error) { return error.on_way; });
constexpr Lanes WHITE_VARIANCES =
		of_each(ERROR_NUMBERS, [](const auto &error) { return NOISE * NOISE + error.noise * error.noise; });

using Group = HypothesisGroup;
using Hypothesis = GestureHypothesis;
/// Of a deviation and its rate, lane by lane.
struct LaneDamping {
	LaneVector xx, xv, vx, vv, noise_x, noise_xv, noise_v;

	/// Each as in its regime, or of its error; variance: of what is damped, where it comes to rest.
	STEADYHAND_INLINE LaneDamping(
			const Dampings &by, const std::array<std::uint8_t, LANES> &kinds, const LaneVector &variance) :
			xx(pick(by.xx, kinds)),
			xv(pick(by.xv, kinds)), vx(pick(by.vx, kinds)), vv(pick(by.vv, kinds)),
			noise_x(variance * pick(by.noise_x, kinds)), noise_xv(variance * pick(by.noise_xv, kinds)),
			noise_v(variance * pick(by.noise_v, kinds)) {}
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

	/// F differs from unity in two pairs of states alone: a deviation and its rate, of the hand and of the
	/// tracker. Noise comes to these, and to the pace.
	STEADYHAND_INLINE void predict(const Passages &passages) const {
		const LaneVector hands = pick(HANDS, group.regime_);
		LaneVector errors = pick(ERRORS_AT_START, group.error_);
		const LaneVector on_way = load(group.on_its_way_) * pick(ERRORS_ON_WAY, group.error_);
		group.is_way_known_ = any(on_way > 0.0);
		if (group.is_way_known_) {
			const LaneVector gone = way(phase());
			store(group.way_, gone);
			errors += on_way * gone;
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
		change_pace(passages.pace_variance);
	}

	/// The pace changes, the phase does not: as the log duration grows by e, the onset goes back by
	/// (t - onset) e.
	STEADYHAND_INLINE void change_pace(double variance) const {
		using H = Hypothesis;
		const LaneVector added = load(group.on_its_way_) * variance;
		const LaneVector duration = 1.0 / load(group.rate_per_s_), gone = t_s - load(group.mean_[H::ONSET]);
		const LaneVector under_way = gone > duration ? duration : gone;
		const auto add = [&](std::size_t i, std::size_t j, const LaneVector &more) STEADYHAND_INLINE_LAMBDA {
			store(covariance(i, j), load(covariance(i, j)) + more);
		};
		add(H::ONSET, H::ONSET, under_way * under_way * added);
		add(H::LOG_DURATION, H::ONSET, -under_way * added);
		add(H::LOG_DURATION, H::LOG_DURATION, added);
	}

	/// The states that the way depends on; of the others the tracker shows HAND + ERROR.
	static constexpr std::size_t FIRST_OF_WAY = Hypothesis::ONSET;
	static constexpr std::size_t STATES_OF_WAY = Hypothesis::STATES - FIRST_OF_WAY;
	struct Sight {
		LaneVector innovation;                            ///< x less what the tracker should show
		std::array<LaneVector, STATES_OF_WAY> slopes;     ///< by how much that changes with each state
		std::array<LaneVector, Hypothesis::STATES> cross; ///< P H', its covariance with each state
		LaneVector variance;                              ///< H P H' + R, of the innovation
	};

	/// What x says, and how well it is foretold: the tracker shows (1 + g) f(p - lag f(p) / duration) + d +
	/// b.
	STEADYHAND_INLINE Sight sight_of(double x, double jitter) const {
		using H = Hypothesis;
		Sight sight;
		const LaneVector rate = load(group.rate_per_s_), shape = load(group.mean_[H::SHAPE]);
		const LaneVector is_under_way = load(group.on_its_way_),
						 now = is_under_way > 0.0 ? phase() : LaneVector{};
		const LaneVector lags = is_under_way > 0.0 ? load(group.mean_[H::LAG]) : LaneVector{};
		const LaneVector may_lag = is_under_way > 0.0 ? load(covariance(H::LAG, H::LAG)) : LaneVector{};
		LaneVector way_now{};
		if (any(may_lag > 0.0)) {
			way_now = may_lag > 0.0 ? (group.is_way_known_ ? load(group.way_) : way(now)) : LaneVector{};
		}
		const LaneVector then = now - lags * way_now * rate, phases = then > 0.0 ? then : LaneVector{};
		const LaneVector gone = then > 0.0 ? way_now : LaneVector{};
		const LaneCurvePoint element = curve.at(phases);
		const LaneVector elements = element.value, element_slopes = element.slope;
		const LaneMinimumJerk smooth(within_one(phases));
		const LaneVector gain = 1.0 + load(group.mean_[H::GAIN]);
		const LaneVector value = elements + shape * (smooth.value - elements);
		const LaneVector slope = gain * (element_slopes + shape * (smooth.first - element_slopes));
		sight.slopes[H::ONSET - FIRST_OF_WAY] = -slope * rate;
		sight.slopes[H::LOG_DURATION - FIRST_OF_WAY] = -slope * phases;
		sight.slopes[H::GAIN - FIRST_OF_WAY] = value;
		sight.slopes[H::SHAPE - FIRST_OF_WAY] = gain * (smooth.value - elements);
		sight.slopes[H::LAG - FIRST_OF_WAY] = -slope * gone * rate;
		sight.innovation = x - (gain * value + load(group.mean_[H::HAND]) + load(group.mean_[H::ERROR]));

		unrolled<H::STATES>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			sight.cross[i] = load(covariance(std::max<std::size_t>(i, H::HAND), H::HAND)) +
					load(covariance(std::max<std::size_t>(i, H::ERROR), std::min<std::size_t>(i, H::ERROR)));
			unrolled<STATES_OF_WAY>([&](auto j) STEADYHAND_INLINE_LAMBDA {
				constexpr std::size_t K = FIRST_OF_WAY + j;
				sight.cross[i] += sight.slopes[j] *
						load(covariance(std::max<std::size_t>(i, K), std::min<std::size_t>(i, K)));
			});
		});
		sight.variance = sight.cross[H::HAND] + sight.cross[H::ERROR] +
				(pick(WHITE_VARIANCES, group.error_) + jitter * jitter);
		for (std::size_t j = 0; j < STATES_OF_WAY; ++j) {
			sight.variance += sight.slopes[j] * sight.cross[FIRST_OF_WAY + j];
		}
		return sight;
	}

	/// Probabilistic data association (Bar-Shalom, Li, Kirubarajan 2001): the frame is good, or an outlier,
	/// whose density is broad.
	STEADYHAND_INLINE void absorb(double x, const Trust &trust, Lanes &r_log_weights) const {
		const Sight sight = sight_of(x, trust.jitter);
		const LaneVector precision = 1.0 / sight.variance;
		const LaneVector broad_precision = 1.0 / (sight.variance + OUTLIER_DEVIATION * OUTLIER_DEVIATION);
		const LaneVector half_squared = 0.5 * sight.innovation * sight.innovation;
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
		correct(sight, good_share * sight.innovation * precision,
				good_share * precision * (1.0 - 2.0 * (1.0 - good_share) * half_squared * precision));
		keep_possible();
	}

	/// The means take a step of that many P H', the covariance loses that much of P H' H P.
	STEADYHAND_INLINE void correct(const Sight &sight, const LaneVector &step, const LaneVector &less) const {
		unrolled<Hypothesis::STATES>([&](auto i) STEADYHAND_INLINE_LAMBDA {
			store(group.mean_[i], load(group.mean_[i]) + sight.cross[i] * step);
			const LaneVector share = sight.cross[i] * less;
			unrolled<i + 1>([&](auto j) STEADYHAND_INLINE_LAMBDA {
				store(covariance(i, j), load(covariance(i, j)) - share * sight.cross[j]);
			});
		});
	}

	STEADYHAND_INLINE void keep_possible() const {
		using H = Hypothesis;
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
	regime_[lane] = static_cast<std::uint8_t>(index_of(hypothesis.regime_));
	error_[lane] = static_cast<std::uint8_t>(index_of(hypothesis.error_));
	on_its_way_[lane] = hypothesis.on_its_way_ ? 1.0 : 0.0;
	is_way_known_ = false;
}

void HypothesisGroup::copy(std::size_t lane, const HypothesisGroup &from, std::size_t from_lane) {
	for (std::size_t i = 0; i < GestureHypothesis::STATES; ++i) {
		mean_[i][lane] = from.mean_[i][from_lane];
	}
	for (std::size_t i = 0; i < GestureHypothesis::ENTRIES; ++i) {
		covariance_[i][lane] = from.covariance_[i][from_lane];
	}
	rate_per_s_[lane] = from.rate_per_s_[from_lane];
	regime_[lane] = from.regime_[from_lane];
	error_[lane] = from.error_[from_lane];
	on_its_way_[lane] = from.on_its_way_[from_lane];
	is_way_known_ = false;
}

void HypothesisGroup::mark_beyond(double t_s, double phase, std::span<bool, LANES> r_marks) const {
	for (std::size_t l = 0; l < LANES; ++l) {
		const double now = (t_s - mean_[GestureHypothesis::ONSET][l]) * rate_per_s_[l];
		r_marks[l] = (on_its_way_[l] > 0.0) & (now > phase);
	}
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
	h.regime_ = regime(lane);
	h.error_ = error(lane);
	h.on_its_way_ = on_its_way(lane);
	return h;
}

} // namespace steadyhand
