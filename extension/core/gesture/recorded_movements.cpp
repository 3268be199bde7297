#include "gesture/recorded_movements.h"

#include "gesture/motion_element.h"
#include "gesture/recording_oddity.h"
#include "gesture/symbol_clock.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

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
		if (std::string reason = unusable(feature, recording); !reason.empty()) {
			recorded.left_out.push_back({ &recording, std::move(reason) });
			continue;
		}
		const RecordedCurve curve = recorded_motion(feature, recording, recording.reference);
		const MovementSpan span = movement_span(curve, recording.start_s, recording.end_s);
		recorded.movements.push_back({ &recording, span });
		recorded.curves.push_back(normalised_curve(curve, span));
	}
	if (recordings.empty()) {
		return Error{ "there are no recordings" };
	}
	if (recorded.movements.empty()) {
		const LeftOut &first = recorded.left_out.front();
		return Error{ "none of the " + std::to_string(recordings.size()) + " recordings is usable; " +
			first.recording->name + ": " + first.reason };
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
		// Instants before this frame use only earlier frames.
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
