#include "follow.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

using namespace steadyhand;

// Values in amplitudes, as the estimator has them.

namespace {

using test::follow, test::PERIOD_S;
constexpr test::Drag DRAG{ .onset_s = 0.5, .duration_s = 0.8, .amplitude_m = 1.0 };

/// A hand at rest before a sensor that trembles as all do.
class RestingHand {
public:
	PhaseEstimator estimator{ test::drag_model() };
	double t_s = 0.0;
	double furthest = 0.0; ///< that the estimate has been off 0

	void show(double displacement) {
		estimator.push(t_s, displacement + 1e-3 * normal_(random_));
		wait(PERIOD_S);
	}
	void wait(double for_s) {
		const double from_s = t_s;
		for (int ms = 0; ms < static_cast<int>(std::lround(1000.0 * for_s)); ++ms) {
			t_s = from_s + 0.001 * ms;
			furthest = std::max(furthest, std::abs(estimator.at(t_s).value));
		}
		t_s = from_s + for_s;
	}

private:
	std::mt19937_64 random_{ 8 };
	std::normal_distribution<double> normal_;
};

/// Of the estimate from a hand at rest, in the second from when its tracker errs.
struct Off {
	double meanwhile = 0.0;
	double afterwards = 0.0;
};
/// error: of the time since it begins, over when it has been so for over_s.
template <typename Error> Off furthest_off(bool at_end, double over_s, const Error &error) {
	constexpr double BEGINS_S = 2.3;
	PhaseEstimator estimator(test::drag_model());
	std::mt19937_64 random(8);
	std::normal_distribution<double> normal;
	Off off;
	const auto show = [&](double t_s) {
		return (at_end ? DRAG.x_m(t_s) : 0.0) + error(t_s - BEGINS_S) + 1e-3 * normal(random);
	};
	follow(estimator, 3.3, show, [&](double t_s, double value) {
		if (t_s > BEGINS_S) {
			double &furthest = t_s < BEGINS_S + over_s ? off.meanwhile : off.afterwards;
			furthest = std::max(furthest, std::abs(value - (at_end ? 1.0 : 0.0)));
		}
	});
	return off;
}

/// What is believed of a hand at until_s that a tracker saw, later and later, up to seen_s.
PhaseEstimate believed_of_late_tracker(bool knows_of_gap, double seen_s, double until_s) {
	constexpr double LAG_S = regime_numbers(Regime::UNSOUND).lag_s;
	PhaseEstimator estimator(test::drag_model());
	for (int i = 0; i * PERIOD_S < seen_s; ++i) {
		const double t_s = i * PERIOD_S;
		estimator.push(t_s, DRAG.x_m(t_s - LAG_S * DRAG.x_m(t_s)));
	}
	for (int i = 0; knows_of_gap && seen_s + 0.01 * i < until_s; ++i) {
		estimator.wait(seen_s + 0.01 * i);
	}
	return estimator.at(until_s);
}

} // namespace

TEST_CASE("a tracker that is always late is made up for where its latency is known") {
	constexpr double LATENCY_S = 0.03;
	const test::Drag drag{ .onset_s = 0.5, .duration_s = 1.0, .amplitude_m = 1.0 };
	const auto largest_error = [&](double known_s) {
		PhaseEstimator estimator(test::drag_model(), {}, known_s);
		double largest = 0.0;
		follow(
				estimator, 2.0, [&](double t_s) { return drag.x_m(t_s - LATENCY_S); },
				[&](double t_s, double value) {
					largest = std::max(largest, std::abs(value - drag.x_m(t_s)));
				});
		return largest;
	};
	const double late = 1.875 * LATENCY_S; // at the peak velocity of a minimum jerk
	CHECK(largest_error(0.0) == test::near(late).epsilon(0.3));
	CHECK(largest_error(LATENCY_S) < 0.4 * late);
}

