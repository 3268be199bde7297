#include "gesture/feature.h"
#include "gesture/model_file.h"
#include "gesture/recording_oddity.h"
#include "gesture/trainer.h"
#include "minimum_jerk_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

/// A drag of 0.2 m from 0.5 s to 1.3 s.
TrainingRecording sound_drag() {
	return test::drag_recordings()[0];
}

std::string told_of(const std::function<void(TrainingRecording &)> &change) {
	TrainingRecording recording = sound_drag();
	change(recording);
	return oddity(*find_feature("index_along_axis"), recording);
}

void scale(Track &track, double factor) {
	for (HandFrame &frame : track.frames) {
		frame.set(Joint::INDEX, factor * frame.position(Joint::INDEX));
	}
}

void scale_time(Track &track, double factor) {
	for (HandFrame &frame : track.frames) {
		frame.t_s *= factor;
	}
}

void keep_until(Track &track, double end_s) {
	std::erase_if(track.frames, [&](const HandFrame &frame) { return frame.t_s > end_s; });
}

} // namespace

TEST_CASE("recordings of simulated drags have no oddity") {
	for (const TrainingRecording &recording : test::drag_recordings()) {
		CHECK(oddity(*find_feature("index_along_axis"), recording).empty());
	}
	// Faults of bad trackers: a jump of one frame, latency, a dropout before the hand has settled.
	CHECK(told_of([](TrainingRecording &r) {
		r.measured.frames[9].set(Joint::INDEX, { 9.9, 0.0, 0.0 });
	}).empty());
	CHECK(told_of([](TrainingRecording &r) { keep_until(r.measured, r.end_s - 0.09); }).empty());
}

TEST_CASE("the oddity of a recording names its cause") {
	const std::vector<std::pair<std::string, std::function<void(TrainingRecording &)>>> odd = {
		{ "its reference reaches 1000.000 amplitudes, not 1: check metres, start, axis, amplitude",
				[](TrainingRecording &r) { scale(r.reference, 1000.0); } },
		{ "its reference reaches 0.001 amplitudes, not 1: check metres, start, axis, amplitude",
				[](TrainingRecording &r) { r.task.amplitude_m *= 1000.0; } },
		{ "its reference comes no nearer to its start than 2.00 amplitudes: check start, axis, amplitude",
				[](TrainingRecording &r) { r.task.start_m.x() -= 0.4; } },
		{ "its reference has no values of index_along_axis",
				[](TrainingRecording &r) {
					for (HandFrame &frame : r.reference.frames) {
						frame = { .t_s = frame.t_s };
					}
				} },
		{ "its reference has no frames", [](TrainingRecording &r) { r.reference.frames.clear(); } },
		{ "its measured track has no frames", [](TrainingRecording &r) { r.measured.frames.clear(); } },
		{ "its measured track reaches 1000 amplitudes: check metres",
				[](TrainingRecording &r) { scale(r.measured, 1000.0); } },
		{ "its measured track has no motion of index_along_axis",
				[](TrainingRecording &r) {
					for (HandFrame &frame : r.measured.frames) {
						const Eigen::Vector3d tip_m = frame.position(Joint::INDEX);
						frame = { .t_s = frame.t_s };
						frame.set(Joint::THUMB, tip_m);
					}
				} },
		{ "its measured track has no motion of index_along_axis",
				[](TrainingRecording &r) {
					for (HandFrame &frame : r.measured.frames) { // a sensor that is stuck
						frame.set(Joint::INDEX, { 0.1, 0.2, 0.3 });
					}
				} },
		{ "its measured track ends at 0.800 s, before the gesture does, at 1.300 s",
				[](TrainingRecording &r) { keep_until(r.measured, 0.8); } },
		{ "its measured track begins at 1.391 s, after the gesture's end at 1.300 s",
				[](TrainingRecording &r) {
					std::erase_if(r.measured.frames, [](const HandFrame &frame) { return frame.t_s < 1.39; });
				} },
		{ "its measured track lasts 1790.9 s, its reference 1.8 s: check seconds",
				[](TrainingRecording &r) { scale_time(r.measured, 1000.0); } },
	};
	for (const auto &[told, change] : odd) {
		CHECK(told_of(change) == told);
	}
	// With numbers that have no text.
	CHECK(told_of([](TrainingRecording &r) { scale(r.measured, 1e300); }).size() < 400);
}

TEST_CASE("a measured track that ends early is reported and used") {
	std::vector<TrainingRecording> drags = test::drag_recordings();
	keep_until(drags[3].measured, 0.8);
	std::vector<NormalisedRecording> told;
	const Result<GestureModel> model = train("drag", "index_along_axis", drags, {}, &told);
	REQUIRE(model.ok());
	CHECK(model.value().provenance.recordings == 12);
	REQUIRE(told.size() == 12);
	for (const NormalisedRecording &recording : told) {
		CHECK(recording.oddity.empty() == (recording.name != drags[3].name));
	}
}

