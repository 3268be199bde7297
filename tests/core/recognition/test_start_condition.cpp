// When a StartCondition allows a gesture to begin, and the events of gestures with one.

#include "gesture_events.h"
#include "recognition/start_condition.h"
#include "simulation/hand_pose.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double FRAME_S = 0.01;

/// A hand with the palm at the origin and fingers along -z. index_m, others_m: distances of the tips from the
/// palm. gap_m: from the thumb tip to the index tip.
HandFrame hand(double index_m, double others_m, double gap_m) {
	HandFrame frame;
	frame.set(Joint::PALM, Eigen::Vector3d::Zero());
	frame.set(Joint::INDEX, { 0.0, 0.0, -index_m });
	frame.set(Joint::THUMB, { -gap_m, 0.0, -index_m });
	for (const Joint joint : { Joint::MIDDLE, Joint::RING, Joint::PINKY }) {
		frame.set(joint, { 0.0, 0.0, -others_m });
	}
	return frame;
}

HandFrame open_hand() {
	return hand(0.10, 0.10, 0.09);
}

HandFrame pinch(double gap_m = 0.01) {
	return hand(0.085, 0.10, gap_m);
}

/// Pushes frames into a StartCondition.
class Stream {
public:
	explicit Stream(const StartSettings &settings) : condition(settings) {}

	Stream &show(const HandFrame &shown, double length_s) {
		for (double s = 0.0; s < length_s - 1e-9; s += FRAME_S) {
			push(shown);
		}
		return *this;
	}
	Stream &lose(double length_s) { return show(HandFrame(), length_s); }
	void push(HandFrame frame) {
		frame.t_s = now_s += FRAME_S;
		condition.push(frame);
	}

	StartCondition condition;
	double now_s = 0.0;
};

Stream pinching() {
	Stream stream({ .kind = StartKind::PINCH });
	stream.show(open_hand(), 1.0).show(pinch(), 1.0);
	return stream;
}

/// Distance between thumb and index tip.
using Gap = double (*)(double t_s);

/// Events of a drag of 0.2 m from 1 to 2 s.
EventNames event_names(const StartSettings &settings, GestureRecogniser recogniser, Gap gap_m) {
	recogniser.set_start_condition(settings);
	Tremor tremor(1e-4, 7);
	EventNames names;
	ShownChanges shown;
	const Drag drag{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
	for (int ms = 0; ms < 3500; ++ms) {
		const double t_s = ms / 1000.0;
		if (ms % 9 == 0) {
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, drag.x_m(t_s) * X + tremor());
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - gap_m(t_s) * Y);
			recogniser.push(frame);
		}
		recogniser.advance(t_s);
		const GestureChanges changes = shown.next(recogniser);
		for (const auto &[has_happened, what] : { std::pair{ changes.aborted, "aborted horizontal_drag" },
					 { changes.started, "started horizontal_drag" },
					 { changes.ended, "ended horizontal_drag" } }) {
			if (has_happened) {
				names.emplace_back(what);
			}
		}
	}
	return names;
}

constexpr double OPEN_M = 0.08, CLOSED_M = 0.01, HALF_WAY_S = 1.5;
constexpr Gap OPEN = [](double) { return OPEN_M; };
constexpr Gap CLOSED = [](double) { return CLOSED_M; };
constexpr Gap OPENS = [](double t_s) { return t_s < HALF_WAY_S ? CLOSED_M : OPEN_M; };
constexpr Gap CLOSES = [](double t_s) { return t_s < HALF_WAY_S ? OPEN_M : CLOSED_M; };

struct Row {
	std::string what;
	StartSettings settings;
	Gap gap_m;
	EventNames events;
};

} // namespace

TEST_CASE("no condition is always met, a dwell after its time") {
	const StartCondition none;
	CHECK(none.is_met());
	CHECK(none.may_begin(-1e9));
	CHECK(none.may_begin(1e9));
	for (const double dwell_s : { 0.2, 1.0 }) {
		CAPTURE(dwell_s);
		Stream stream({ .kind = StartKind::DWELL, .dwell_s = dwell_s });
		CHECK(!stream.show(open_hand(), dwell_s - 2.0 * FRAME_S).condition.is_met());
		CHECK(stream.show(open_hand(), 4.0 * FRAME_S).condition.is_met());
	}
}

TEST_CASE("a steadily moving hand does not dwell; a trembling one does") {
	Stream moving({ .kind = StartKind::DWELL }), trembling({ .kind = StartKind::DWELL });
	std::mt19937_64 random(3);
	std::normal_distribution<double> tremor_m(0.0, 1e-3);
	for (int i = 0; i < 300; ++i) {
		HandFrame moved = open_hand(), trembled = open_hand();
		shift_hand(moved, Eigen::Vector3d(0.1 * FRAME_S * i, 0.0, 0.0));
		shift_hand(trembled, { tremor_m(random), tremor_m(random), tremor_m(random) });
		moving.push(moved);
		trembling.push(trembled);
		CHECK(!moving.condition.is_met());
	}
	CHECK(trembling.condition.is_met());
}

TEST_CASE("a dwell allows an onset 0.1 s later, not 1 s later") {
	Stream stream({ .kind = StartKind::DWELL });
	stream.show(open_hand(), 1.0);
	const double left_s = stream.now_s;
	for (int i = 0; i < 200; ++i) {
		HandFrame moved = open_hand();
		shift_hand(moved, Eigen::Vector3d(0.5 * FRAME_S * i, 0.0, 0.0));
		stream.push(moved);
	}
	CHECK(!stream.condition.is_met());
	CHECK(stream.condition.may_begin(left_s + 0.1));
	CHECK(!stream.condition.may_begin(left_s + 1.0));
	CHECK(!stream.condition.may_begin(0.0));
}

