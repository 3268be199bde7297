// Hands that stop on their way, before trackers that are right and that have erred.

#include "follow.h"
#include "minimum_jerk_drag.h"
#include "signal/minimum_jerk.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

using namespace steadyhand;
using test::follow, test::PERIOD_S;

namespace {

/// Values in amplitudes.
struct Halt {
	double share; ///< of the way, at which the hand halts
	double first_s, rest_s, second_s;
};

struct Furthest {
	double off = 0.0;      ///< of the estimate from the hand, at any time
	double off_last = 0.0; ///< in the second after the hand has arrived
};

Furthest furthest(const Halt &halt, double rate_hz, double noise, unsigned seed = 2) {
	PhaseEstimator estimator(test::drag_model());
	const test::Drag first{ .onset_s = 0.8, .duration_s = halt.first_s, .amplitude_m = halt.share };
	const test::Drag second{ .onset_s = 0.8 + halt.first_s + halt.rest_s,
		.duration_s = halt.second_s,
		.amplitude_m = 1.0 - halt.share };
	const double end_s = second.onset_s + second.duration_s;
	std::mt19937_64 random(seed);
	std::normal_distribution<double> trembling(0.0, noise);
	Furthest furthest;
	const auto hand = [&](double t_s) { return first.x_m(t_s) + second.x_m(t_s); };
	const auto show = [&](double t_s) { return hand(t_s) + trembling(random); };
	const auto look = [&](double t_s, double value) {
		const double off = std::abs(value - hand(t_s));
		furthest.off = std::max(furthest.off, off);
		furthest.off_last = t_s > end_s + 0.2 ? std::max(furthest.off_last, off) : 0.0;
	};
	follow(estimator, end_s + 1.0, show, look, 1.0 / rate_hz);
	return furthest;
}

} // namespace

TEST_CASE("a hand that halts as fast as hands do is no tracker that has frozen") {
	for (const double rate_hz : { 60.0, 90.0, 110.0 }) {
		for (const double first_s : { 0.15, 0.2, 0.3 }) {
			for (const double share : { 0.3, 0.4, 0.5 }) {
				for (const double noise : { 2e-4, 1e-3 }) {
					CAPTURE(rate_hz);
					CAPTURE(first_s);
					CAPTURE(share);
					CAPTURE(noise);
					const Halt halt{ .share = share, .first_s = first_s, .rest_s = 0.6, .second_s = 0.5 };
					CHECK(furthest(halt, rate_hz, noise).off < 0.15);
				}
			}
		}
	}
}

TEST_CASE("nor before a slow camera, one or two frames of which see it brake") {
	int mistaken = 0;
	for (const double rate_hz : { 25.0, 30.0 }) {
		for (const double first_s : { 0.25, 0.3, 0.4 }) {
			for (unsigned seed = 0; seed < 20; ++seed) {
				const Halt halt{ .share = 0.35, .first_s = first_s, .rest_s = 0.6, .second_s = 0.5 };
				mistaken += furthest(halt, rate_hz, 0.005, seed).off > 0.2 ? 1 : 0;
			}
		}
	}
	CHECK(mistaken <= 2);
}

TEST_CASE("a hand that goes on after it has halted for long is followed, and not led, by a right tracker") {
	for (const double rate_hz : { 30.0, 90.0 }) {
		for (const double share : { 0.3, 0.5, 0.7 }) {
			for (const double rest_s : { 1.0, 2.0, 4.0 }) {
				for (const double second_s : { 0.4, 0.8 }) {
					CAPTURE(rate_hz);
					CAPTURE(share);
					CAPTURE(rest_s);
					CAPTURE(second_s);
					const Halt halt{ .share = share, .first_s = 0.5, .rest_s = rest_s, .second_s = second_s };
					CHECK(furthest(halt, rate_hz, 5e-4).off < 0.08);
				}
			}
		}
	}
}

TEST_CASE("a hand that halts before a tracker that repeats where it stands, to the last bit, stays there") {
	for (const double rate_hz : { 15.0, 30.0, 60.0, 100.0 }) {
		for (const double first_s : { 0.4, 0.8 }) {
			for (const double share : { 0.3, 0.5, 0.7 }) {
				CAPTURE(rate_hz);
				CAPTURE(first_s);
				CAPTURE(share);
				PhaseEstimator estimator(test::drag_model());
				const test::Drag drag{ .onset_s = 0.8, .duration_s = first_s, .amplitude_m = share };
				const double halted_s = drag.onset_s + first_s;
				double off = 0.0;
				const auto hand = [&](double t_s) { return drag.x_m(t_s); };
				const auto look = [&](double t_s, double value) {
					off = t_s > halted_s + 0.1 ? std::max(off, std::abs(value - share)) : 0.0;
				};
				follow(estimator, halted_s + 1.5, hand, look, 1.0 / rate_hz);
				CHECK(off < 0.06);
			}
		}
	}
}

