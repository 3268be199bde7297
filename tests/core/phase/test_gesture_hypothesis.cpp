#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/motion_outlook.h"
#include "signal/minimum_jerk.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <random>
#include <vector>

using namespace steadyhand;

namespace {

/// What one hypothesis alone expects.
PhaseEstimate hand(const GestureHypothesis &hypothesis, double t_s, double filtered_s) {
	HypothesisBank bank;
	bank.start(hypothesis);
	MotionOutlook outlook;
	outlook.look(bank, test::drag_curve(), filtered_s, 0.0, filtered_s);
	return outlook.at(test::drag_curve(), t_s);
}

/// A bank of one.
class Alone {
public:
	explicit Alone(const GestureHypothesis &hypothesis) { bank_.start(hypothesis); }
	void predict(double t_s, double dt_s) { bank_.predict(test::drag_curve(), t_s, passages(dt_s)); }
	void absorb(double t_s, double x, const HypothesisGroup::Trust &trust) {
		bank_.absorb(test::drag_curve(), t_s, x, trust);
	}
	[[nodiscard]] GestureHypothesis get() const { return bank_.hypothesis(0); }
	void set(const GestureHypothesis &hypothesis) { bank_.set(0, hypothesis); }

private:
	HypothesisBank bank_;
};

/// Covariance of critically damped noise at two instants (Matern 3/2; Rasmussen & Williams 2006, eq. 4.17).
double covariance(const Deviation &noise, double apart_s) {
	const double r = noise.rate_per_s * std::abs(apart_s);
	return noise.amplitudes * noise.amplitudes * (1.0 + r) * std::exp(-r);
}

} // namespace

TEST_CASE("at rest a hypothesis is Gaussian process regression on the frames so far, and its weight the "
		  "evidence, whether the tracker jumps or not") {
	constexpr double NOISE = 0.0032;
	constexpr double JUMP = 0.1; // standard deviation
	constexpr std::size_t JUMPS_AT = 15;
	const Deviation &of_hand = regime_numbers(Regime::REST).hand,
					&of_tracker = error_numbers(regime_numbers(Regime::REST).error).at_start;
	std::mt19937_64 random(5);
	std::normal_distribution<double> normal;
	std::vector<double> t, x;
	double t_s = 0.0;
	while (t.size() < 40) {
		t_s += 0.005 + 0.02 * std::abs(normal(random));
		t.push_back(t_s);
		x.push_back(0.03 * std::sin(5.0 * t_s) + 0.004 * normal(random));
	}

	Alone alone(GestureHypothesis::resting(0.0));
	double filtered_s = t.front();
	for (std::size_t i = 0; i < t.size(); ++i) {
		alone.predict(t[i], t[i] - filtered_s);
		filtered_s = t[i];
		alone.set(i == JUMPS_AT ? alone.get().displaced(JUMP) : alone.get());
		alone.absorb(t[i], x[i], { .outlier = 0.0, .weight = 1.0 });
	}
	const GestureHypothesis hypothesis = alone.get();

	// What is left of the jump: it fades critically damped.
	const auto left = [&](double t_i) {
		const double r = of_tracker.rate_per_s * (t_i - t[JUMPS_AT]);
		return r < 0.0 ? 0.0 : JUMP * (1.0 + r) * std::exp(-r);
	};
	const auto n = static_cast<Eigen::Index>(t.size());
	const double later_s = t.back() + 0.05;
	Eigen::MatrixXd seen(n, n);
	Eigen::VectorXd shared(n);
	for (Eigen::Index i = 0; i < n; ++i) {
		const double t_i = t[static_cast<std::size_t>(i)];
		for (Eigen::Index j = 0; j < n; ++j) {
			const double apart_s = t_i - t[static_cast<std::size_t>(j)];
			seen(i, j) = covariance(of_hand, apart_s) + covariance(of_tracker, apart_s) +
					left(t_i) * left(t[static_cast<std::size_t>(j)]) + (i == j ? NOISE * NOISE : 0.0);
		}
		shared[i] = covariance(of_hand, later_s - t_i);
	}
	const Eigen::LLT<Eigen::MatrixXd> factor(seen);
	const Eigen::Map<const Eigen::VectorXd> values(x.data(), n);
	const double expected = shared.dot(factor.solve(values));
	CHECK(hand(hypothesis, later_s, filtered_s).value == test::near(expected).epsilon(1e-8));

	// The constant of the normal density is left out of the weight.
	const double log_determinant = 2.0 * factor.matrixLLT().diagonal().array().log().sum();
	const double evidence = -0.5 * values.dot(factor.solve(values)) - 0.5 * log_determinant;
	CHECK(hypothesis.log_weight == test::near(evidence).epsilon(1e-8));
}

