#include "gesture/recording_oddity.h"

#include "gesture/gesture_model.h"
#include "gesture/recorded_movements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace steadyhand {
namespace {

// Lengths are in amplitudes of the task.

/// Limits of the greatest value of a reference.
constexpr double LEAST_REACH = 0.1, MOST_REACH = 5.0;
/// Limit of |value| of a measured track.
constexpr double FARTHEST_MEASURED = 50.0;
/// Limits of |value| at the start, and of the travel from start_s to end_s.
constexpr double BESIDE_START = 0.5, LEAST_TRAVEL = 0.5, MOST_TRAVEL = 2.0;
/// A gesture may exceed its reference by this many frame intervals.
constexpr double CUT_OFF = 1.5;
/// A measured track may end this long before the gesture.
constexpr double SHORT_S = 0.1;
/// Limit of the measured track's length, in lengths of the reference.
constexpr double LONGEST_TRACK = 10.0;

/// Range of a feature between two times.
struct ValueRange {
	double highest = -INFINITY, lowest = INFINITY;

	/// Greatest |value|.
	[[nodiscard]] double farthest() const { return std::max(highest, -lowest); }
	/// All values have equal bits. A sensor that tracks a hand has noise.
	[[nodiscard]] bool is_still() const { return !(highest > lowest); }
};

ValueRange range_of(const RecordedCurve &curve, double amplitude_m, double from_s, double to_s) {
	ValueRange range;
	for (std::size_t i = 0; i < curve.t_s.size(); ++i) {
		if (curve.t_s[i] >= from_s && curve.t_s[i] <= to_s) {
			const double x = curve.x_m[i] / amplitude_m;
			range.highest = std::max(range.highest, x);
			range.lowest = std::min(range.lowest, x);
		}
	}
	return range;
}

std::string text(const char *format, double value, double other = 0.0) {
	std::array<char, 400> line{};
	const int length = std::snprintf(line.data(), line.size(), format, value, other);
	return { line.data(), std::min(static_cast<std::size_t>(std::max(length, 0)), line.size() - 1) };
}

/// Rounds to hundredths, without -0.
double shown(double x) {
	return std::round(100.0 * x) / 100.0 + 0.0;
}

double length_s(const Track &track) {
	return track.frames.back().t_s - track.frames.front().t_s;
}

/// reference: recorded_motion() of the reference. The greatest value counts, because a hand may return before
/// the gesture's end.
std::string reference_oddity(
		const Feature &feature, const TrainingRecording &recording, const RecordedCurve &reference) {
	if (recording.reference.frames.empty()) {
		return "its reference has no frames";
	}
	const ValueRange range = range_of(reference, recording.task.amplitude_m, -INFINITY, recording.end_s);
	if (!std::isfinite(range.highest)) {
		return "its reference has no values of " + std::string(feature.name);
	}
	const bool is_one = range.highest >= LEAST_REACH && range.highest <= MOST_REACH;
	return is_one ? ""
				  : text("its reference reaches %.3f amplitudes, not 1: check metres, start, axis, amplitude",
							range.highest);
}

/// The reference must have frames.
std::string measured_oddity(const Feature &feature, const TrainingRecording &recording) {
	const std::vector<HandFrame> &seen = recording.measured.frames, &true_frames = recording.reference.frames;
	if (seen.empty()) {
		return "its measured track has no frames";
	}
	if (length_s(recording.measured) > LONGEST_TRACK * length_s(recording.reference)) {
		return text("its measured track lasts %.1f s, its reference %.1f s: check seconds",
				length_s(recording.measured), length_s(recording.reference));
	}
	if (seen.front().t_s > recording.end_s) {
		return text("its measured track begins at %.3f s, after the gesture's end at %.3f s",
				seen.front().t_s, recording.end_s);
	}
	const ValueRange range = range_of(recorded_motion(feature, recording, recording.measured),
			recording.task.amplitude_m, true_frames.front().t_s, true_frames.back().t_s);
	if (range.is_still()) {
		return "its measured track has no motion of " + std::string(feature.name);
	}
	if (range.farthest() > FARTHEST_MEASURED) {
		return text("its measured track reaches %.0f amplitudes: check metres", range.farthest());
	}
	return {};
}

/// Tracks from a file have only finite numbers. Tracks from a caller may have others.
std::string number_fault(const Track &track, const char *whose) {
	for (const HandFrame &frame : track.frames) {
		bool is_sound = std::isfinite(frame.t_s);
		for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
			is_sound = is_sound && (!frame.has(static_cast<Joint>(i)) || is_place(frame.positions_m[i]));
		}
		if (!is_sound) {
			return std::string(whose) +
					text(" has a time or a tracked position that is not a finite number, at %.3f s",
							frame.t_s);
		}
	}
	return {};
}