TEST_CASE("a hand that went its way in two halves stays at its end") {
	for (const double rest_s : { 0.4, 0.6, 0.8, 1.2 }) {
		for (const double share : { 0.3, 0.5, 0.7 }) {
			CAPTURE(rest_s);
			CAPTURE(share);
			const Halt halt{ .share = share, .first_s = 0.31, .rest_s = rest_s, .second_s = 0.31 };
			CHECK(furthest(halt, 90.0, 5e-4).off_last < 0.06);
		}
	}
}

TEST_CASE("a hand that halted half-way is where it was while nothing is seen, and when it is seen again") {
	for (const bool freezes : { false, true }) {
		for (const double share : { 0.12, 0.3, 0.5, 0.7 }) {
			for (const double rest_s : { 0.03, 0.3, 0.6, 1.2 }) {
				for (const double unseen_s : { 0.05, 0.1, 0.3, 0.6 }) {
					CAPTURE(freezes);
					CAPTURE(share);
					CAPTURE(rest_s);
					CAPTURE(unseen_s);
					const test::Drag drag{ .onset_s = 0.5, .duration_s = 0.6, .amplitude_m = share };
					const double lost_s = drag.onset_s + drag.duration_s + rest_s,
								 found_s = lost_s + unseen_s;
					PhaseEstimator estimator(test::drag_model());
					std::mt19937_64 random(2);
					std::normal_distribution<double> trembling(0.0, 5e-4);
					double shown = 0.0, off = 0.0, off_again = 0.0;
					const auto show = [&](double t_s) -> std::optional<double> {
						const bool is_lost = t_s > lost_s && t_s < found_s;
						shown = is_lost ? shown : drag.x_m(t_s) + trembling(random);
						return is_lost && !freezes ? std::nullopt : std::optional(shown);
					};
					follow(estimator, found_s + 0.5, show, [&](double t_s, double value) {
						double &furthest = t_s < found_s ? off : off_again;
						furthest = t_s > lost_s ? std::max(furthest, std::abs(value - share)) : 0.0;
					});
					CHECK(off < 0.08);
					CHECK(off_again < 0.2);
				}
			}
		}
	}
}

TEST_CASE("a hand that halted unseen and goes on is followed to its end") {
	for (const double share : { 0.3, 0.5, 0.7 }) {
		for (const double unseen_s : { 0.1, 0.3 }) {
			CAPTURE(share);
			CAPTURE(unseen_s);
			const test::Drag first{ .onset_s = 0.5, .duration_s = 0.6, .amplitude_m = share };
			const test::Drag second{ .onset_s = 2.0, .duration_s = 0.6, .amplitude_m = 1.0 - share };
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(2);
			std::normal_distribution<double> trembling(0.0, 5e-4);
			double off = 0.0;
			const auto hand = [&](double t_s) { return first.x_m(t_s) + second.x_m(t_s); };
			const auto show = [&](double t_s) -> std::optional<double> {
				const bool is_seen = t_s < 2.0 - unseen_s || t_s > 2.0;
				return is_seen ? std::optional(hand(t_s) + trembling(random)) : std::nullopt;
			};
			follow(estimator, 3.15, show, [&](double t_s, double value) {
				off = t_s > 2.1 ? std::max(off, std::abs(value - hand(t_s))) : 0.0;
			});
			CHECK(off < 0.1);
		}
	}
}

TEST_CASE("a tracker that jumps and comes back takes no hand along that has halted") {
	constexpr double JUMPS_S = 1.6;
	for (const double share : { 0.3, 0.4, 0.5 }) {
		for (const double jump : { -0.1, 0.15, 0.25 }) {
			for (const int frames : { 1, 3, 10, 20 }) {
				CAPTURE(share);
				CAPTURE(jump);
				CAPTURE(frames);
				const double back_s = JUMPS_S + PERIOD_S * frames;
				const test::Drag drag{ .onset_s = 0.5, .duration_s = 0.6, .amplitude_m = share };
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(2);
				std::normal_distribution<double> trembling(0.0, 5e-4);
				double off = 0.0, off_afterwards = 0.0;
				const auto show = [&](double t_s) {
					const bool is_off = t_s > JUMPS_S && t_s < back_s;
					return drag.x_m(t_s) + trembling(random) + (is_off ? jump : 0.0);
				};
				follow(estimator, back_s + 0.5, show, [&](double t_s, double value) {
					const double now = std::abs(value - share);
					off = t_s > JUMPS_S ? std::max(off, now) : 0.0;
					off_afterwards = t_s > back_s + 0.1 ? std::max(off_afterwards, now) : 0.0;
				});
				CHECK(off < 1.1 * std::abs(jump));
				CHECK(off_afterwards < 0.1);
			}
		}
	}
}