TEST_CASE("a tracker that jumps away from a hand at rest, and back, moves it no further than it jumps") {
	for (const double jump : { -0.2, 0.05, 0.1, 0.2, 0.3 }) {
		for (const int frames : { 1, 3, 10 }) {
			CAPTURE(jump);
			CAPTURE(frames);
			RestingHand hand;
			for (int i = 0; i < 60; ++i) {
				hand.show(0.0);
			}
			for (int i = 0; i < frames; ++i) {
				hand.show(jump);
			}
			for (int i = 0; i < 60; ++i) {
				hand.show(0.0);
			}
			CHECK(hand.furthest < std::abs(jump));
			CHECK(std::abs(hand.estimator.at(hand.t_s).value) < 0.01);
		}
	}
}

TEST_CASE("a hand that was at rest before a displaced tracker is followed from there on") {
	constexpr double JUMP = 0.4, JUMPS_S = 0.1; // before DRAG by as much as that in seconds, too
	for (const int seed : { 1, 2, 3, 4, 5 }) {
		CAPTURE(seed);
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(static_cast<std::uint64_t>(seed));
		std::normal_distribution<double> normal;
		const auto show = [&](double t_s) {
			return DRAG.x_m(t_s) + (t_s < JUMPS_S ? 0.0 : JUMP) + 1e-3 * normal(random);
		};
		double sum = 0.0;
		int instants = 0;
		follow(estimator, DRAG.onset_s + DRAG.duration_s, show, [&](double t_s, double value) {
			sum += t_s > DRAG.onset_s ? std::abs(value - DRAG.x_m(t_s)) : 0.0;
			instants += t_s > DRAG.onset_s ? 1 : 0;
		});
		CHECK(sum / instants < 0.7 * JUMP);
	}
}

TEST_CASE("a tracker that jumps and slides back takes no hand along that is at rest") {
	for (const double jump : { -0.3, 0.3, 0.6 }) {
		for (const double time_constant_s : { 0.03, 0.05, 0.08 }) {
			for (const bool at_end : { false, true }) {
				CAPTURE(jump);
				CAPTURE(time_constant_s);
				CAPTURE(at_end);
				const auto off = furthest_off(at_end, 0.4, [&](double since_s) {
					return since_s < 0.0 ? 0.0 : jump * std::exp(-since_s / time_constant_s);
				});
				CHECK(off.meanwhile < (at_end ? 0.3 : 0.6) * std::abs(jump));
				CHECK(off.afterwards < 0.05);
			}
		}
	}
}

TEST_CASE("a bump of the tracker moves a hand at rest hardly further than it is high") {
	constexpr double BUMP = 0.2;
	for (const bool at_end : { false, true }) {
		for (const double bump_s : { 0.05, 0.1, 0.15, 0.2, 0.3, 0.4 }) {
			for (const double phase_s : { 0.0, 0.002, 0.004, 0.006, 0.008 }) { // of the frames
				CAPTURE(at_end);
				CAPTURE(bump_s);
				CAPTURE(phase_s);
				const auto off = furthest_off(at_end, bump_s + 0.2, [&](double since_s) {
					const double part = (since_s + phase_s) / bump_s;
					return part < 0.0 || part > 1.0 ? 0.0 : BUMP * std::sin(std::numbers::pi * part);
				});
				CHECK(off.meanwhile < 1.5 * BUMP);
				CHECK(off.afterwards < 0.05);
			}
		}
	}
}

TEST_CASE("a tracker that wanders off from a hand at rest and jumps back lets go of it within a fifth of a "
		  "second") {
	constexpr double WANDERS_S = 0.3;
	for (const double velocity_per_s : { -2.0, -1.0, 0.6, 1.0, 2.0 }) {
		for (const bool at_end : { false, true }) {
			CAPTURE(velocity_per_s);
			CAPTURE(at_end);
			const auto off = furthest_off(at_end, WANDERS_S + 0.2, [&](double since_s) {
				return since_s < 0.0 || since_s > WANDERS_S ? 0.0 : velocity_per_s * since_s;
			});
			CHECK(off.meanwhile < 1.5 * std::abs(velocity_per_s) * WANDERS_S);
			CHECK(off.afterwards < (at_end ? 0.15 : 0.1));
		}
	}
}

