// Steps that a tracker makes and no hand.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "soundness/tracker_steps.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

using namespace steadyhand;

namespace {

using Way = std::function<double(double t_s)>;

/// What passes of a way along x, seen at that rate; frames in lost_from_s .. lost_to_s are missing.
std::vector<TrackerSteps::Passed> passed(
		const Way &way, double rate_hz, double length_s, double lost_from_s = 1e9, double lost_to_s = 1e9) {
	TrackerSteps steps;
	std::vector<TrackerSteps::Passed> all;
	for (int i = 0; i < static_cast<int>(length_s * rate_hz); ++i) {
		const double t_s = i / rate_hz;
		if (t_s < lost_from_s || t_s >= lost_to_s) {
			for (const TrackerSteps::Passed &frame : steps.push(t_s, { way(t_s), 0.0, 0.0, 0.0 })) {
				all.push_back(frame);
			}
		}
	}
	return all;
}

/// Largest distance of what passes from the hand's own way, m.
double largest_error(const std::vector<TrackerSteps::Passed> &frames, const Way &way) {
	double largest = 0.0;
	for (const TrackerSteps::Passed &frame : frames) {
		largest = std::max(largest, std::abs(frame.place_m.x() - way(frame.t_s)));
	}
	return largest;
}

/// The quickest stroke that is studied: through a surface 15 cm away after 0.15 s.
const test::Drag QUICK{ .onset_s = 0.3, .duration_s = 0.2, .amplitude_m = 0.19 };
const test::Drag USUAL{ .onset_s = 0.3, .duration_s = 1.0, .amplitude_m = 0.2 };

} // namespace

TEST_CASE("the quickest hand makes no step, at any rate, seen throughout or not") {
	const Way quick = [](double t_s) { return QUICK.x_m(t_s); };
	for (const double rate_hz : { 30.0, 60.0, 80.0, 110.0, 240.0, 1000.0 }) {
		CAPTURE(rate_hz);
		CHECK(largest_error(passed(quick, rate_hz, 1.0), quick) == 0.0);
		for (const double lost_s : { 0.25, 0.32, 0.38, 0.44 }) {
			CAPTURE(lost_s);
			CHECK(largest_error(passed(quick, rate_hz, 1.0, lost_s, lost_s + 0.1), quick) == 0.0);
		}
	}
}

TEST_CASE("a hand shown beside where it is goes its own way all the same") {
	const Way hand = [](double t_s) { return USUAL.x_m(t_s); };
	for (const double step_m : { 0.01, 0.03, -0.06 }) {
		for (const double from_s : { 0.1, 0.5, 0.8, 1.2 }) {
			CAPTURE(step_m);
			CAPTURE(from_s);
			const auto shown = [&](double until_s) {
				return [&, until_s](double t_s) {
					return hand(t_s) + (t_s >= from_s && t_s < until_s ? step_m : 0.0);
				};
			};
			for (const double length_s : { 0.005, 0.03, 0.09, 9.0 }) {
				CHECK(largest_error(passed(shown(from_s + length_s), 110.0, 2.0), hand) < 0.0015);
			}
			// The step falls into a few missing frames.
			const std::vector<TrackerSteps::Passed> gaps =
					passed(shown(9.0), 110.0, 2.0, from_s - 0.02, from_s + 0.025);
			if (std::abs(step_m) > 0.02) {
				CHECK(largest_error(gaps, hand) < 0.004);
			}
		}
	}
}

TEST_CASE("a second step right after the first is another one") {
	const Way hand = [](double t_s) { return USUAL.x_m(t_s); };
	const Way shown = [&](double t_s) {
		const bool is_first = t_s > 0.6 && t_s < 0.6 + 1.0 / 110.0;
		return hand(t_s) + (is_first ? 0.04 : t_s > 0.6 && t_s < 0.7 ? -0.05 : 0.0);
	};
	CHECK(largest_error(passed(shown, 110.0, 2.0), hand) < 0.0015);
}

