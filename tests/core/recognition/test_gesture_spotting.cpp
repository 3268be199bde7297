// Start, end and abort of gestures, with the task known and with nothing known; motion that is none.

#include "gesture_events.h"
#include "near.h"
#include "simulation/synthetic_trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("with nothing given each gesture is found, whichever way it goes") {
	CHECK(in_the_open(along(X, { DRAG }), 2.5).said == times(1, "sideways"));
	CHECK(in_the_open(along(-X, { DRAG }), 2.5).said == times(1, "sideways"));
	CHECK(in_the_open(along(Y, { DRAG }), 2.5).said == times(1, "upright"));
	CHECK(in_the_open(along(-Y, { DRAG }), 2.5).said == times(1, "upright"));
	CHECK(in_the_open(along(-Z, { DRAG }), 2.5).said == times(1, "push"));
	CHECK(in_the_open(along(Z, { DRAG }), 2.5).said.empty());           // a push goes one way
	const Eigen::Vector3d oblique(std::cos(0.35), 0.0, std::sin(0.35)); // 20 degrees off
	CHECK(in_the_open(along(oblique, { DRAG }), 2.5).said == times(1, "sideways"));
	for (const double size : { 0.7, 1.5 }) {
		const Drag other{ .onset_s = 0.6, .duration_s = 0.7, .amplitude_m = 0.2 * size };
		CHECK(in_the_open(along(X, { other }), 2.5).said == times(1, "sideways"));
	}
}

TEST_CASE("with nothing given the motion is the way along the hand's own direction, as far as it goes") {
	for (const double angle : { 0.0, 0.2, 0.35 }) {
		for (const double amplitude_m : { 0.15, 0.2, 0.35 }) {
			CAPTURE(angle);
			CAPTURE(amplitude_m);
			const Drag drag{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = amplitude_m };
			const Eigen::Vector3d axis(std::cos(angle), std::sin(angle), 0.0);
			for (const double sense : { 1.0, -1.0 }) {
				const Events events = in_the_open(along(sense * axis, { drag }), 2.2);
				CHECK(events.last_value_m == near(amplitude_m).epsilon(0.02));
				// A third of the way is gone at 0.4 s.
				CHECK(events.first_shown_s < drag.onset_s + 0.4);
			}
		}
	}
}

TEST_CASE("with nothing given the motion counts from where the hand set out, before its stroke was told") {
	for (const double duration_s : { 0.3, 0.5, 0.8 }) {
		CAPTURE(duration_s);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		const double until_s = drag.onset_s + duration_s + 0.6;
		CHECK(in_the_open(along(X, { drag }), until_s).last_value_m == near(0.2).epsilon(0.004));
	}
}

TEST_CASE("with nothing given what a hand creeps forward right before it sets out is part of the motion") {
	for (const double creeps_s : { 0.08, 0.1, 0.12, 0.15 }) {
		CAPTURE(creeps_s);
		const Drag creep{ .onset_s = 0.6, .duration_s = creeps_s, .amplitude_m = 0.006 };
		const Drag drag{ .onset_s = 0.55 + creeps_s, .duration_s = 0.5, .amplitude_m = 0.194 };
		CHECK(in_the_open(along(X, { creep, drag }), 2.0).last_value_m == near(0.2).epsilon(0.0025));
	}
}

TEST_CASE(
		"with nothing given a hand that draws back right before it sets out does so from the furthest back") {
	for (const double rate_hz : { 90.0, 110.0 }) {
		for (const double back_m : { 0.01, 0.015 }) {
			for (const double onset_s : { 0.6, 0.603, 0.606 }) {
				CAPTURE(rate_hz);
				CAPTURE(back_m);
				CAPTURE(onset_s);
				const Drag back{ .onset_s = onset_s, .duration_s = 0.12, .amplitude_m = -back_m };
				const Drag drag{ .onset_s = onset_s + 0.12, .duration_s = 0.5, .amplitude_m = 0.2 + back_m };
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				const Events events = watch(recogniser, along(X, { back, drag }), 2.2, 1e9, 1e9, rate_hz);
				CHECK((events.last_value_m - 0.2) / back_m > 0.91);
				CHECK((events.last_value_m - 0.2) / back_m < 1.05);
			}
		}
	}
}