TEST_CASE("fingers with tremor pinch and open once (hysteresis)") {
	Stream stream({ .kind = StartKind::PINCH });
	std::mt19937_64 random(3);
	std::normal_distribution<double> tremor_m(0.0, 5e-4);
	int changes = 0;
	bool was_met = false;
	for (int i = 0; i < 2000; ++i) {
		const double away = std::abs(i - 1000) / 1000.0; // 1 to 0 and back
		stream.push(pinch(0.015 + 0.02 * away + tremor_m(random)));
		changes += stream.condition.is_met() != was_met ? 1 : 0;
		was_met = stream.condition.is_met();
	}
	CHECK(changes == 2);
	CHECK(!was_met);
}

TEST_CASE("an opened pinch is released and allows no onset") {
	Stream stream = pinching();
	CHECK(stream.condition.may_begin(stream.now_s));
	CHECK(!stream.condition.is_released());
	stream.show(open_hand(), 0.2);
	CHECK(stream.condition.is_released());
	CHECK(!stream.condition.may_begin(stream.now_s));
	stream.show(pinch(), 0.2);
	CHECK(!stream.condition.is_released());
	CHECK(stream.condition.may_begin(stream.now_s));
}

TEST_CASE("a dropout of 0.2 s ends neither pinch nor dwell") {
	CHECK(pinching().lose(0.2).show(pinch(), 0.02).condition.is_met());
	CHECK(!pinching().show(open_hand(), 0.06).show(pinch(), 0.02).condition.is_released());
	Stream dwelling({ .kind = StartKind::DWELL });
	HandFrame elsewhere = open_hand();
	shift_hand(elsewhere, { 0.0, 0.3, 0.0 });
	dwelling.show(open_hand(), 1.0).lose(0.2).show(elsewhere, 0.06).show(open_hand(), 0.02);
	CHECK(dwelling.condition.is_met());
}

TEST_CASE("a dropout of 0.5 s ends a pinch without releasing it") {
	Stream stream = pinching();
	stream.lose(0.5);
	CHECK(!stream.condition.is_met());
	stream.show(pinch(), 0.05);
	CHECK(!stream.condition.is_met());
	CHECK(!stream.condition.may_begin(stream.now_s));
	CHECK(!stream.condition.is_released());
	CHECK(stream.show(pinch(), 0.5).condition.is_met());
	stream.now_s += 2.0; // without frames
	CHECK(!stream.condition.may_begin(stream.now_s));
	stream.push(pinch());
	CHECK(!stream.condition.is_met());
}

TEST_CASE("a low-confidence pinch counts only if all frames have low confidence") {
	HandFrame doubted = pinch();
	doubted.confidence = 0.0;
	Stream reports({ .kind = StartKind::PINCH }), never({ .kind = StartKind::PINCH });
	CHECK(!reports.show(open_hand(), 1.0).show(doubted, 1.0).condition.is_met());
	HandFrame open = open_hand();
	open.confidence = 0.0;
	CHECK(never.show(open, 1.0).show(doubted, 1.0).condition.is_met());
}

TEST_CASE("only a pointing hand, of any size, meets the pointing pose") {
	const StartSettings pointing{ .kind = StartKind::POINTING_POSE };
	for (const double scale : { 0.75, 1.2 }) {
		CAPTURE(scale);
		CHECK(Stream(pointing).show(pointing_hand(scale), 1.0).condition.is_met());
		CHECK(!Stream(pointing).show(pinching_hand(scale, 0.04), 1.0).condition.is_met());
	}
	CHECK(!Stream(pointing).show(open_hand(), 1.0).condition.is_met());
	CHECK(!Stream(pointing).show(hand(0.05, 0.03, 0.04), 1.0).condition.is_met()); // a fist
	HandFrame two_fingers = hand(0.11, 0.05, 0.08);
	two_fingers.set(Joint::MIDDLE, { 0.02, 0.0, -0.11 });
	CHECK(!Stream(pointing).show(two_fingers, 1.0).condition.is_met());
}

TEST_CASE("has_joints() says whether a frame has the required joints") {
	HandFrame tip;
	tip.set(Joint::INDEX, Eigen::Vector3d::Zero());
	for (const StartKind kind : { StartKind::DWELL, StartKind::PINCH, StartKind::POINTING_POSE }) {
		Stream stream({ .kind = kind });
		CHECK(stream.show(open_hand(), FRAME_S).condition.has_joints());
		CHECK(stream.show(tip, FRAME_S).condition.has_joints() == (kind == StartKind::DWELL));
	}
}

TEST_CASE("a drag starts only while its start condition is met") {
	for (const auto &[what, settings, gap_m, events] : {
				 Row{ "no condition", {}, OPEN, ENDS },
				 { "pinch", { StartKind::PINCH }, CLOSED, ENDS },
				 { "open hand", { StartKind::PINCH }, OPEN, NOTHING },
				 { "pinch that opens half-way", { StartKind::PINCH }, OPENS, ABORTS },
				 { "pinch that closes half-way", { StartKind::PINCH }, CLOSES, NOTHING },
				 { "dwell", { StartKind::DWELL }, OPEN, ENDS },
				 { "rest shorter than the dwell", { .kind = StartKind::DWELL, .dwell_s = 2.0 }, OPEN,
						 NOTHING },
				 { "pose without its joints", { StartKind::POINTING_POSE }, OPEN, NOTHING },
		 }) {
		INFO(what);
		CHECK_MESSAGE(event_names(settings, with_task(), gap_m) == events, "with a task");
		CHECK_MESSAGE(event_names(settings, without_task(), gap_m) == events, "without a task");
	}
}
