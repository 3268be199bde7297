#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

// With nothing given: what comes after a gesture, or what of it is the tracker's, and when one that was begun
// is let go. Each from both sides.

TEST_CASE("a gesture that comes again soon after its way back needs no rest, a later one does") {
	for (const double since_way_back_s : { 0.6, 0.7, 1.3, 1.4 }) {
		CAPTURE(since_way_back_s);
		const Drag back{ .onset_s = 2.1, .duration_s = 0.5, .amplitude_m = -0.2 };
		const double again_s = 2.35 + since_way_back_s;
		const Drag again{ .onset_s = again_s, .duration_s = 0.8, .amplitude_m = 0.2 };
		// It comes from 12 cm away, where no gesture leads, and sets out at once.
		const Drag away{ .onset_s = again_s - 0.5, .duration_s = 0.25, .amplitude_m = 0.12 };
		const Drag near{ .onset_s = again_s - 0.25, .duration_s = 0.25, .amplitude_m = -0.12 };
		const Eigen::Vector3d aside = (Y + Z).normalized();
		const Way way = [&](double t_s) {
			return Eigen::Vector3d(x_m({ DRAG, back, again }, t_s) * X + x_m({ away, near }, t_s) * aside);
		};
		CHECK(in_the_open(way, again_s + 2.0).said == times(since_way_back_s < 1.0 ? 2 : 1, "sideways"));
	}
}

TEST_CASE("a row of taps needs one rest before it, a short one where the hand has been seen for long") {
	const auto told = [](double first_s, const Drag &comes) {
		std::vector<Drag> taps;
		for (int i = 0; i < 4; ++i) {
			const double down_s = first_s + 0.7 * i;
			taps.push_back({ .onset_s = down_s, .duration_s = 0.3, .amplitude_m = 0.2 });
			taps.push_back({ .onset_s = down_s + 0.32, .duration_s = 0.3, .amplitude_m = -0.2 });
		}
		const Way way = [&](double t_s) {
			return Eigen::Vector3d(comes.x_m(t_s) * (X + Y).normalized() - x_m(taps, t_s) * Z);
		};
		return in_the_open(way, first_s + 4 * 0.7 + 0.5).said;
	};
	for (const double seen_s : { 0.3, 0.4, 1.0 }) {
		CAPTURE(seen_s);
		CHECK(told(seen_s, { .amplitude_m = 0.0 }) == times(4, "push"));
	}
	for (const double rests_s : { 0.1, 0.15, 0.2 }) {
		CAPTURE(rests_s);
		const Drag comes{ .onset_s = 1.5, .duration_s = 0.5, .amplitude_m = 0.06 };
		CHECK(told(2.0 + rests_s, comes) == times(4, "push"));
	}
}

TEST_CASE("what little follows a gesture's end is the tracker's error, a long way aside is the hand's own") {
	struct Tail {
		double angle, amplitudes;
	};
	for (const auto &[angle, amplitudes] :
			{ Tail{ 0.3, 0.1 }, { 0.3, 0.18 }, { 0.15, 0.33 }, { 0.3, 0.38 } }) {
		CAPTURE(amplitudes);
		const Eigen::Vector3d oblique(std::cos(angle), std::sin(angle), 0.0);
		const Eigen::Vector3d aside(-std::sin(angle), std::cos(angle), 0.0);
		// Too fast for a hand that has stopped. In `paper` mode: in `phase` mode it has arrived before.
		const Way way = [&](double t_s) {
			const double off_m = std::clamp(0.13 * (t_s - 1.4), 0.0, amplitudes * DRAG.amplitude_m);
			return Eigen::Vector3d(DRAG.x_m(t_s) * oblique + off_m * aside);
		};
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PAPER);
		CHECK(none_ends(watch(recogniser, way, 3.5)) == (amplitudes > 0.25));
	}
}