TEST_CASE("with nothing given a tracker that trembles by 2 mm does not take a start for further back than it "
		  "is") {
	for (const double rate_hz : { 60.0, 72.0 }) {
		CAPTURE(rate_hz);
		constexpr unsigned HANDS = 24;
		constexpr double NOISE_M = 2e-3;
		double mean_m = 0.0;
		for (unsigned seed = 0; seed < HANDS; ++seed) {
			std::mt19937_64 random(seed);
			std::normal_distribution<double> trembling(0.0, NOISE_M);
			const Way way = [&](double t_s) {
				const double x_m = trembling(random), y_m = trembling(random), z_m = trembling(random);
				return Eigen::Vector3d(DRAG.x_m(t_s) + x_m, y_m, z_m);
			};
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Events events = watch(recogniser, way, 2.2, 1e9, 1e9, rate_hz, 0.0);
			REQUIRE(events.said == times(1, "sideways"));
			mean_m += events.last_value_m / HANDS;
		}
		CHECK(mean_m < DRAG.amplitude_m + 0.25 * NOISE_M);
		CHECK(mean_m > DRAG.amplitude_m - NOISE_M);
	}
}

TEST_CASE("what the tracker jumped by before a gesture is no part of it") {
	const Way jumped = [](double t_s) {
		return Eigen::Vector3d(DRAG.x_m(t_s) + (t_s < 0.3 ? 0.0 : 0.04), 0.0, 0.0);
	};
	const Events events = in_the_open(jumped, 2.2);
	CHECK(events.said == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.2).epsilon(0.02));
}