TEST_CASE("a hypothesis that began nearby finds the drag's onset and duration, and says how the hand moves") {
	const test::Drag drag{ .onset_s = 0.5, .duration_s = 1.2, .amplitude_m = 1.0 };
	Alone alone(GestureHypothesis::resting(0.0).begun(Regime::SOUND, 0.55, 0.05, std::log(1.0), 0.3));
	double filtered_s = 0.5;
	for (int i = 0; i <= 100; ++i) {
		const double t_s = 0.5 + 0.009 * i;
		alone.predict(t_s, t_s - filtered_s);
		filtered_s = t_s;
		alone.absorb(t_s, drag.x_m(t_s), {});
	}
	const GestureHypothesis hypothesis = alone.get();
	for (const double ahead_s : { 0.0, 0.03, 0.06, 0.09, 0.12, 0.15 }) {
		CHECK(hand(hypothesis, filtered_s + ahead_s, filtered_s).value ==
				test::near(drag.x_m(filtered_s + ahead_s)).epsilon(0.02));
	}
	constexpr double STEP_S = 1e-5;
	const double at_s = filtered_s + 0.05;
	const auto before = hand(hypothesis, at_s - STEP_S, filtered_s), now = hand(hypothesis, at_s, filtered_s),
			   after = hand(hypothesis, at_s + STEP_S, filtered_s);
	CHECK(now.velocity == test::near((after.value - before.value) / (2.0 * STEP_S)).epsilon(1e-6));
	CHECK(now.acceleration == test::near((after.velocity - before.velocity) / (2.0 * STEP_S)).epsilon(1e-5));
}

TEST_CASE(
		"what is expected until the next frame, however late, is the weighted mean of the curves, to 1e-4") {
	constexpr double FILTERED_S = 1.0;
	HypothesisBank bank;
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	bank.start(rest);
	bank.weigh(HypothesisBank::AT_REST, -3.0);
	const auto began = [&](double onset_s, double duration_s) {
		GestureHypothesis h = rest.begun(Regime::SOUND, onset_s, 0.01, std::log(duration_s), 0.1);
		h.log_weight = -onset_s - duration_s;
		bank.add(h);
	};
	for (const double onset_s : { 0.55, 0.7, 0.85, 0.93 }) {
		for (const double duration_s : { 0.15, 0.4, 1.0 }) {
			began(onset_s, duration_s);
		}
	}
	GestureHypothesis free = GestureHypothesis::leaving(0.4, 1.5);
	free.log_weight = -1.0;
	bank.add(free);
	bank.prune(0.0, 0.0, 0.0);
	for (const double ahead_s : { 0.0, 0.01 }) {
		MotionOutlook outlook;
		outlook.look(bank, test::drag_curve(), FILTERED_S, ahead_s, FILTERED_S);
		for (int i = 0; i < 400; ++i) {
			const double t_s = FILTERED_S + ahead_s + 0.0007 * i;
			if (i >= 50 && i % 3 == 0) {
				outlook.go_on(test::drag_curve(), t_s);
			}
			double mean = 0.0, total = 0.0;
			for (std::size_t k = 0; k < bank.size(); ++k) {
				total += bank.weight(k);
				if (bank.regime(k) == Regime::FREE) {
					const double slowed_s =
							-std::expm1(-FREE_SLOWING_PER_S * (t_s - FILTERED_S)) / FREE_SLOWING_PER_S;
					mean += bank.weight(k) * (0.4 + 1.5 * slowed_s);
				} else if (bank.on_its_way(k)) {
					const auto [onset_s, rate_per_s, gain, shape] = bank.course(k);
					const double phase = (t_s - onset_s) * rate_per_s;
					const double elements = evaluate_onwards(test::drag_model(), phase).value;
					mean += bank.weight(k) * gain *
							(elements + shape * (minimum_jerk(phase).value - elements));
				}
			}
			CHECK(std::abs(outlook.at(test::drag_curve(), t_s).value - mean / total) < 1e-4);
		}
	}
}

