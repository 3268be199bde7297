// `paper` mode without a task: GestureRecogniser with the add-on's HMMs.

#include "allocations.h"
#include "classifier_streams.h"
#include "gesture_events.h"
#include "simulation/classifier_set.h"

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Without HMMs of its own.
std::shared_ptr<const GestureModel> bare_model(const char *gesture, const Eigen::Vector3d &axis) {
	GestureModel bare = *model(gesture, axis, true);
	bare.recorded_hmms.clear();
	return std::make_shared<const GestureModel>(std::move(bare));
}

/// Models with the names of the add-on's gestures.
std::vector<std::shared_ptr<const GestureModel>> four_models() {
	return { bare_model("horizontal_drag", X), bare_model("vertical_drag", Y), bare_model("tap", -Z),
		zoom_model(0.03, 0.04) };
}

GestureRecogniser paper(const std::vector<std::shared_ptr<const GestureModel>> &expected) {
	return recogniser_of(expected, std::nullopt, { MotionMode::PAPER });
}

const TestPath SIDEWAYS = along(X, { DRAG });

TEST_CASE("paper mode without a task ends 90 % of synthetic gestures") {
	SyntheticSetOptions set;
	set.population = Population::TUNE;
	set.subjects = 3;
	set.repetitions = 2;
	set.positions = { HandPosition::STABLE };
	int made = 0, found = 0, made_down = 0, found_down = 0;
	const std::vector<SyntheticTrial> trials = make_turned_trials(set).value();
	for (const auto &[trial, measured, reference] : trials) {
		if (trial.gesture == NO_GESTURE) {
			continue;
		}
		GestureRecogniser recogniser = paper(four_models());
		std::string first;
		ShownChanges shown;
		for (const HandFrame &frame : measured.frames) {
			recogniser.push(frame);
			if (shown.next(recogniser).ended && first.empty()) {
				first = recogniser.session()->model().gesture;
			}
		}
		const bool is_down = trial.gesture == "tap" && trial.axis.y() < -0.7;
		++made;
		made_down += is_down ? 1 : 0;
		found += first == trial.gesture ? 1 : 0;
		found_down += is_down && first == trial.gesture ? 1 : 0;
	}
	CHECK(found >= made * 9 / 10);
	CHECK(made_down > 0);
	CHECK(found_down >= made_down * 3 / 4);
}

TEST_CASE("a spotted drag starts during the movement and ends within 0.2 s") {
	const Events events = watch(paper(four_models()), SIDEWAYS, 3.0);
	CHECK(events.names == times(1, "horizontal_drag"));
	CHECK(events.first_shown_s > DRAG.onset_s);
	CHECK(events.first_shown_s < DRAG.onset_s + DRAG.duration_s);
	CHECK(std::abs(events.last_ended_s - (DRAG.onset_s + DRAG.duration_s)) < 0.2);
	CHECK(events.last_confidence > 0.9);
	const Events lost = watch(paper(four_models()), SIDEWAYS, 4.0, { DRAG.onset_s + 0.5 });
	CHECK(lost.names == EventNames{ "started horizontal_drag", "aborted horizontal_drag" });
	const Events lost_at_end =
			watch(paper(four_models()), SIDEWAYS, 4.0, { DRAG.onset_s + DRAG.duration_s + 0.05 });
	CHECK(lost_at_end.names == times(1, "horizontal_drag"));
}

TEST_CASE("the measured motion of a spotted drag counts from its onset") {
	GestureRecogniser recogniser = paper(four_models());
	const double start_m = SIDEWAYS(0.0).x();
	watch(
			recogniser,
			[&](double t_s) {
				const Eigen::Vector3d now_m = SIDEWAYS(t_s);
				if (t_s > 0.3 && t_s < DRAG.onset_s + DRAG.duration_s) {
					const double before_m = SIDEWAYS(t_s - 1.0 / 110.0).x() - start_m; // the last frame
					CHECK(std::abs(recogniser.motion(MotionSource::MEASURED).value_m - before_m) < 0.005);
				}
				return now_m;
			},
			DRAG.onset_s + DRAG.duration_s);
}