TEST_CASE("an end is foretold where the gesture is rather likely, and awaited where it is doubtful") {
	// Slow and far: its stroke ends 0.05 s after it has a quarter of its peak speed, of which little is left.
	const Drag far{ .onset_s = 0.6, .duration_s = 1.5, .amplitude_m = 0.4 };
	int likely = 0, doubtful = 0;
	for (int i = 0; i < 25; ++i) {
		const double angle = 0.42 + 0.0025 * i;
		CAPTURE(angle);
		const Eigen::Vector3d oblique(std::cos(angle), 0.0, std::sin(angle));
		const Events events = in_the_open(along(oblique, { far }), 2.5);
		if (events.said != times(1, "sideways")) {
			continue;
		}
		const double log_odds = std::log(events.last_confidence / (1.0 - events.last_confidence));
		const bool is_foretold = events.last_ended_s < far.onset_s + 0.865 * far.duration_s;
		if (log_odds > 2.0) {
			CHECK(is_foretold);
			++likely;
		} else if (log_odds < 1.0) {
			CHECK_FALSE(is_foretold);
			++doubtful;
		}
	}
	CHECK(likely > 3);
	CHECK(doubtful > 0);
}

TEST_CASE("a hand that turns off half-way is let go at once, and not only after it has rested") {
	// At a right angle, half-way; a gesture that halts there is waited for instead.
	constexpr double TURNS_S = 0.6 + 0.36; // a quarter of twice the way: 10 s^3 - 15 s^4 + 6 s^5 = 0.25
	const Way way = [](double t_s) {
		const double gone_m = 2.0 * DRAG.x_m(t_s);
		return Eigen::Vector3d(std::min(gone_m, 0.1), 0.0, std::max(gone_m - 0.1, 0.0));
	};
	const std::vector<std::string> let_go{ "started sideways", "aborted sideways" };
	CHECK(in_the_open(way, TURNS_S + 0.4).said == let_go);
	const Way halts = [&](double t_s) { return way(std::min(t_s, TURNS_S)); };
	CHECK(in_the_open(halts, TURNS_S + 0.4).said == std::vector<std::string>{ "started sideways" });
}

TEST_CASE("from one gesture's motion to the next one's it takes a tenth of a second, without a step") {
	const Drag next{ .onset_s = 2.0, .duration_s = 0.5, .amplitude_m = 0.1 };
	const Way way = [&](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s) * X + next.x_m(t_s) * Y); };
	const auto until = [&](double length_s) { return in_the_open(way, length_s); };
	double switched_s = next.onset_s;
	while (switched_s < 2.5 && until(switched_s).said.back() != "started upright") {
		switched_s += 0.01;
	}
	REQUIRE(switched_s < 2.5);
	// Of the 20 cm that the first one was at.
	CHECK(std::abs(until(switched_s + 0.03).last_value_m - next.x_m(switched_s + 0.03)) > 0.03);
	const Events later = until(switched_s + 0.11);
	CHECK(std::abs(later.last_value_m - next.x_m(switched_s + 0.11)) < 0.02);
	CHECK(later.largest_step < 1.2 * FASTEST_M_MS);
}

TEST_CASE("what was given up is not begun again at a hand that rests") {
	for (const double far : { 0.17, 0.22, 0.3 }) {
		for (const double each_way_s : { 0.3, 0.6 }) {
			CAPTURE(far);
			CAPTURE(each_way_s);
			const Drag there{ .onset_s = 0.6, .duration_s = each_way_s, .amplitude_m = far * 0.2 };
			const Drag back{
				.onset_s = 0.6 + each_way_s, .duration_s = each_way_s, .amplitude_m = -far * 0.2
			};
			const Events events = in_the_open(along(X, { there, back }), 6.0);
			CHECK(std::ranges::count(events.said, "started sideways") <= 1);
			CHECK(none_ends(events));
		}
	}
}