TEST_CASE(
		"a tracker that showed a hand where it had halted, and jumps to the end, is believed within 50 ms") {
	for (const double goes_on_for_s : { 0.2, 0.3, 0.4 }) {
		for (const double noise : { 3e-4, 1e-3 }) {
			CAPTURE(goes_on_for_s);
			CAPTURE(noise);
			const test::Drag first{ .onset_s = 0.5, .duration_s = 0.6, .amplitude_m = 0.7 };
			const test::Drag second{ .onset_s = 1.4, .duration_s = goes_on_for_s, .amplitude_m = 0.3 };
			const double found_s = second.onset_s + goes_on_for_s;
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(2);
			std::normal_distribution<double> trembling(0.0, noise);
			double off = 0.0;
			const auto show = [&](double t_s) {
				return first.x_m(t_s) + (t_s < found_s ? 0.0 : second.x_m(t_s)) + trembling(random);
			};
			follow(estimator, found_s + 0.2, show, [&](double t_s, double value) {
				off = t_s > found_s + 0.05 ? std::max(off, std::abs(value - 1.0)) : 0.0;
			});
			CHECK(off < 0.15);
		}
	}
}

TEST_CASE("a hand that halts on its way after a fault stands where it is shown") {
	struct Fault {
		std::string name;
		double length_s;
		double off; ///< NAN: the tracker repeats itself
	};
	for (const Fault &fault : { Fault{ "jump", 0.05, 0.25 }, Fault{ "jump back", 0.05, -0.25 },
				 Fault{ "short freeze", 0.05, NAN }, Fault{ "freeze", 0.15, NAN } }) {
		for (const double share : { 0.3, 0.5, 0.6 }) {
			CAPTURE(fault.name);
			CAPTURE(share);
			const test::Drag drag{ .onset_s = 0.8, .duration_s = 0.3 + 0.6 * share, .amplitude_m = share };
			const double from_s = drag.onset_s + 0.5 * drag.duration_s,
						 halted_s = drag.onset_s + drag.duration_s;
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(1);
			std::normal_distribution<double> trembling(0.0, 1e-3);
			double shown = 0.0, off = 0.0;
			const auto show = [&](double t_s) {
				const bool errs = t_s > from_s && t_s < from_s + fault.length_s;
				if (!errs || !std::isnan(fault.off)) {
					shown = drag.x_m(t_s) + trembling(random) + (errs ? fault.off : 0.0);
				}
				return shown;
			};
			follow(estimator, halted_s + 1.0, show, [&](double t_s, double value) {
				off = t_s > halted_s + 0.6 ? std::max(off, std::abs(value - share)) : 0.0;
			});
			CHECK(off < 0.12);
		}
	}
}

TEST_CASE("a hand, or its tracker, that shifts a little at rest and stops at once is shown where it is") {
	for (const double rate_hz : { 72.0, 110.0 }) {
		for (const double shift : { 0.04, 0.08, 0.12, 0.14 }) {
			for (const double shifts_s : { 0.04, 0.06, 0.08, 0.12, 0.2 }) {
				for (const unsigned seed : { 1U, 2U, 3U }) {
					CAPTURE(rate_hz);
					CAPTURE(shift);
					CAPTURE(shifts_s);
					const test::Drag drag{ .onset_s = 0.8, .duration_s = shifts_s, .amplitude_m = shift };
					PhaseEstimator estimator(test::drag_model());
					std::mt19937_64 random(seed);
					std::normal_distribution<double> trembling(0.0, 1e-3);
					double off = 0.0;
					follow(
							estimator, drag.onset_s + shifts_s + 1.5,
							[&](double t_s) { return drag.x_m(t_s) + trembling(random); },
							[&](double t_s, double value) {
								off = std::max(off, std::abs(value - drag.x_m(t_s)));
							},
							1.0 / rate_hz);
					CHECK(off < 0.2);
				}
			}
		}
	}
}

TEST_CASE("a gesture has come as far as the hand that halts in it") {
	for (const double rate_hz : { 30.0, 60.0, 110.0 }) {
		for (const double first_s : { 0.2, 0.3, 0.5 }) {
			for (const double share : { 0.3, 0.5 }) {
				CAPTURE(rate_hz);
				CAPTURE(first_s);
				CAPTURE(share);
				const test::Drag drag{ .onset_s = 0.8, .duration_s = first_s, .amplitude_m = share };
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(1);
				std::normal_distribution<double> trembling(0.0, 5e-4);
				double off = 0.0;
				const auto look = [&](double t_s, double value) {
					const PhaseEstimate now = estimator.at(t_s);
					if (t_s > drag.onset_s + first_s + 0.15) {
						off = std::max(off, std::abs(now.phase + now.free_phase - minimum_jerk_share(value)));
					}
				};
				follow(
						estimator, drag.onset_s + first_s + 1.0,
						[&](double t_s) { return drag.x_m(t_s) + trembling(random); }, look, 1.0 / rate_hz);
				CHECK(off < 0.1);
			}
		}
	}
}