TEST_CASE(
		"a tracker that slides back after a step shows a hand where it rests, and one that moves less off") {
	const Way rest = [](double) { return 0.0; }, usual = [](double t_s) { return USUAL.x_m(t_s); };
	for (const double step_m : { -0.06, 0.06, 0.1 }) {
		for (const double time_constant_s : { 0.05, 0.08 }) {
			CAPTURE(step_m);
			CAPTURE(time_constant_s);
			const auto off_m = [&](const Way &hand) {
				const Way shown = [&](double t_s) {
					return hand(t_s) + (t_s < 0.55 ? 0.0 : step_m * std::exp((0.55 - t_s) / time_constant_s));
				};
				return largest_error(passed(shown, 110.0, 1.5), hand);
			};
			CHECK(off_m(rest) < 0.12 * std::abs(step_m));
			CHECK(off_m(usual) < 0.5 * std::abs(step_m));
		}
	}
}

TEST_CASE("a tracker that jumps back while it slides back shows the hand where it is") {
	for (const double step_m : { -0.06, 0.06, 0.1 }) {
		for (const double back_s : { 0.36, 0.4, 0.44, 0.5 }) {
			CAPTURE(step_m);
			CAPTURE(back_s);
			const Way rest = [](double) { return 0.0; };
			const Way shown = [&](double t_s) {
				const bool is_off = t_s > 0.3 && t_s < back_s;
				return is_off ? step_m * (0.5 + std::exp((0.3 - t_s) / 0.06)) : 0.0;
			};
			const std::vector<TrackerSteps::Passed> frames = passed(shown, 110.0, 1.5);
			CHECK(largest_error(frames, rest) < 0.12 * std::abs(step_m));
		}
	}
}

TEST_CASE("a hand that sets out back along a step goes its own way") {
	const Way hand = [](double t_s) { return -QUICK.x_m(t_s); };
	for (const double steps_s : { 0.2, 0.3, 0.35 }) {
		CAPTURE(steps_s);
		const auto frames =
				passed([&](double t_s) { return hand(t_s) + (t_s < steps_s ? 0.0 : 0.06); }, 110.0, 1.0);
		CHECK(largest_error(frames, hand) < 0.005);
	}
}

TEST_CASE("a track that begins beside the hand loses no more than its first frames' place") {
	const Way shown = [](double t_s) { return t_s < 0.08 ? 0.04 : USUAL.x_m(t_s); };
	const std::vector<TrackerSteps::Passed> frames = passed(shown, 110.0, 2.0);
	CHECK(frames.back().place_m.x() - frames.front().place_m.x() == test::near(0.2).epsilon(0.01));
}

TEST_CASE("a frozen tracker that catches up shows where the hand has gone") {
	for (const double frozen_s : { 0.1, 0.2, 0.3 }) {
		CAPTURE(frozen_s);
		const Way hand = [](double t_s) { return USUAL.x_m(t_s); };
		CHECK(largest_error(passed(hand, 110.0, 2.0, 0.7, 0.7 + frozen_s), hand) == 0.0);
	}
}

TEST_CASE("a tracker that trembles where it lost the hand, and catches up, shows where the hand has gone") {
	const std::vector<std::pair<double, double>> hands{ { 0.03, 0.4 }, { 0.03, 0.8 }, { 0.2, 0.4 },
		{ 0.2, 0.8 }, { 0.2, 1.5 } };
	for (const auto &[amplitude_m, duration_s] : hands) {
		const test::Drag drag{ .onset_s = 0.5, .duration_s = duration_s, .amplitude_m = amplitude_m };
		for (const double share : { 0.3, 0.4, 0.5, 0.6, 0.7 }) {
			for (const double lost_s : { 0.1, 0.2, 0.3 }) {
				CAPTURE(amplitude_m);
				CAPTURE(duration_s);
				CAPTURE(share);
				CAPTURE(lost_s);
				const double from_s = drag.onset_s + share * duration_s;
				std::mt19937_64 random(3);
				std::normal_distribution<double> noise(0.0, 2e-4);
				const Way shown = [&](double t_s) {
					const bool is_lost = t_s >= from_s && t_s < from_s + lost_s;
					return drag.x_m(is_lost ? from_s : t_s) + noise(random);
				};
				const double end_m = passed(shown, 100.0, 3.0).back().place_m.x();
				CHECK(std::abs(end_m - drag.amplitude_m) < 0.1 * drag.amplitude_m);
			}
		}
	}
}