TEST_CASE("an outlier moves little, and a frame that fits moves as without outliers") {
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	const auto moved = [&](double x, double outlier) {
		Alone alone(rest);
		alone.absorb(0.0, x, { .outlier = outlier });
		return hand(alone.get(), 0.0, 0.0).value;
	};
	CHECK(moved(0.5, 0.01) < 1e-6);
	CHECK(moved(0.5, 0.0) > 0.45);
	CHECK(moved(0.01, 0.01) == test::near(moved(0.01, 0.0)).epsilon(0.01));
}

TEST_CASE("a bank keeps the likeliest of each kind, and a share for those that may still turn out right") {
	HypothesisBank bank;
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	bank.start(rest);
	bank.weigh(HypothesisBank::AT_REST, -50.0);
	const auto began = [&](Regime regime, double log_weight) {
		GestureHypothesis h = rest.begun(regime, 0.0, 0.01, 0.0, 0.1);
		h.log_weight = log_weight;
		bank.add(h);
	};
	for (int i = 0; i < 24; ++i) {
		began(Regime::SOUND, -3.0 - 0.1 * i);
	}
	began(Regime::SOUND, -14.0);
	began(Regime::UNSOUND, -20.0);
	began(Regime::FREE, -25.0);
	bank.prune(0.0, 0.02, 0.002);

	double usual = 0.0, unsound = 0.0, free = 0.0, greatest = -1.0, least_sound = 0.0;
	for (std::size_t i = 1; i < bank.size(); ++i) {
		const Regime regime = bank.regime(i);
		const double weight = std::exp(bank.log_weight(i));
		greatest = std::max(greatest, weight);
		(regime == Regime::UNSOUND ? unsound : regime == Regime::FREE ? free : usual) += weight;
		if (regime == Regime::SOUND) {
			least_sound = std::min(least_sound, bank.log_weight(i));
		}
		CHECK(bank.weight(i) == test::near(weight));
	}
	CHECK(bank.size() == 1 + 20 + 1 + 1);
	CHECK(bank.regime(HypothesisBank::AT_REST) == Regime::REST);
	CHECK(greatest == test::near(1.0));
	CHECK(least_sound == test::near(-1.9));
	CHECK(unsound == test::near(0.02 * usual));
	CHECK(free == test::near(0.002 * (usual + unsound)));
}

TEST_CASE("a bank keeps no more than its effort says") {
	HypothesisBank bank({ .usual = 3, .erring = 2, .wandering = 1 });
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	bank.start(rest);
	for (int i = 0; i < 8; ++i) {
		for (const Regime regime : { Regime::SOUND, Regime::UNSOUND, Regime::FREE }) {
			GestureHypothesis h = rest.begun(regime, 0.0, 0.01, 0.0, 0.1);
			h.log_weight = -0.1 * i;
			bank.add(h);
		}
	}
	bank.prune(0.0, 0.0, 0.0);
	std::array<int, REGIMES> kept{};
	for (std::size_t i = 0; i < bank.size(); ++i) {
		++kept[static_cast<std::size_t>(bank.regime(i))];
		CHECK(bank.log_weight(i) > -0.25);
	}
	CHECK(kept == std::array{ 1, 3, 2, 1 });
}