TEST_CASE(
		"a tracker that took a hand for one that stops, and finds it further on, is believed within 0.2 s") {
	for (const double lost_s : { 0.8, 0.9, 1.0 }) {
		CAPTURE(lost_s);
		constexpr double FOUND_S = 2.0;
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(8);
		std::normal_distribution<double> normal;
		double furthest = 0.0;
		const auto show = [&](double t_s) {
			const bool lost = t_s > lost_s && t_s < FOUND_S;
			return DRAG.x_m(lost ? lost_s : t_s) + 1e-3 * normal(random);
		};
		follow(estimator, FOUND_S + 1.0, show, [&](double t_s, double value) {
			furthest = t_s > FOUND_S + 0.2 ? std::max(furthest, std::abs(value - 1.0)) : furthest;
		});
		CHECK(furthest < 0.1);
	}
}

TEST_CASE("a hand that a tracker led away fast is found within 60 ms where the tracker jumps back") {
	for (const double velocity_per_s : { -2.0, 2.0, 3.0 }) {
		for (const double wanders_s : { 0.2, 0.4 }) {
			CAPTURE(velocity_per_s);
			CAPTURE(wanders_s);
			const auto off = furthest_off(true, wanders_s + 0.06, [&](double since_s) {
				return since_s < 0.0 || since_s > wanders_s ? 0.0 : velocity_per_s * since_s;
			});
			CHECK(off.afterwards < 0.05);
		}
	}
}

TEST_CASE(
		"a hand that set out while its tracker trembled where it had rested is found 30 ms after the jump") {
	for (const double duration_s : { 0.5, 0.8, 1.2 }) {
		for (const double found_at : { 0.5, 0.65, 0.8 }) {
			CAPTURE(duration_s);
			CAPTURE(found_at);
			const test::Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 1.0 };
			const double found_s = drag.onset_s + found_at * duration_s;
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(8);
			std::normal_distribution<double> normal;
			double furthest = 0.0;
			const auto show = [&](double t_s) {
				return (t_s < found_s ? 0.0 : drag.x_m(t_s)) + 1e-3 * normal(random);
			};
			follow(estimator, found_s + 0.25, show, [&](double t_s, double value) {
				furthest = t_s > found_s + 0.03 ? std::max(furthest, std::abs(value - drag.x_m(t_s))) : 0.0;
			});
			CHECK(furthest < 0.25);
		}
	}
}

TEST_CASE("a freeze does not move a hand that rests beside the end of its way") {
	for (const double amplitude : { 0.85, 1.15 }) {
		for (const double lost_s : { 0.05, 0.1, 0.2 }) {
			CAPTURE(amplitude);
			CAPTURE(lost_s);
			constexpr double FREEZES_S = 2.5;
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(8);
			std::normal_distribution<double> normal;
			double shown = 0.0;
			const auto show = [&](double t_s) {
				const bool frozen = t_s > FREEZES_S && t_s < FREEZES_S + lost_s;
				shown = frozen ? shown : amplitude * DRAG.x_m(t_s) + 1e-3 * normal(random);
				return shown;
			};
			follow(estimator, FREEZES_S + 1.0, show, [&](double t_s, double value) {
				if (t_s > FREEZES_S - 0.1) {
					CHECK(std::abs(value - amplitude) < 0.03);
				}
			});
		}
	}
}

TEST_CASE("nothing begins while nothing is seen, but what may have begun just before") {
	for (const double lost_s : { 0.1, 0.5, 2.0, 20.0 }) {
		CAPTURE(lost_s);
		RestingHand hand;
		for (int i = 0; i < 60; ++i) {
			hand.show(0.0);
		}
		hand.wait(lost_s);
		CHECK(hand.furthest < 0.2); // the probability that it had
		for (int i = 0; i < 20; ++i) {
			hand.show(0.0);
		}
		CHECK(std::abs(hand.estimator.at(hand.t_s).value) < 0.01);
	}
}