TEST_CASE("a gesture that another one took the lead from shows its end no longer") {
	// To the right, and then a way that leads nowhere, but first upward, as another gesture does.
	const Drag up{ .onset_s = 2.2, .duration_s = 0.5, .amplitude_m = 0.08 };
	const Drag aside{ .onset_s = 2.5, .duration_s = 0.6, .amplitude_m = 0.3 };
	GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
	double none_since_s = 0.0, furthest_m = 0.0;
	int taken_over = 0;
	for (int i = 0; i < 600; ++i) {
		HandFrame frame;
		frame.t_s = 0.01 * i;
		const double t_s = frame.t_s, shaking_m = 1e-4 * std::sin(3.0 * i);
		frame.set(Joint::INDEX,
				(DRAG.x_m(t_s) + shaking_m) * X + up.x_m(t_s) * Y + aside.x_m(t_s) * (X - Z).normalized());
		recogniser.push(frame);
		none_since_s = recogniser.gesture() >= 0 ? t_s : none_since_s;
		taken_over += recogniser.gesture() == 1 ? 1 : 0;
		if (t_s > none_since_s + 0.2) { // it fades
			furthest_m = std::max(furthest_m, std::abs(recogniser.motion(MotionSource::SYNTHESISED).value_m));
		}
	}
	CHECK(taken_over > 0);
	CHECK(furthest_m < 0.01);
}

TEST_CASE("a hand that halts half-way is let go a second after it stopped, and its way back is none") {
	for (const double rests_s : { 0.85, 1.4 }) {
		CAPTURE(rests_s);
		const Drag there{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.08 };
		const Drag on{ .onset_s = 1.1 + rests_s, .duration_s = 0.6, .amplitude_m = 0.12 };
		const Events events = in_the_open(along(X, { there, on }), on.onset_s);
		CHECK(std::ranges::count(events.said, "aborted sideways") == (rests_s > 1.0 ? 1 : 0));
		CHECK(std::abs(events.last_value_m) < (rests_s > 1.0 ? 0.005 : 0.1));
	}
	const Drag there{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.08 };
	const Drag back{ .onset_s = 2.7, .duration_s = 0.5, .amplitude_m = -0.08 };
	const Events events = in_the_open(along(X, { there, back }), 4.6);
	CHECK(none_ends(events));
	CHECK(std::abs(events.last_value_m) < 0.005);
}

TEST_CASE("the way back after a slow gesture is none, soon after the hand has come to a stand") {
	for (const double duration_s : { 1.0, 2.0, 4.0 }) {
		for (const double far_m : { 0.2, 0.25 }) { // told before it ends, where it goes further than most
			CAPTURE(duration_s);
			CAPTURE(far_m);
			const Drag there{ .onset_s = 0.9, .duration_s = duration_s, .amplitude_m = far_m };
			const auto back = [&](double rests_s) {
				const double onset_s = 0.9 + duration_s + rests_s;
				return Drag{ .onset_s = onset_s, .duration_s = 0.9, .amplitude_m = -far_m };
			};
			const auto said = [&](double rests_s) {
				return in_the_open(along(X, { there, back(rests_s) }), 3.5 + duration_s + rests_s).said;
			};
			CHECK(said(0.5) == times(1, "sideways"));
			CHECK(said(1.6) == times(2, "sideways"));
		}
	}
}

TEST_CASE("a tracker that shows the hand elsewhere for a moment at the end does not take the end back") {
	for (const double back_m : { 0.05, 0.1, 0.15 }) {
		for (const double shown_s : { 0.005, 0.03, 0.1 }) { // one frame, three, eleven
			for (const double from_s : { 1.6, 1.8 }) {
				CAPTURE(back_m);
				CAPTURE(shown_s);
				CAPTURE(from_s);
				const Way way = [=](double t_s) {
					const bool is_paused = t_s >= from_s && t_s < from_s + shown_s;
					return Eigen::Vector3d((DRAG.x_m(t_s) - (is_paused ? back_m : 0.0)) * X);
				};
				const Events events = in_the_open(way, from_s + shown_s + 0.3);
				CHECK(events.said == times(1, "sideways"));
				CHECK(std::abs(events.last_value_m - 0.2) < 0.01);
			}
		}
	}
}