/// Faults of amplitude, start_s and end_s.
std::string span_fault(const TrainingRecording &recording) {
	if (!(recording.task.amplitude_m >= SMALLEST_AMPLITUDE_M)) {
		return "its amplitude_m is empty or not above 0";
	}
	const std::vector<HandFrame> &frames = recording.reference.frames;
	if (frames.empty()) {
		return "its reference has no frames";
	}
	const double first_s = frames.front().t_s, last_s = frames.back().t_s;
	const double cut_s = CUT_OFF * (last_s - first_s) / static_cast<double>(frames.size());
	const bool is_within = recording.start_s < recording.end_s && recording.start_s >= first_s - cut_s &&
			recording.end_s <= last_s + cut_s;
	if (!is_within) {
		return text("its reference, %.3f .. %.3f s, ", first_s, last_s) +
				text("does not contain its gesture, start_s %.3f .. end_s %.3f", recording.start_s,
						recording.end_s);
	}
	if (recording.end_s - recording.start_s > LONGEST_GESTURE_S) {
		return text("its gesture takes %.0f s, and %.0f are the most; start_s, end_s and t are seconds",
				recording.end_s - recording.start_s, LONGEST_GESTURE_S);
	}
	return {};
}

} // namespace

std::string oddity(const Feature &feature, const TrainingRecording &recording) {
	const RecordedCurve reference = recorded_motion(feature, recording, recording.reference);
	if (std::string fault = reference_oddity(feature, recording, reference); !fault.empty()) {
		return fault;
	}
	const double nearest = range_of(reference, recording.task.amplitude_m, -INFINITY, recording.end_s).lowest;
	if (nearest > BESIDE_START) {
		return text("its reference comes no nearer to its start than %.2f amplitudes: check start, axis, "
					"amplitude",
				nearest);
	}
	if (std::string fault = measured_oddity(feature, recording); !fault.empty()) {
		return fault;
	}
	return early_end(recording);
}

std::string early_end(const TrainingRecording &recording) {
	const double seen_to_s = recording.measured.frames.back().t_s;
	return seen_to_s < recording.end_s - SHORT_S
			? text("its measured track ends at %.3f s, before the gesture does, at %.3f s", seen_to_s,
					  recording.end_s)
			: "";
}

std::string unusable(const Feature &feature, const TrainingRecording &recording) {
	for (std::string fault : { number_fault(recording.measured, "its measured track"),
				 number_fault(recording.reference, "its reference") }) {
		if (!fault.empty()) {
			return fault;
		}
	}
	if (std::string fault = span_fault(recording); !fault.empty()) {
		return fault;
	}
	const RecordedCurve reference = recorded_motion(feature, recording, recording.reference);
	if (std::string fault = reference_oddity(feature, recording, reference); !fault.empty()) {
		return fault;
	}
	const double from = value_at(reference, recording.start_s) / recording.task.amplitude_m;
	const double to = value_at(reference, recording.end_s) / recording.task.amplitude_m;
	const bool is_complete =
			std::abs(from) <= BESIDE_START && to - from >= LEAST_TRAVEL && to - from <= MOST_TRAVEL;
	return is_complete
			? measured_oddity(feature, recording)
			: text("its reference moves from %.2f amplitudes at start_s to %.2f at end_s, not from "
				   "0 to 1: check times, start, axis, amplitude",
					  shown(from), shown(to));
}

} // namespace steadyhand
