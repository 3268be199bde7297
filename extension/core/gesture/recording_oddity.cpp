#include "gesture/recording_oddity.h"

#include "gesture/recorded_movements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace steadyhand {
namespace {

/// How far a hand may go, in units of the task's amplitude.
constexpr double SHORTEST_WAY = 0.1, LONGEST_WAY = 5.0;
/// And how far its tracker may err.
constexpr double FARTHEST_SEEN = 50.0;
/// A measured track may end so much before the gesture does.
constexpr double SHORT_S = 0.1;
/// Nor does it last so many times as long as its reference.
constexpr double LONGEST_TRACK = 10.0;

/// Of a feature between two instants, in units of the task's amplitude.
struct Way {
	double highest = -INFINITY;
	double farthest = 0.0; ///< from 0, to either side
};

Way way_of(const Feature &feature, const TrainingRecording &recording, const Track &track, double from_s,
		double to_s) {
	Way way;
	const RecordedCurve curve = recorded_motion(feature, recording, track);
	for (std::size_t i = 0; i < curve.t_s.size(); ++i) {
		if (curve.t_s[i] >= from_s && curve.t_s[i] <= to_s) {
			const double x = curve.x_m[i] / recording.task.amplitude_m;
			way.highest = std::max(way.highest, x);
			way.farthest = std::max(way.farthest, std::abs(x));
		}
	}
	return way;
}

std::string text(const char *format, double value, double other = 0.0) {
	std::array<char, 400> line{};
	const int length = std::snprintf(line.data(), line.size(), format, value, other);
	return { line.data(), std::min(static_cast<std::size_t>(std::max(length, 0)), line.size() - 1) };
}

double length_s(const Track &track) {
	return track.frames.back().t_s - track.frames.front().t_s;
}

} // namespace

std::string oddity(const Feature &feature, const TrainingRecording &recording) {
	const std::vector<HandFrame> &seen = recording.measured.frames, &true_frames = recording.reference.frames;
	if (true_frames.empty()) {
		return "its reference has no frames";
	}
	// A hand may come back before the gesture's end.
	const Way way = way_of(feature, recording, recording.reference, -INFINITY, recording.end_s);
	if (way.highest < SHORTEST_WAY || way.highest > LONGEST_WAY) {
		return std::isfinite(way.highest) ? text("its reference goes to %.3f of the way, not to 1: check "
												 "metres, start, axis, amplitude",
													way.highest)
										  : "its reference holds nothing of " + std::string(feature.name);
	}
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
	const double farthest =
			way_of(feature, recording, recording.measured, true_frames.front().t_s, true_frames.back().t_s)
					.farthest;
	if (farthest == 0.0) { // no sensor says 0 all the way of a hand that is there
		return "the hand is never seen to move by " + std::string(feature.name);
	}
	if (farthest > FARTHEST_SEEN) {
		return text("its measured track goes to %.0f of the way: check metres", farthest);
	}
	if (seen.back().t_s < recording.end_s - SHORT_S) {
		return text("its measured track ends at %.3f s, before the gesture does, at %.3f s", seen.back().t_s,
				recording.end_s);
	}
	return {};
}

} // namespace steadyhand