TEST_CASE("with nothing given a gesture that ends in full motion ends there, and not where the hand stops") {
	// A contact at four fifths of the way, passed after 0.6734 of the time: 10 s^3 - 15 s^4 + 6 s^5 = 0.8.
	constexpr double CONTACT = 0.6734;
	std::vector<TrainingRecording> recordings = drag_recordings();
	for (TrainingRecording &recording : recordings) {
		const double duration_s = recording.end_s - 0.5;
		recording.end_s = 0.5 + CONTACT * duration_s;
		recording.task.amplitude_m = 0.8 * 0.2;
	}
	const auto contact = std::make_shared<const GestureModel>(
			train("contact", "index_along_axis", recordings, {}).value());
	for (const double duration_s : { 0.8, 1.0, 1.3 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser({ contact }, std::nullopt, MotionMode::PHASE);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		const Events events = watch(recogniser, along(X, { drag }), 2.5);
		CHECK(events.said == times(1, "contact"));
		CHECK(std::abs(events.last_ended_s - (0.6 + CONTACT * duration_s)) < 0.05);
	}
}

TEST_CASE("with nothing given a hand that goes twice as far ends where it stops, not where others do") {
	const Drag far{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.4 };
	const Events events = in_the_open(along(X, { far }), 2.5);
	CHECK(events.said == times(1, "sideways"));
	CHECK(far.x_m(events.last_ended_s) > 0.36);
	// Foretold where a slow hand has a quarter of its peak speed, which its stroke is known to have 0.05 s
	// later.
	const Drag slow{ .onset_s = 0.6, .duration_s = 1.5, .amplitude_m = 0.4 };
	const double ended_s = in_the_open(along(X, { slow }), 3.0).last_ended_s;
	CHECK(std::abs((ended_s - slow.onset_s) / slow.duration_s - (0.5 + std::sqrt(0.125))) < 0.025);
}

TEST_CASE("ten taps in a row each start and end once") {
	std::vector<Drag> strokes;
	for (int i = 0; i < 10; ++i) {
		strokes.push_back({ .onset_s = 0.6 + i, .duration_s = 0.45, .amplitude_m = 0.2 });
		strokes.push_back({ .onset_s = 1.02 + i, .duration_s = 0.4, .amplitude_m = -0.2 });
	}
	CHECK(in_the_open(along(-Z, strokes), 11.0).said == times(10, "push"));
	CHECK(in_a_task(along(X, strokes), 11.0).said == times(10, "sideways"));
}

TEST_CASE("the way back is no gesture, unless the hand has rested at the end") {
	const Drag back{ .onset_s = 2.1, .duration_s = 1.0, .amplitude_m = -0.2 };
	CHECK(in_the_open(along(X, { DRAG, back }), 4.5).said == times(1, "sideways"));
	const Drag late{ .onset_s = 3.5, .duration_s = 1.0, .amplitude_m = -0.2 };
	CHECK(in_the_open(along(X, { DRAG, late }), 6.0).said == times(2, "sideways"));
}

TEST_CASE("a gesture that has arrived is shown until the hand does what is likelier another one than none") {
	const Drag next{ .onset_s = 2.0, .duration_s = 0.5, .amplitude_m = 0.1 };
	for (const double angle : { 0.0, 0.5, 0.6, 0.7 }) { // from upright
		CAPTURE(angle);
		const Eigen::Vector3d direction(0.0, std::cos(angle), std::sin(angle));
		const Way way = [&](double t_s) {
			return Eigen::Vector3d(DRAG.x_m(t_s) * X + next.x_m(t_s) * direction);
		};
		const Events events = in_the_open(way, 2.6);
		if (angle == 0.0) {
			CHECK(events.said.back() == "started upright");
			CHECK(events.last_value_m == near(0.1).epsilon(0.05));
		} else {
			CHECK(events.said == times(1, "sideways"));
			CHECK(events.last_value_m == near(0.2).epsilon(0.02));
		}
	}
}

TEST_CASE("a stroke that has ended as one gesture is not the beginning of another one") {
	// An eighth of the longer one, which a hand that stays there could still go on to make.
	GestureModel shorter = *model("short", X, true);
	shorter.typical_task.amplitude_m = 0.025;
	const auto short_model = std::make_shared<const GestureModel>(shorter);
	for (const double duration_s : { 0.2, 0.35, 0.5, 1.0 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser({ short_model, models()[0] }, std::nullopt, MotionMode::PHASE);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.025 };
		const Events events = watch(recogniser, along(X, { drag }), 1.7);
		CHECK(std::ranges::count(events.said, "ended short") == 1);
		CHECK(events.said.back() == "ended short");
		CHECK(events.last_value_m == near(0.025).epsilon(0.02));
	}
}

TEST_CASE("the motion of every gesture begins and ends without a step") {
	const Drag back{ .onset_s = 2.1, .duration_s = 1.0, .amplitude_m = -0.2 };
	for (const Eigen::Vector3d &axis : { X, Y, Eigen::Vector3d(-Z) }) {
		CAPTURE(axis);
		const Events events = in_the_open(along(axis, { DRAG, back }), 4.0);
		CHECK(events.said.size() == 2);
		CHECK(events.largest_step < 1.5 * FASTEST_M_MS);
		CHECK(events.last_value_m == near(0.0).epsilon(1e-6));
	}
}

TEST_CASE("a hand that hesitates half-way makes one gesture") {
	const Drag first{ .onset_s = 0.6, .duration_s = 0.6, .amplitude_m = 0.1 };
	const Drag second{ .onset_s = 1.4, .duration_s = 0.6, .amplitude_m = 0.1 };
	CHECK(in_the_open(along(X, { first, second }), 3.0).said == times(1, "sideways"));
	CHECK(in_a_task(along(X, { first, second }), 3.0).said == times(1, "sideways"));
	// A slow hand seems to rest for longer: it is as good as still before and after.
	const Drag slow{ .onset_s = 0.6, .duration_s = 1.2, .amplitude_m = 0.1 };
	const Drag goes_on{ .onset_s = 2.2, .duration_s = 1.2, .amplitude_m = 0.1 };
	CHECK(in_the_open(along(X, { slow, goes_on }), 4.2).said == times(1, "sideways"));
}

TEST_CASE("with the task known a hand that draws back first makes one gesture") {
	const Drag back{ .onset_s = 0.5, .duration_s = 0.35, .amplitude_m = -0.04 };
	const Drag forth{ .onset_s = 0.8, .duration_s = 0.5, .amplitude_m = 0.24 };
	CHECK(in_a_task(along(X, { back, forth }), 3.0).said == times(1, "sideways"));
}

TEST_CASE("a hand that stops half-way ends nothing: it is given up, or held where the task is known") {
	const Drag half{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.1 };
	const Events open = in_the_open(along(X, { half }), 4.0);
	CHECK(open.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	CHECK(open.largest_step < 0.003);
	CHECK(in_a_task(along(X, { half }), 4.0).said == std::vector<std::string>{ "started sideways" });
	const Drag back{ .onset_s = 2.5, .duration_s = 0.8, .amplitude_m = -0.1 };
	const Events returned = in_a_task(along(X, { half, back }), 5.0);
	CHECK(returned.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	CHECK(returned.largest_step < 0.003);
}

TEST_CASE("with the task known a hand that stops on its way may go on whenever it likes") {
	for (const double rest_s : { 0.3, 0.5, 0.7, 1.5, 5.0 }) {
		for (const double share : { 0.3, 0.48, 0.5, 0.52, 0.7 }) {
			CAPTURE(rest_s);
			CAPTURE(share);
			const Drag first{ .onset_s = 0.6, .duration_s = 0.6, .amplitude_m = 0.2 * share };
			const Drag second{
				.onset_s = 1.2 + rest_s, .duration_s = 0.6, .amplitude_m = 0.2 * (1.0 - share)
			};
			CHECK(in_a_task(along(X, { first, second }), 3.0 + rest_s).said == times(1, "sideways"));
		}
		Drag third{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.2 / 3.0 };
		std::vector<Drag> thirds;
		for (int i = 0; i < 3; ++i) {
			thirds.push_back(third);
			third.onset_s += 0.5 + rest_s;
		}
		CHECK(in_a_task(along(X, thirds), 4.0 + 2.0 * rest_s).said == times(1, "sideways"));
	}
}

TEST_CASE("with the task known a hand that stops on its way and goes elsewhere makes none") {
	const Drag half{ .onset_s = 0.6, .duration_s = 0.6, .amplitude_m = 0.1 };
	const Drag rest{ .onset_s = 2.2, .duration_s = 0.6, .amplitude_m = 0.1 };
	const Drag aside{ .onset_s = 2.2, .duration_s = 0.6, .amplitude_m = 0.3 };
	const Way way = [=](double t_s) {
		return Eigen::Vector3d(half.x_m(t_s) + rest.x_m(t_s), aside.x_m(t_s), 0.0);
	};
	CHECK(in_a_task(way, 5.0).said == std::vector<std::string>{ "started sideways", "aborted sideways" });
}

TEST_CASE("with the task known a gesture counts after a tracker that showed the hand elsewhere at first") {
	const Drag late{ .onset_s = 2.0 };
	for (const double off_m : { 0.05, 0.15, -0.3 }) {
		CAPTURE(off_m);
		const Way way = [=](double t_s) {
			return Eigen::Vector3d(late.x_m(t_s), t_s < 1.0 ? off_m : 0.0, 0.0);
		};
		CHECK(in_a_task(way, 4.0).said == times(1, "sideways"));
	}
}

TEST_CASE("a hand that overshoots and comes back to the end makes one gesture") {
	const Drag back{ .onset_s = 1.5, .duration_s = 0.3, .amplitude_m = -0.03 };
	const Drag over{ .onset_s = 0.6, .duration_s = 0.9, .amplitude_m = 0.23 };
	CHECK(in_the_open(along(X, { over, back }), 3.0).said == times(1, "sideways"));
	CHECK(in_a_task(along(X, { over, back }), 3.0).said == times(1, "sideways"));
}

TEST_CASE("a hand that turns back early makes none") {
	const Drag out{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.08 };
	const Drag back{ .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = -0.08 };
	for (const Events &events :
			{ in_the_open(along(X, { out, back }), 3.0), in_a_task(along(X, { out, back }), 3.0) }) {
		for (const std::string &said : events.said) {
			CHECK_MESSAGE(!said.starts_with("ended"), said);
		}
	}
}

TEST_CASE("a hand that never moves says nothing") {
	const Way still = [](double) { return Eigen::Vector3d(0.02, -0.01, 0.03); };
	CHECK(in_the_open(still, 20.0).said.empty());
	CHECK(in_a_task(still, 20.0).said.empty());
}

TEST_CASE("a stamp that no clock shows is passed over") {
	GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
	HandFrame frame;
	frame.set(Joint::INDEX, Eigen::Vector3d::Zero());
	recogniser.push(frame);
	frame.t_s = 1e300;
	recogniser.push(frame);
	recogniser.advance(1e300);
	CHECK(recogniser.time_s() == 0.0);
}

TEST_CASE("tracking that is lost in mid-gesture for 0.3 s loses no gesture and makes no second one") {
	for (const double lost_s : { 0.8, 1.0, 1.2 }) {
		CAPTURE(lost_s);
		CHECK(in_the_open(along(X, { DRAG }), 3.0, lost_s, lost_s + 0.3).said == times(1, "sideways"));
		CHECK(in_a_task(along(X, { DRAG }), 3.0, lost_s, lost_s + 0.3).said == times(1, "sideways"));
	}
}

TEST_CASE("a way that is off, bent or round is no gesture") {
	const Eigen::Vector3d diagonal = (X + Y).normalized();
	const Way arc = [](double t_s) {
		const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
		return Eigen::Vector3d(0.1 - 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
	};
	const Way round = [](double t_s) {
		return Eigen::Vector3d(0.1 * std::cos(4.0 * t_s), 0.1 * std::sin(4.0 * t_s), 0.0);
	};
	CHECK(none_ends(in_the_open(along(diagonal, { DRAG }), 4.0)));
	CHECK(none_ends(in_a_task(along(diagonal, { DRAG }), 4.0)));
	CHECK(none_ends(in_the_open(round, 4.0)));
	CHECK(none_ends(in_a_task(round, 4.0)));
	// With the task the arc would count: it leads from its start to its end.
	CHECK(none_ends(in_the_open(arc, 4.0)));
	for (const double angle : { 0.45, 0.53 }) { // 26 and 30 degrees
		CAPTURE(angle);
		const Eigen::Vector3d beside(std::cos(angle), std::sin(angle), 0.0);
		CHECK(none_ends(in_the_open(along(beside, { DRAG }), 4.0)) == (angle > 0.5));
	}
}

TEST_CASE("a hand that does anything begins a gesture every few seconds, which is given up with low "
		  "confidence") {
	double seconds = 0.0, greatest = 0.0, sum_of_greatest = 0.0; // confidences
	int begun = 0;
	for (std::uint32_t person = 0; person < 24; ++person) {
		const SyntheticTrial trial =
				make_synthetic_trial({ .name = "none",
											 .gesture = "none",
											 .subject = draw_subject(Population::TUNE, person),
											 .seed = person })
						.value();
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
		for (const HandFrame &frame : trial.measured.frames) {
			recogniser.push(frame);
			const double confidence = recogniser.confidence();
			REQUIRE((recogniser.gesture() < 0 ||
					recogniser.session()->stage() != GestureSession::Stage::ENDED));
			begun += confidence > 0.0 && greatest == 0.0 ? 1 : 0;
			sum_of_greatest += confidence == 0.0 ? greatest : 0.0;
			greatest = confidence == 0.0 ? 0.0 : std::max(greatest, confidence);
		}
		seconds += trial.measured.frames.back().t_s - trial.measured.frames.front().t_s;
	}
	CHECK(begun > seconds / 10.0);
	CHECK(begun < seconds / 2.0);
	CHECK(sum_of_greatest < 0.4 * begun);
}

TEST_CASE("with the task known a stroke from elsewhere to its end is none") {
	const Way from_above = [](double t_s) { return Eigen::Vector3d(0.2, 0.2 - DRAG.x_m(t_s), 0.0); };
	const Way beside = [](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s), 0.15, 0.0); };
	CHECK(in_a_task(from_above, 3.0).said.empty());
	CHECK(none_ends(in_a_task(beside, 3.0)));
	CHECK(in_a_task(along(X, { DRAG }), 3.0).said == times(1, "sideways"));
}

TEST_CASE("confidence is a probability, and near 1 where a gesture is plain") {
	const Events plain = in_the_open(along(X, { DRAG }), 2.5);
	CHECK(plain.last_confidence > 0.95);
	CHECK(plain.last_confidence <= 1.0);
	const Eigen::Vector3d oblique(std::cos(0.4), 0.0, std::sin(0.4));
	CHECK(in_the_open(along(oblique, { DRAG }), 2.5).last_confidence < plain.last_confidence);
	GestureRecogniser resting(models(), std::nullopt, MotionMode::PHASE);
	CHECK(resting.confidence() == 0.0);
}

TEST_CASE("a stroke that another one leads into is no gesture, unless it is the way back") {
	// The two strokes of a 1: up obliquely, and at once straight down.
	const Eigen::Vector3d up(0.7, 0.7, 0.0);
	const Way one = [&](double t_s) {
		const Drag first{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.2 };
		const Drag second{ .onset_s = 1.05, .duration_s = 0.5, .amplitude_m = 0.2 };
		return Eigen::Vector3d(first.x_m(t_s) * up - second.x_m(t_s) * Y);
	};
	CHECK(none_ends(in_the_open(one, 3.0)));
}

TEST_CASE("a way that winds is no gesture, wherever it ends") {
	// To either side in turn: the mean of the way lies on its chord.
	const Way wave = [](double t_s) {
		const double along_m = DRAG.x_m(t_s);
		return Eigen::Vector3d(
				along_m, 0.12 * std::sin(4.0 * std::numbers::pi * along_m / DRAG.amplitude_m), 0.0);
	};
	CHECK(none_ends(in_the_open(wave, 3.0)));
}

TEST_CASE("with nothing given a gesture is found at any pace that is studied") {
	for (const double duration_s : { 0.15, 0.3, 2.5, 4.0 }) {
		CAPTURE(duration_s);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		CHECK(in_the_open(along(X, { drag }), duration_s + 2.0).said == times(1, "sideways"));
	}
}

TEST_CASE("a track that begins with a jump, or in full motion, leaves the gesture that follows") {
	const Way jumped = [](double t_s) {
		return Eigen::Vector3d(DRAG.x_m(t_s) + (t_s < 0.1 ? 0.04 : 0.0), t_s < 0.02 ? 0.03 : 0.0, 0.0);
	};
	CHECK(in_the_open(jumped, 2.5).said == times(1, "sideways"));
	const Way arriving = [](double t_s) {
		const Drag come{ .onset_s = -0.15, .duration_s = 0.3, .amplitude_m = 0.3 };
		const Drag late{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
		return Eigen::Vector3d(late.x_m(t_s), 0.0, come.x_m(t_s));
	};
	CHECK(in_the_open(arriving, 3.0).said == times(1, "sideways"));
}

TEST_CASE("a jump before the onset, there and back while frames are missing, is no unrest") {
	for (const double back_s : { 0.3, 0.4, 0.5 }) {
		CAPTURE(back_s);
		const Way jumped = [&](double t_s) {
			const bool is_beside = t_s >= back_s - 0.08 && t_s < back_s;
			return Eigen::Vector3d(DRAG.x_m(t_s), is_beside ? 0.06 : 0.0, 0.0);
		};
		CHECK(in_the_open(jumped, 2.5, back_s - 0.02, back_s + 0.02).said == times(1, "sideways"));
	}
}

TEST_CASE("a tracker's error that goes on after the end does not undo the gesture") {
	const Eigen::Vector3d oblique(std::cos(0.33), std::sin(0.33), 0.0);
	const Way drifting = [&](double t_s) {
		return Eigen::Vector3d(DRAG.x_m(t_s) * oblique + 0.12 * std::clamp(t_s - 1.3, 0.0, 0.35) * Y);
	};
	CHECK(in_the_open(drifting, 3.0).said == times(1, "sideways"));
}

TEST_CASE("with nothing given a gesture is found by a tracker that trembles, and none where the hand rests") {
	for (const double rate_hz : { 30.0, 80.0, 240.0 }) {
		for (const double noise_m : { 1e-3, 3e-3, 5e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(noise_m);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Events drag = watch(recogniser, along(X, { DRAG }), 2.5, 1e9, 1e9, rate_hz, noise_m);
			CHECK(std::ranges::count(drag.said, "ended sideways") == 1);
			CHECK(ends(drag) == 1);
			GestureRecogniser at_rest(models(), std::nullopt, MotionMode::PHASE);
			CHECK(none_ends(watch(at_rest, along(X, {}), 20.0, 1e9, 1e9, rate_hz, noise_m)));
		}
	}
}
