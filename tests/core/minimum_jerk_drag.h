#pragma once

#include "gesture/reference_curve.h"
#include "gesture/trainer.h"

#include <algorithm>
#include <string>
#include <vector>

namespace steadyhand::test {

/// A drag along x whose truth is known in closed form (Flash & Hogan 1985): 10 s^3 - 15 s^4 + 6 s^5.
struct Drag {
	double onset_s = 0.5;
	double duration_s = 1.0;
	double amplitude_m = 0.2;

	[[nodiscard]] double x_m(double t_s) const {
		const double s = std::clamp((t_s - onset_s) / duration_s, 0.0, 1.0);
		return amplitude_m * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
	}
};

inline Track drag_track(const Drag &drag, double rate_hz, double length_s) {
	Track track;
	for (int i = 0; i < static_cast<int>(length_s * rate_hz); ++i) {
		HandFrame &frame = track.frames.emplace_back();
		frame.t_s = i / rate_hz;
		frame.set(Joint::INDEX, { drag.x_m(frame.t_s), 0.0, 0.0 });
	}
	return track;
}

inline RecordedCurve minimum_jerk_curve(const Drag &drag, double rate_hz) {
	RecordedCurve curve;
	for (const HandFrame &frame : drag_track(drag, rate_hz, drag.onset_s + drag.duration_s + 0.5).frames) {
		curve.t_s.push_back(frame.t_s);
		curve.x_m.push_back(frame.position(Joint::INDEX).x());
	}
	return curve;
}

/// Twelve drags of 0.8 to 1.35 s.
inline std::vector<TrainingRecording> drag_recordings() {
	std::vector<TrainingRecording> recordings;
	for (int i = 0; i < 12; ++i) {
		const Drag drag{ .onset_s = 0.5, .duration_s = 0.8 + 0.05 * i, .amplitude_m = 0.2 };
		const double end_s = drag.onset_s + drag.duration_s;
		recordings.push_back({ "drag" + std::to_string(i), Task{}, 0.3, end_s,
				drag_track(drag, 110.0, end_s + 0.5), drag_track(drag, 240.0, end_s + 0.5) });
	}
	return recordings;
}

inline GestureModel trained_drag_model() {
	return train("drag", "index_along_axis", drag_recordings(), {}).value();
}

} // namespace steadyhand::test