TEST_CASE("a hand that came to rest, and that its tracker shows elsewhere soon after, is where it was") {
	for (const double duration_s : { 0.4, 0.8, 1.5 }) {
		const test::Drag drag{ .onset_s = 0.5, .duration_s = duration_s, .amplitude_m = 0.2 };
		for (const double rest_s : { 0.05, 0.1, 0.2, 0.3 }) {
			for (const double step_m : { -0.05, 0.03, 0.05, 0.1 }) {
				CAPTURE(duration_s);
				CAPTURE(rest_s);
				CAPTURE(step_m);
				const double from_s = drag.onset_s + duration_s + rest_s;
				std::mt19937_64 random(3);
				std::normal_distribution<double> noise(0.0, 2e-4);
				const Way shown = [&](double t_s) {
					return drag.x_m(t_s) + (t_s >= from_s ? step_m : 0.0) + noise(random);
				};
				CHECK(std::abs(passed(shown, 100.0, 3.0).back().place_m.x() - 0.2) < 0.005);
			}
		}
	}
}

TEST_CASE("a tracker that trembles makes no steps") {
	for (const double deviation_m : { 0.003, 0.01, 0.03 }) {
		CAPTURE(deviation_m);
		std::mt19937_64 random(7);
		std::normal_distribution<double> noise(0.0, deviation_m);
		TrackerSteps steps;
		FeaturePlace first_m = FeaturePlace::Zero(), last_m = first_m;
		for (int i = 0; i < 3000; ++i) {
			const FeaturePlace place{ noise(random), noise(random), noise(random), 0.0 };
			for (const TrackerSteps::Passed &frame : steps.push(i / 100.0, place)) {
				last_m = frame.seen_m - frame.place_m;
				first_m = i == 100 ? last_m : first_m; // it has learned by then how much it trembles
			}
		}
		CHECK((last_m - first_m).norm() < 3.0 * deviation_m);
	}
}

TEST_CASE("after a restart a track passes as the first one does, whatever was before") {
	const Way rest = [](double) { return 0.0; };
	const Way stepped = [](double t_s) { return t_s < 0.3 ? 0.0 : 0.05; };
	const Way steps_at_last = [](double t_s) { return t_s < 0.489 ? 0.0 : 0.05; };
	const Way slides = [](double t_s) { return t_s < 0.48 ? 0.0 : 0.1 * std::exp((0.48 - t_s) / 0.05); };
	const Way fast = [](double t_s) { return 1.5 * t_s; };
	const Way back = [](double t_s) { return 0.4 - USUAL.x_m(t_s + 0.4); };
	for (const Way &before : { rest, stepped, steps_at_last, slides, fast }) {
		for (const Way &after : { rest, fast, back }) {
			TrackerSteps steps, anew;
			const auto place = [](double x_m) { return FeaturePlace(x_m, 0.0, 0.0, 0.0); };
			for (int i = 0; i < 55; ++i) {
				steps.push(i / 110.0, place(before(i / 110.0)));
			}
			steps.restart();
			for (int i = 0; i < 55; ++i) {
				const double t_s = 0.51 + i / 110.0;
				const auto passing = steps.push(t_s, place(after(i / 110.0)));
				const auto expected = anew.push(t_s, place(after(i / 110.0)));
				REQUIRE(passing.size() == expected.size());
				for (std::size_t k = 0; k < passing.size(); ++k) {
					CHECK(passing[k].t_s == expected[k].t_s);
					CHECK(passing[k].place_m == expected[k].place_m);
				}
			}
		}
	}
}