TEST_CASE("a tracker that stops telling is taken for one that errs, before it tells again") {
	for (const auto &[seen_s, share] : { std::pair{ 0.8, 0.65 }, { 0.85, 0.6 }, { 0.9, 0.6 } }) {
		CAPTURE(seen_s);
		const double until_s = seen_s + 0.15, truth = DRAG.x_m(until_s);
		const double error = truth - believed_of_late_tracker(true, seen_s, until_s).value;
		const double error_unaware = truth - believed_of_late_tracker(false, seen_s, until_s).value;
		CHECK(error_unaware > 0.05); // late, as the tracker is
		CHECK(std::abs(error) < share * error_unaware);
	}
}

TEST_CASE("a gap speaks for a hand that has begun by half a nat, however long it is") {
	int undecided = 0;
	for (int frames = 55; frames < 78; ++frames) {
		CAPTURE(frames);
		PhaseEstimator estimator(test::drag_model());
		const double last_s = PERIOD_S * (frames - 1);
		for (int i = 0; i < frames; ++i) {
			estimator.push(i * PERIOD_S, DRAG.x_m(i * PERIOD_S));
		}
		const double begun = estimator.at(last_s).moving;
		undecided += begun > 0.1 && begun < 0.9 ? 1 : 0;
		for (int i = 0; i < 20; ++i) {
			estimator.wait(last_s + 0.01 * i);
		}
		const double odds = begun / (1.0 - begun) * std::exp(0.5);
		CHECK(estimator.at(last_s + 0.2).moving == test::near(odds / (1.0 + odds)).epsilon(0.02));
	}
	CHECK(undecided > 3);
}

TEST_CASE("phase mode follows a hand through a freeze that trembles as through one that does not") {
	constexpr double LOST_S = 0.75, FOUND_S = 0.95;
	const auto largest_error = [&](double tremble) {
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(4);
		std::normal_distribution<double> normal;
		double largest = 0.0;
		for (int i = 0; i * PERIOD_S < FOUND_S; ++i) {
			const double t_s = i * PERIOD_S;
			estimator.push(t_s, DRAG.x_m(std::min(t_s, LOST_S)) + tremble * normal(random));
			largest = std::max(largest, std::abs(estimator.at(t_s).value - DRAG.x_m(t_s)));
		}
		return largest;
	};
	const double exact = largest_error(0.0);
	CHECK(exact < 0.2 * (DRAG.x_m(FOUND_S) - DRAG.x_m(LOST_S)));
	for (const double tremble : { 0.0001, 0.001 }) {
		CHECK(std::abs(largest_error(tremble) - exact) < 0.006);
	}
}

TEST_CASE("a tracker that takes another hand for this one, and is back, leads the motion by less than that") {
	for (const double beside : { -1.5, -1.0, 1.3, 1.5 }) {
		for (const double for_s : { 0.1, 0.15, 0.25 }) {
			for (const double from_s : { 0.3, 1.0, 1.2 }) { // at rest, as it sets out, half-way
				CAPTURE(beside);
				CAPTURE(for_s);
				CAPTURE(from_s);
				const test::Drag drag{ .onset_s = 0.9, .duration_s = 0.7, .amplitude_m = 1.0 };
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(1);
				std::normal_distribution<double> trembling(0.0, 1e-3);
				double squared = 0.0;
				int count = 0;
				follow(
						estimator, 2.2,
						[&](double t_s) {
							const bool is_other = t_s > from_s && t_s < from_s + for_s;
							return drag.x_m(t_s) + trembling(random) + (is_other ? beside : 0.0);
						},
						[&](double t_s, double value) {
							if (t_s > from_s && t_s < from_s + for_s + 0.2) {
								squared += std::pow(value - drag.x_m(t_s), 2);
								++count;
							}
						});
				CHECK(std::sqrt(squared / count) < 0.25 * std::abs(beside));
			}
		}
	}
}