TEST_CASE("an ended drag stays at its end while the hand creeps on") {
	GestureRecogniser recogniser = paper(four_models());
	const double end_s = DRAG.onset_s + DRAG.duration_s;
	const TestPath creeps = [&](double t_s) {
		return Eigen::Vector3d(SIDEWAYS(t_s) + 0.02 * std::clamp(t_s - end_s, 0.0, 3.0) * X);
	};
	const Events events = watch(recogniser, creeps, end_s + 2.5);
	CHECK(events.names == times(1, "horizontal_drag"));
	CHECK(recogniser.motion(MotionSource::SYNTHESISED).progress > 0.95);
}

TEST_CASE("only expected gestures are spotted") {
	CHECK(watch(paper({ four_models()[1], four_models()[2] }), SIDEWAYS, 3.0).names.empty());
	CHECK(watch(paper({ models()[0], four_models()[1] }), SIDEWAYS, 3.0).names == ENDS);
}

TEST_CASE("a spotted gesture aborts only if expect() removes it") {
	const auto all = four_models();
	for (const bool stays : { true, false }) {
		GestureRecogniser recogniser = paper({ all[1], all[0] });
		bool has_changed = false;
		const TestPath path = [&](double t_s) {
			if (t_s > DRAG.onset_s + 0.75 * DRAG.duration_s && !std::exchange(has_changed, true)) {
				REQUIRE(recogniser.gesture() == 1);
				recogniser.expect({ { all[2], {} }, { stays ? all[0] : all[1], {} } });
			}
			return SIDEWAYS(t_s);
		};
		const std::ptrdiff_t ended = count(watch(recogniser, path, 3.0), "ended horizontal_drag");
		CHECK(ended == (stays ? 1 : 0));
	}
}

TEST_CASE("a start condition is judged at a spotted gesture's onset") {
	for (const StartKind kind : { StartKind::DWELL, StartKind::PINCH }) {
		GestureRecogniser recogniser = paper(four_models());
		recogniser.set_start_condition({ .kind = kind });
		// The hand rests for 0.6 s. The frames have no thumb.
		const auto &names = watch(recogniser, SIDEWAYS, 3.0).names;
		CHECK(names == (kind == StartKind::DWELL ? times(1, "horizontal_drag") : times(0, "")));
	}
}

TEST_CASE("later frames change no bit of spotted motion") {
	const auto play = [](const TestPath &path) {
		GestureRecogniser recogniser = paper(four_models());
		std::vector<double> values_m;
		watch(
				recogniser,
				[&](double t_s) {
					values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
					return path(t_s);
				},
				2.5);
		return values_m;
	};
	const double cut_s = DRAG.onset_s + 0.8 * DRAG.duration_s;
	const std::vector<double> whole = play(SIDEWAYS), cut = play([&](double t_s) {
		return t_s < cut_s ? SIDEWAYS(t_s) : Eigen::Vector3d(0.5, t_s, 0.5);
	});
	const auto first_other = std::ranges::mismatch(whole, cut).in1 - whole.begin();
	CHECK(static_cast<double>(first_other) / 110.0 > cut_s);
	CHECK(static_cast<double>(first_other) < static_cast<double>(whole.size()));
	CHECK(whole[static_cast<std::size_t>(110.0 * cut_s)] > 0.0);
}

TEST_CASE("spotting allocates nothing per frame") {
	GestureRecogniser recogniser = paper(four_models());
	const std::vector<HandFrame> frames = frames_of({});
	int shown = 0;
	CHECK(allocations_of([&] {
		for (const HandFrame &frame : frames) {
			recogniser.push(frame);
			recogniser.advance(frame.t_s + 1e-3);
			shown += recogniser.gesture() >= 0 ? 1 : 0;
		}
	}) == 0);
	CHECK(shown > 0);
}

} // namespace
