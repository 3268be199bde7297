#include "gesture/recorded_movements.h"

#include "gesture/motion_element.h"
#include "gesture/symbol_clock.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Of a recording whose gesture has no length, or no end, or is not wholly where its reference can show it.
std::optional<std::string> recording_error(const TrainingRecording &recording) {
	constexpr double ROUNDING_S = 1e-6; // stamps are decimal text
	if (!(recording.task.amplitude_m >= SMALLEST_AMPLITUDE_M)) {
		return recording.name + ": its amplitude_m is empty or not above 0";
	}
	const std::vector<HandFrame> &frames = recording.reference.frames;
	if (frames.empty()) {
		return recording.name + ": its reference has no frames";
	}
	const bool is_within = recording.start_s < recording.end_s &&
			recording.start_s >= frames.front().t_s - ROUNDING_S &&
			recording.end_s <= frames.back().t_s + ROUNDING_S;
	if (!is_within) {
		return recording.name + ": start_s " + std::to_string(recording.start_s) + " .. end_s " +
				std::to_string(recording.end_s) + " is not within its reference, " +
				std::to_string(frames.front().t_s) + " .. " + std::to_string(frames.back().t_s) + " s";
	}
	if (recording.end_s - recording.start_s > LONGEST_GESTURE_S) {
		return recording.name + ": its gesture takes " + std::to_string(recording.end_s - recording.start_s) +
				" s, and " + std::to_string(static_cast<int>(LONGEST_GESTURE_S)) +
				" are the most; start_s, end_s and t are seconds";
	}
	return std::nullopt;
}

} // namespace

RecordedCurve recorded_motion(
		const Feature &feature, const TrainingRecording &recording, const Track &track) {
	RecordedCurve curve;
	MotionElement element(feature);
	for (const HandFrame &frame : track.frames) {
		if (frame.t_s <= recording.start_s) {
			element.restart();
		}
		const std::optional<double> x_m = element.measure(frame, recording.task);
		if (x_m && (curve.t_s.empty() || frame.t_s > curve.t_s.back())) {
			curve.t_s.push_back(frame.t_s);
			curve.x_m.push_back(*x_m);
		}
	}
	return curve;
}

Result<RecordedMovements> recorded_movements(
		const Feature &feature, std::span<const TrainingRecording> recordings) {
	RecordedMovements recorded;
	for (const TrainingRecording &recording : recordings) {
		if (std::optional<std::string> fault = recording_error(recording)) {
			return Error{ std::move(*fault) };
		}
		const RecordedCurve curve = recorded_motion(feature, recording, recording.reference);
		if (curve.t_s.size() < 2) {
			continue;
		}
		const MovementSpan span = movement_span(curve, recording.start_s, recording.end_s);
		Eigen::VectorXd normalised = normalised_curve(curve, span);
		if (!normalised.isZero(0.0)) {
			recorded.movements.push_back({ &recording, span });
			recorded.curves.push_back(std::move(normalised));
		}
	}
	if (recorded.movements.empty()) {
		return Error{ "the feature '" + std::string(feature.name) + "' moves in none of the " +
			std::to_string(recordings.size()) + " recordings" };
	}
	return recorded;
}

std::vector<std::optional<Observation>> observe(
		const Feature &feature, const Movement &movement, double duration_mean_s) {
	const TrainingRecording &recording = *movement.recording;
	std::vector<std::optional<Observation>> observations;
	ObservationWindow window;
	MotionElement element(feature);
	SymbolClock clock;
	clock.start(movement.span.onset_s);
	bool fresh = false;
	const auto tick_until = [&](double t_s) {
		while (clock.due(std::min(t_s, movement.span.end_s))) {
			observations.push_back(fresh
							? std::optional(window.normalised(recording.task.amplitude_m, duration_mean_s))
							: std::nullopt);
			fresh = false;
			clock.advance();
		}
	};
	for (const HandFrame &frame : recording.measured.frames) {
		// An instant before this frame saw only the frames before it.
		tick_until(std::nextafter(frame.t_s, -INFINITY));
		if (frame.t_s <= movement.span.onset_s) {
			element.restart();
		}
		if (const std::optional<double> x_m = element.measure(frame, recording.task)) {
			window.push(frame.t_s, *x_m);
			fresh = true;
		}
	}
	tick_until(movement.span.end_s);
	return observations;
}

} // namespace steadyhand
