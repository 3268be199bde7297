// Gestures of a user, trained from a few recordings, are recognised without a task.

#include "recogniser_of.h"
#include "recognition/gesture_events.h"
#include "simulation/classifier_set.h"

#include <algorithm>
#include <cstdint>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Models = std::vector<std::shared_ptr<const GestureModel>>;

GestureRecogniser paper(const Models &expected) {
	return recogniser_of(expected, std::nullopt, { MotionMode::PAPER });
}

/// Without HMMs of its own.
std::shared_ptr<const GestureModel> bare_model(const char *gesture, const Eigen::Vector3d &axis) {
	GestureModel bare = *model(gesture, axis, true);
	bare.recorded_hmms.clear();
	return std::make_shared<const GestureModel>(std::move(bare));
}

/// Models with the names of the add-on's gestures.
Models own_models() {
	return { bare_model("horizontal_drag", X), bare_model("vertical_drag", Y), bare_model("tap", -Z),
		zoom_model(0.03, 0.04) };
}

/// Five reaches of one person.
std::vector<SyntheticTrial> reaches(
		Population population, const Eigen::Vector3d &axis, double amplitude_m, double pace = 1.0) {
	std::vector<SyntheticTrial> trials;
	for (std::uint64_t seed = 1; seed <= 5; ++seed) {
		SyntheticTrialRequest request{ .name = "reach", .gesture = "horizontal_drag", .seed = seed };
		request.subject = draw_subject(population, 1);
		request.subject.pace = pace;
		request.place = GestureTask{ { 0.0, 0.1, -0.3 }, axis, amplitude_m };
		trials.push_back(make_synthetic_trial(request).value());
	}
	return trials;
}

std::shared_ptr<const GestureModel> user_model(
		const std::string &gesture, const Eigen::Vector3d &axis, double amplitude_m) {
	std::vector<TrainingRecording> recordings;
	for (const ClassifierRecording &one :
			classifier_recordings(reaches(Population::TRAIN, axis, amplitude_m))) {
		recordings.push_back(one.recording);
	}
	return std::make_shared<const GestureModel>(train(gesture, "index_along_axis", recordings, {}).value());
}

/// Gestures that end.
EventNames ended(GestureRecogniser recogniser, const Track &measured) {
	EventNames names;
	ShownChanges shown;
	for (const HandFrame &frame : measured.frames) {
		recogniser.push(frame);
		if (shown.next(recogniser).ended) {
			names.push_back(recogniser.session()->model().gesture);
		}
	}
	return names;
}

} // namespace

TEST_CASE("five recordings of a gesture tell it from the add-on's four") {
	struct Row {
		std::string gesture;
		Eigen::Vector3d axis;
		double amplitude_m;
	};
	for (const Row &row : { Row{ "push", -Z, 0.12 }, { "pull", Z, 0.2 }, { "swipe", X, 0.4 } }) {
		CAPTURE(row.gesture);
		Models all = own_models();
		all.push_back(user_model(row.gesture, row.axis, row.amplitude_m));
		int found = 0;
		for (const double pace : { 1.0, 0.6 }) {
			for (const SyntheticTrial &trial : reaches(Population::TUNE, row.axis, row.amplitude_m, pace)) {
				found += ended(paper(all), trial.measured) == EventNames{ row.gesture } ? 1 : 0;
			}
		}
		CHECK(found >= 8);
		found = 0;
		for (const bool is_sideways : { true, false }) {
			const std::string own = is_sideways ? "horizontal_drag" : "vertical_drag";
			for (const SyntheticTrial &trial : reaches(Population::TUNE, is_sideways ? X : Y, 0.2)) {
				const EventNames names = ended(paper(all), trial.measured);
				found += names == EventNames{ own } ? 1 : 0;
				CHECK(std::ranges::count(names, row.gesture) == 0);
			}
		}
		CHECK(found >= 9);
	}
}

TEST_CASE("without a task a gesture may have 0.7 to 2 times its trained length") {
	const auto push = user_model("push", -Z, 0.2);
	for (const auto &[length, count] : { std::pair{ 0.5, 0 }, { 0.7, 1 }, { 1.0, 1 }, { 2.0, 1 } }) {
		for (const double duration_s : { 0.8, 1.0 }) {
			CAPTURE(length);
			CAPTURE(duration_s);
			const Drag drag{ DRAG.onset_s, duration_s, 0.2 * length };
			CHECK(ends(watch(paper({ push }), along(-Z, { drag }), 3.0)) == count);
			CHECK(ends(watch(paper({ own_models()[0] }), along(X, { drag }), 3.0)) == count);
		}
	}
}

TEST_CASE("a model's own HMMs replace the add-on's, and the first model of a name counts") {
	GestureModel own = *model("down", -Y, false);
	own.gesture = own.recorded_hmms.front().gesture = "horizontal_drag";
	const auto down = std::make_shared<const GestureModel>(std::move(own)),
			   sideways = bare_model("horizontal_drag", X);
	const TestPath along_x = along(X, { DRAG }), along_y = along(-Y, { DRAG });
	CHECK(watch(paper({ down }), along_y, 3.0).names == times(1, "horizontal_drag"));
	CHECK(watch(paper({ down }), along_x, 3.0).names.empty());
	CHECK(watch(paper({ sideways, down }), along_y, 3.0).names.empty());
	CHECK(watch(paper({ sideways, down }), along_x, 3.0).names == times(1, "horizontal_drag"));
}

TEST_CASE("a user's gesture that is active goes on while expect() changes the others") {
	const auto push = model("push", -Z, false);
	for (const bool stays : { true, false }) {
		GestureRecogniser recogniser = paper({ bare_model("tap", -Z), push });
		bool has_changed = false;
		const TestPath path = [&](double t_s) {
			if (t_s > DRAG.onset_s + 0.75 * DRAG.duration_s && !std::exchange(has_changed, true)) {
				REQUIRE(recogniser.gesture() == 1);
				recogniser.expect({ { stays ? push : model("push", -Z, false), {} } });
			}
			return Eigen::Vector3d(DRAG.x_m(t_s) * -Z);
		};
		CHECK(ends(watch(recogniser, path, 3.0)) == (stays ? 1 : 0));
	}
}