TEST_CASE("a tracker that slid back in part only has stopped doing so when the hand sets out") {
	const test::Drag drag{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
	const Way shown = [&](double t_s) {
		const double off_m = t_s < 0.55 ? 0.0 : 0.04 + 0.06 * std::exp((0.55 - t_s) / 0.04);
		return off_m - drag.x_m(t_s);
	};
	const std::vector<TrackerSteps::Passed> frames = passed(shown, 110.0, 2.2);
	const auto at = [&](double t_s) {
		return std::find_if(frames.begin(), frames.end(),
				[t_s](const TrackerSteps::Passed &frame) { return frame.t_s >= t_s; });
	};
	CHECK(std::abs(at(0.95)->place_m.x()) < 0.01);
	CHECK(frames.back().place_m.x() - at(0.95)->place_m.x() == test::near(-0.2).epsilon(0.001));
}

TEST_CASE("a tracker that slides back takes back no more than its step, however far the hand has gone") {
	const test::Drag drag{ .onset_s = 0.6, .duration_s = 0.08, .amplitude_m = 0.03 };
	const Way hand = [&](double t_s) { return -drag.x_m(t_s); };
	const Way shown = [&](double t_s) {
		return hand(t_s) + (t_s < 0.55 ? 0.0 : 0.06 * std::exp((0.55 - t_s) / 0.05));
	};
	const std::vector<TrackerSteps::Passed> frames = passed(shown, 110.0, 1.5, 0.605, 0.68);
	CHECK(std::abs(frames.back().place_m.x() - hand(1.5)) < 0.01);
}

TEST_CASE("a fast hand loses nothing where its track begins, and no more than a single frame elsewhere") {
	const Way fast = [](double t_s) { return 1.5 * t_s; };
	CHECK(largest_error(passed(fast, 110.0, 0.5), fast) == 0.0);
	const Way shown = [&](double t_s) { return fast(t_s) + (t_s > 0.296 && t_s < 0.304 ? 0.04 : 0.0); };
	const std::vector<TrackerSteps::Passed> frames = passed(shown, 110.0, 0.5);
	CHECK(frames.size() == 54); // of 55
	CHECK(largest_error(frames, fast) == 0.0);
}

TEST_CASE("a hand that was shown at rest just now, and moves, has set out unseen if it is too fast for a "
		  "step") {
	struct Hand {
		double way_m, after_m_s;
		bool sets_out;
	};
	constexpr double RATE_HZ = 100.0, AT_S = 1.0;
	for (const Hand &hand : { Hand{ 0.1, 0.0, false }, { 0.1, 0.15, false }, { 0.1, 0.28, true },
				 { 0.3, 0.26, false }, { 0.3, 0.5, true }, { 0.05, 0.1, false }, { 0.05, 0.16, true } }) {
		CAPTURE(hand.way_m);
		CAPTURE(hand.after_m_s);
		TrackerSteps steps;
		double last_m = 0.0;
		for (int i = 0; i < static_cast<int>(1.2 * RATE_HZ); ++i) {
			const double t_s = i / RATE_HZ;
			const double x_m = t_s < AT_S ? 0.0 : hand.way_m + hand.after_m_s * (t_s - AT_S);
			const bool repeats = i > 0 && t_s < AT_S;
			const auto frames = repeats ? steps.stay(t_s, true)
										: steps.push(t_s, { x_m, 0.0, 0.0, 0.0 }, (i - 1) / RATE_HZ);
			for (const TrackerSteps::Passed &frame : frames) {
				last_m = frame.place_m.x();
			}
		}
		const double expected_m = 0.2 * hand.after_m_s + (hand.sets_out ? hand.way_m : 0.0);
		CHECK(std::abs(last_m - expected_m) < 0.02);
	}
}