TEST_CASE("a spoiled recording is left out of the model and named") {
	const std::vector<std::pair<std::string, std::function<void(TrainingRecording &)>>> spoilt = {
		{ "its amplitude_m is empty or not above 0", [](TrainingRecording &r) { r.task.amplitude_m = 0.0; } },
		{ "its amplitude_m is empty or not above 0",
				[](TrainingRecording &r) { r.task.amplitude_m = -0.2; } },
		{ "its reference has no frames", [](TrainingRecording &r) { r.reference.frames.clear(); } },
		{ "its reference, 0.000 .. 1.946 s, does not contain its gesture, start_s 0.300 .. end_s 2.000",
				[](TrainingRecording &r) { r.end_s = 2.0; } },
		{ "its reference, 0.000 .. 1.946 s, does not contain its gesture, start_s 0.300 .. end_s 0.300",
				[](TrainingRecording &r) { r.end_s = r.start_s; } },
		{ "its reference reaches 0.000 amplitudes, not 1: check metres, start, axis, amplitude",
				[](TrainingRecording &r) { scale(r.reference, 0.0); } },
		{ "its reference moves from 0.00 amplitudes at start_s to 0.30 at end_s, not from 0 to 1: check "
		  "times, "
		  "start, axis, amplitude",
				[](TrainingRecording &r) { scale(r.reference, 0.3); } },
		{ "its reference moves from 0.00 amplitudes at start_s to 3.00 at end_s, not from 0 to 1: check "
		  "times, "
		  "start, axis, amplitude",
				[](TrainingRecording &r) { scale(r.reference, 3.0); } },
		{ "its reference moves from -0.75 amplitudes at start_s to 0.25 at end_s, not from 0 to 1: check "
		  "times, "
		  "start, axis, amplitude",
				[](TrainingRecording &r) { r.task.start_m.x() = 0.15; } },
		{ "its measured track has no motion of index_along_axis",
				[](TrainingRecording &r) { scale(r.measured, 0.0); } },
		{ "its measured track reaches 1000 amplitudes: check metres",
				[](TrainingRecording &r) { scale(r.measured, 1000.0); } },
		{ "its measured track has a time or a tracked position that is not a finite number, at 0.100 s",
				[](TrainingRecording &r) {
					r.measured.frames[11].set(Joint::INDEX, { 0.1, NOT_A_NUMBER, 0.0 });
				} },
		{ "its reference has a time or a tracked position that is not a finite number, at nan s",
				[](TrainingRecording &r) { r.reference.frames[9].t_s = NOT_A_NUMBER; } },
	};
	for (const auto &[reason, change] : spoilt) {
		CAPTURE(reason);
		std::vector<TrainingRecording> drags = test::drag_recordings();
		change(drags[3]);
		std::vector<NormalisedRecording> told;
		GestureModel model = train("drag", "index_along_axis", drags, {}, &told).value();
		REQUIRE(told.size() == drags.size());
		CHECK(told.back().name == drags[3].name);
		CHECK(told.back().oddity == reason);
		CHECK(told.back().curve.size() == 0);
		CHECK_FALSE(told.back().kept);
		CHECK(model.provenance.dropped == std::vector<std::string>{ drags[3].name });
		drags.erase(drags.begin() + 3);
		model.provenance.dropped.clear();
		CHECK(format_model(model) == format_model(train("drag", "index_along_axis", drags, {}).value()));
	}
}

TEST_CASE("a recording whose hand is back at its end is left out") {
	// Normalised, this recording has hundreds of amplitudes. It must not dominate the mean.
	std::vector<TrainingRecording> drags = test::drag_recordings();
	for (HandFrame &frame : drags[5].reference.frames) {
		const double x_m = frame.position(Joint::INDEX).x();
		const double back_m = frame.t_s > 1.35 ? 0.1996 * std::min((frame.t_s - 1.35) / 0.3, 1.0) : 0.0;
		frame.set(Joint::INDEX, { x_m - back_m, 0.0, 0.0 });
	}
	drags[5].end_s = drags[5].reference.frames.back().t_s;
	const GestureModel model = train("drag", "index_along_axis", drags, {}).value();
	CHECK(model.provenance.recordings == 11);
	CHECK(model.provenance.dropped == std::vector<std::string>{ drags[5].name });
	CHECK(parse_model(format_model(model), "drag.gesture").ok());
}

TEST_CASE("a reference may end one frame before the gesture") {
	TrainingRecording recording = sound_drag();
	keep_until(recording.reference, recording.end_s - 1e-4);
	CHECK(unusable(*find_feature("index_along_axis"), recording).empty());
	keep_until(recording.reference, recording.end_s - 0.02);
	CHECK_FALSE(unusable(*find_feature("index_along_axis"), recording).empty());
}
