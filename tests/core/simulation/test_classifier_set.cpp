#include "gesture/classifier_file.h"
#include "recognition/classifier_streams.h"
#include "simulation/classifier_set.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

SyntheticSetOptions few(Population population, std::uint32_t subjects, std::uint32_t repetitions) {
	SyntheticSetOptions options;
	options.population = population;
	options.subjects = subjects;
	options.repetitions = repetitions;
	return options;
}

TEST_CASE("axes of turned trials are within 20 degrees of both tap directions") {
	int down = 0, forward = 0;
	const auto trials = make_turned_trials(few(Population::TUNE, 3, 2)).value();
	for (const SyntheticTrial &made : trials) {
		if (made.trial.has_axis()) {
			CHECK(made.trial.axis.cwiseAbs().maxCoeff() > 0.9396); // cos 20 degrees
			const bool is_tap = made.trial.gesture == "tap";
			down += is_tap && made.trial.axis.y() < -0.9 ? 1 : 0;
			forward += is_tap && made.trial.axis.z() < -0.9 ? 1 : 0;
		}
	}
	CHECK(down + forward == 12);
	CHECK(std::min(down, forward) >= 3);
}

TEST_CASE("equal recordings train an equal classifier, two paces for each direction" *
		doctest::test_suite("figures")) {
	const auto trials = make_turned_trials(few(Population::TRAIN, 2, 4)).value();
	ClassifierTrainingOptions options;
	options.symbols = 16;
	options.states = 5;
	const auto model = train_classifier(classifier_recordings(trials), options);
	REQUIRE(model.ok());
	CHECK(format_classifier(model.value()) ==
			format_classifier(train_classifier(classifier_recordings(trials), options).value()));
	const auto hmms = [&](const char *gesture) {
		return std::ranges::count(model.value().gestures, gesture, &DirectedHmm::gesture);
	};
	CHECK(hmms("horizontal_drag") == 4);
	CHECK(hmms("vertical_drag") == 4);
	CHECK(hmms("tap") == 4);
	CHECK(hmms("zoom") == 2);
}

TEST_CASE("training a classifier needs a known feature and a gesture's recording") {
	CHECK(!train_classifier({}).ok());
	auto recordings = classifier_recordings(make_turned_trials(few(Population::TRAIN, 1, 1)).value());
	recordings.front().feature = "toe_angle";
	CHECK(train_classifier(recordings).error().find("toe_angle") != std::string::npos);
}

TEST_CASE("90 % of new people's steady gestures are found, also taps down") {
	SyntheticSetOptions set = few(Population::TUNE, 6, 2);
	set.positions = { HandPosition::STABLE };
	int made = 0, found = 0;
	double idle_s = 0.0;
	int alarms = 0;
	const auto trials = make_turned_trials(set).value();
	for (const SyntheticTrial &trial : trials) {
		const std::vector<Spotted> spotted = spot(trial.measured.frames);
		const auto first = std::ranges::find(spotted, GestureSpotter::Event::ENDED, &Spotted::event);
		const bool has_ended = first != spotted.end();
		if (trial.trial.gesture == NO_GESTURE) {
			alarms += has_ended ? 1 : 0;
			idle_s += trial.measured.frames.back().t_s;
		} else {
			++made;
			found += has_ended && first->gesture == trial.trial.gesture ? 1 : 0;
		}
	}
	CHECK(found >= made * 9 / 10);
	CHECK(alarms <= idle_s / 60.0 * 4.0);
}

} // namespace
