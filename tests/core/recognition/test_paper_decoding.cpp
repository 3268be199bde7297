#include "minimum_jerk_drag.h"
#include "near.h"
#include "recognition/gesture_recogniser.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <array>
#include <memory>

using namespace steadyhand;

namespace {

constexpr std::array DECODINGS{
	StateDecoding{ StateDecoding::Rule::VITERBI, 3 },
	StateDecoding{ StateDecoding::Rule::VITERBI, 8 },
	StateDecoding{ StateDecoding::Rule::FILTER },
	StateDecoding{ StateDecoding::Rule::VITERBI, 0, StateDecoding::Precision::SINGLE },
};

} // namespace

TEST_CASE("a state that is known late is dated back: its element is through when it would have been") {
	const GestureModel &model = *test::shared_drag_model();
	constexpr double SLOWER = 1.2, LATE_S = 0.05;
	const PrimitiveMotionElement &first = model.elements[0], &second = model.elements[1];
	const double entered_s = SLOWER * first.duration_mean_s,
				 through_s = entered_s + SLOWER * second.duration_mean_s;
	PaperSynthesiser in_time(model), late(model);
	in_time.begin(0.0, 0.0);
	late.begin(0.0, 0.0);
	in_time.enter_state(1, entered_s, entered_s);
	const double phase_before = late.phase(entered_s + LATE_S);
	const double value_before = late.motion(entered_s + LATE_S, 1.0).value_m;
	late.enter_state(1, entered_s, entered_s + LATE_S);
	CHECK(late.phase(entered_s + LATE_S) == phase_before);
	CHECK(late.motion(entered_s + LATE_S, 1.0).value_m == test::near(value_before));
	for (const PaperSynthesiser *const synthesiser : { &in_time, &late }) {
		CHECK(synthesiser->phase(through_s - 1e-3) < second.phase_end - 1e-4);
		CHECK(synthesiser->phase(through_s + 1e-9) == test::near(second.phase_end).epsilon(1e-12));
	}
}

TEST_CASE("a gesture that is seen late begins there: its first element is through when it would have been") {
	const GestureModel &model = *test::shared_drag_model();
	const PrimitiveMotionElement &first = model.elements[0], &second = model.elements[1];
	for (const double share : { 0.0, 0.4, 0.9 }) {
		PaperSynthesiser synthesiser(model);
		synthesiser.begin(2.0, share * first.phase_end);
		const double through_s = 2.0 + (1.0 - share) * first.duration_mean_s;
		CHECK(synthesiser.phase(2.0) == test::near(share * first.phase_end));
		CHECK(synthesiser.phase(through_s - 1e-3) < first.phase_end);
		CHECK(synthesiser.phase(through_s + 1e-9) == test::near(first.phase_end).epsilon(1e-12));
		CHECK(synthesiser.phase(through_s + 1.0) == first.phase_end);
	}
	// Before the first phase, and beyond the first element, it begins at their ends.
	for (const double phase : { -0.5, 1.0 }) {
		PaperSynthesiser synthesiser(model);
		synthesiser.begin(2.0, phase);
		CHECK(synthesiser.phase(2.0) == test::near(phase < 0.0 ? 0.0 : first.phase_end));
	}
	// One that is known when it should be through is played at once, forwards.
	PaperSynthesiser late(model);
	late.begin(0.0, 0.0);
	const double known_s = first.duration_mean_s + 3.0 * second.duration_mean_s;
	late.enter_state(1, first.duration_mean_s, known_s);
	CHECK(late.phase(known_s) == test::near(first.phase_end));
	CHECK(late.phase(known_s + 0.5e-3) > first.phase_end);
	CHECK(late.phase(known_s + 1.1e-3) == test::near(second.phase_end));
}

TEST_CASE("the decoder does not say which gesture it is, nor, without a task, when it ends") {
	const Track track =
			test::drag_track({ .onset_s = 0.5, .duration_s = 1.1, .amplitude_m = 0.2 }, 97.0, 2.5);
	const auto stages = [&](const StateDecoding &decoding) {
		GestureRecogniser recogniser(
				{ test::shared_drag_model() }, std::nullopt, MotionMode::PAPER, {}, 0.0, decoding);
		std::vector<int> told;
		for (const HandFrame &frame : track.frames) {
			recogniser.push(frame);
			const GestureSession *const session = recogniser.session();
			told.push_back(session != nullptr ? static_cast<int>(session->stage()) : -1);
		}
		return told;
	};
	const std::vector<int> as_shipped = stages({});
	REQUIRE(as_shipped.back() == static_cast<int>(GestureSession::Stage::ENDED));
	for (const StateDecoding &decoding : DECODINGS) {
		CHECK(stages(decoding) == as_shipped);
	}
}

TEST_CASE("`paper` mode comes to the end of a drag by every decoder, and those that wait tell no state "
		  "sooner") {
	const test::Drag drag{ .onset_s = 0.5, .duration_s = 1.1, .amplitude_m = 0.2 };
	const Track track = test::drag_track(drag, 97.0, 3.0);
	const auto first_seen_s = [&](const StateDecoding &decoding) {
		GestureRecogniser recogniser(
				{ test::shared_drag_model() }, Task{}, MotionMode::PAPER, {}, 0.0, decoding);
		std::array<double, 4> seen_s{};
		for (const HandFrame &frame : track.frames) {
			recogniser.push(frame);
			if (const GestureSession *const session = recogniser.session()) {
				double &first_s = seen_s.at(static_cast<std::size_t>(session->state()));
				first_s = first_s > 0.0 ? first_s : frame.t_s;
			}
		}
		CHECK(recogniser.motion(MotionSource::SYNTHESISED).value_m == test::near(drag.amplitude_m));
		return seen_s;
	};
	const std::array<double, 4> as_shipped = first_seen_s({});
	for (const StateDecoding &decoding : DECODINGS) {
		const std::array<double, 4> seen_s = first_seen_s(decoding);
		for (std::size_t state = 1; state < seen_s.size(); ++state) {
			CAPTURE(state);
			CAPTURE(decoding.lag);
			CHECK(seen_s[state] > 0.0);
			if (decoding.rule == StateDecoding::Rule::VITERBI) {
				CHECK(seen_s[state] >= as_shipped[state]);
			}
		}
	}
}