TEST_CASE("nor do single frames elsewhere, before and behind, where the hand rests to the last bit") {
	for (const double from_s : { 1.9, 2.0, 2.1, 2.2, 2.3 }) {
		CAPTURE(from_s);
		const Way way = [=](double t_s) {
			const bool is_before = t_s >= 1.7 && t_s < 1.709,
					   is_behind = t_s >= from_s && t_s < from_s + 0.009;
			const double off_m = is_before ? 0.1 : is_behind ? -0.08 : 0.0;
			return Eigen::Vector3d((DRAG.x_m(t_s) + off_m) * X);
		};
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
		const Events events = watch(recogniser, way, from_s + 0.3, 1e9, 1e9, 110.0, 0.0);
		CHECK(events.said == times(1, "sideways"));
		CHECK(std::abs(events.last_value_m - 0.2) < 0.01);
	}
}

TEST_CASE("after a second of rest the way back is a gesture, however a tracker wanders meanwhile") {
	const Drag there{ .onset_s = 1.0, .duration_s = 0.8, .amplitude_m = 0.2 };
	for (const double rests_s : { 0.5, 1.6, 2.5 }) {
		for (const double wanders_m : { 0.0, 0.008, 0.013 }) {
			for (const double phase : { 0.0, 1.5, 3.0, 4.5 }) {
				CAPTURE(rests_s);
				CAPTURE(wanders_m);
				CAPTURE(phase);
				const Drag back{ .onset_s = 1.8 + rests_s, .duration_s = 0.8, .amplitude_m = -0.2 };
				const Way way = [=](double t_s) {
					const double wander_m = wanders_m * std::sin(5.0 * t_s + phase);
					return Eigen::Vector3d((x_m({ there, back }, t_s) + wander_m) * X);
				};
				const Events events = in_the_open(way, 4.0 + rests_s);
				CHECK(std::ranges::count(events.said, "ended sideways") == (rests_s > 1.0 ? 2 : 1));
			}
		}
	}
}

TEST_CASE("a hand that goes on from the end after a second makes another gesture, however the tracker "
		  "wanders") {
	constexpr double WANDERS_M = 0.007;
	for (const double rests_s : { 1.5, 2.0, 2.9, 3.0 }) {
		for (const double wanders_rad_s : { 0.0, 2.0, 3.0 }) {
			CAPTURE(rests_s);
			CAPTURE(wanders_rad_s);
			const Drag on{ .onset_s = DRAG.onset_s + DRAG.duration_s + rests_s,
				.duration_s = 1.0,
				.amplitude_m = DRAG.amplitude_m };
			const Way way = [&](double t_s) {
				const double wanders_m = WANDERS_M * std::sin(wanders_rad_s * t_s);
				return Eigen::Vector3d((x_m({ DRAG, on }, t_s) + wanders_m) * X + wanders_m * Y);
			};
			CHECK(in_the_open(way, on.onset_s + 1.5).said == times(2, "sideways"));
		}
	}
}

TEST_CASE("a hand that goes further than the model is shown where it is, also where its tracker has erred") {
	for (const double length_m : { 0.26, 0.28 }) {
		for (const double frozen_s : { 0.15, 0.2, 0.25 }) {
			for (const double share : { 0.4, 0.5, 0.6 }) {
				CAPTURE(length_m);
				CAPTURE(frozen_s);
				CAPTURE(share);
				const Drag drag{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = length_m };
				const double from_s = drag.onset_s + share * drag.duration_s;
				const Events events = in_the_open(held(along(X, { drag }), from_s, from_s + frozen_s), 2.0);
				CHECK(events.said == times(1, "sideways"));
				CHECK(std::abs(events.last_value_m - length_m) < 0.01);
			}
		}
	}
}
