#include "gesture/feature_choice.h"

#include "gesture/motion_element.h"
#include "gesture/recording_oddity.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double WORST_ACCEPTED = 0.5;

/// |travel - amplitude| / amplitude by a feature, at most 1. It is 1 if the feature has no value.
double error_of(const Feature &feature, const TrainingRecording &recording) {
	MotionElement element(feature);
	bool is_seen = false;
	double start_m = 0.0, end_m = 0.0;
	for (const HandFrame &frame : recording.reference.frames) {
		if (frame.t_s > recording.end_s) {
			break;
		}
		if (frame.t_s <= recording.start_s) {
			element.restart();
		}
		if (const std::optional<double> x_m = element.measure(frame, recording.task)) {
			end_m = *x_m;
			start_m = frame.t_s <= recording.start_s || !is_seen ? *x_m : start_m;
			is_seen = true;
		}
	}
	const double amplitude_m = recording.task.amplitude_m;
	return is_seen ? std::min(std::abs(end_m - start_m - amplitude_m) / amplitude_m, 1.0) : 1.0;
}

} // namespace

const Feature *choose_feature(std::span<const TrainingRecording> recordings) {
	const Feature *best = nullptr;
	double least = WORST_ACCEPTED * static_cast<double>(recordings.size());
	for (const Feature &feature : features()) {
		double sum = 0.0;
		for (const TrainingRecording &recording : recordings) {
			sum += error_of(feature, recording);
		}
		if (sum < least) {
			least = sum;
			best = &feature;
		}
	}
	return best;
}

std::string no_feature_reason(std::span<const TrainingRecording> recordings) {
	const TrainingRecording &first = recordings.front();
	const auto holds = [&first](const Feature &feature) {
		return std::ranges::any_of(first.reference.frames,
				[&](const HandFrame &frame) { return feature.measure(frame, first.task).has_value(); });
	};
	const auto held = std::ranges::find_if(features(), holds);
	if (held == features().end()) {
		return first.name + ": its reference has the joints of no feature";
	}
	return first.name + ": by " + std::string(held->name) + ", " + unusable(*held, first);
}

} // namespace steadyhand