TEST_CASE("of gestures that are over a bank keeps few") {
	constexpr double NOW_S = 2.0;
	for (const double onset_s : { 1.5, 0.5 }) {
		CAPTURE(onset_s);
		HypothesisBank bank;
		const GestureHypothesis rest = GestureHypothesis::resting(0.0);
		bank.start(rest);
		for (int i = 0; i < 20; ++i) {
			for (const Regime regime : { Regime::SOUND, Regime::UNSOUND, Regime::FREE }) {
				GestureHypothesis h = rest.begun(regime, onset_s, 0.01, 0.0, 0.1);
				h.log_weight = -0.01 * i;
				bank.add(h);
			}
		}
		bank.prune(NOW_S, 0.0, 0.0);
		std::array<int, REGIMES> kept{};
		for (std::size_t i = 0; i < bank.size(); ++i) {
			++kept[static_cast<std::size_t>(bank.regime(i))];
			CHECK(bank.log_weight(i) > -0.195);
		}
		CHECK(kept == (onset_s < 1.0 ? std::array{ 1, 4, 3, 2 } : std::array{ 1, 20, 16, 4 }));
	}
}

TEST_CASE("a hand that is on no way is never over") {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	for (int i = 0; i < 12; ++i) {
		bank.add(GestureHypothesis::leaving(0.1 * i, 0.0), -0.01 * i);
	}
	for (const double later_s : { 0.0, 5.0, 1000.0 }) {
		bank.prune(later_s, 0.0, 0.0);
		CHECK(bank.size() == 13);
		CHECK_FALSE(bank.is_over(1, later_s));
	}
}

TEST_CASE("what a bank calls hopeless, the next prune drops, and nothing else") {
	for (const double log_weight : { -0.5, -1.1, -1.95, -2.05, -3.0 }) {
		CAPTURE(log_weight);
		HypothesisBank bank({ .usual = 3, .erring = 2, .wandering = 1 });
		const GestureHypothesis rest = GestureHypothesis::resting(0.0);
		bank.start(rest);
		const auto add = [&](double duration, double its_log_weight) {
			GestureHypothesis h = rest.begun(Regime::SOUND, 0.0, 0.01, duration, 0.1);
			h.log_weight = its_log_weight;
			bank.add(h);
		};
		for (int i = 0; i < 5; ++i) {
			add(0.0, -0.5 * i);
		}
		bank.prune(0.0, 0.0, 0.0); // 0, -0.5 and -1 stay
		const bool is_hopeless = bank.is_hopeless(Regime::SOUND, log_weight);
		CHECK_FALSE(bank.is_hopeless(Regime::UNSOUND, log_weight));
		add(0.7, log_weight);
		bank.prune(0.0, 0.0, 0.0);
		bool is_kept = false;
		for (std::size_t i = 1; i < bank.size(); ++i) {
			is_kept = is_kept || bank.course(i).rate_per_s < 0.9;
		}
		CHECK(is_kept != is_hopeless);
	}
}

TEST_CASE(
		"the motion elements are joined: value and slope are continuous, at the joints and beyond the end") {
	constexpr double STEP = 1e-7;
	std::vector<double> joints{ 0.0 };
	for (const PrimitiveMotionElement &element : test::drag_model().elements) {
		joints.push_back(element.phase_end);
	}
	for (const double joint : joints) {
		CAPTURE(joint);
		const CurvePoint before = evaluate_onwards(test::drag_model(), joint - STEP),
						 after = evaluate_onwards(test::drag_model(), joint + STEP);
		CHECK(std::abs(after.value - before.value) < 1e-6);
		CHECK(std::abs(after.slope - before.slope) < 1e-4);
	}
	CHECK(evaluate_onwards(test::drag_model(), -1.0).value == 0.0);
	CHECK(evaluate_onwards(test::drag_model(), 1.0).value == test::near(1.0));
	CHECK(evaluate_onwards(test::drag_model(), 3.0).slope < 1e-12);
}
