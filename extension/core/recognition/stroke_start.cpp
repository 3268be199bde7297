#include "recognition/stroke_start.h"

#include <limits>
#include <optional>

namespace steadyhand {
namespace {

constexpr double SAME_STEP_M = 0.005; ///< between steps of a tracker that are the same
constexpr double REST_PART_S = 0.05;  ///< in whose mean a tracker's noise counts little

/// The tracker's step while the hand rested before the stroke, if it is the same by now.
struct StepAtRest {
	bool is_back = false;
	FeaturePlace step_m = FeaturePlace::Zero();
	FeaturePlace at_onset_m = FeaturePlace::Zero(); ///< what it was meanwhile
};

StepAtRest step_at_rest(const Stroke &stroke, const StrokeFinder &strokes) {
	std::optional<FeaturePlace> at_rest;
	FeaturePlace at_onset = FeaturePlace::Zero(), now = at_onset;
	strokes.frames_since(stroke.onset_s - Stroke::REST_S,
			[&](double frame_s, const FeaturePlace & /*place*/, const FeaturePlace &step) {
				if (!step.hasNaN() && (at_rest || frame_s <= stroke.onset_s)) {
					at_rest = at_rest.value_or(step);
					at_onset = frame_s <= stroke.onset_s ? step : at_onset;
					now = step;
				}
			});
	if (!at_rest || (now - *at_rest).norm() >= SAME_STEP_M) {
		return {};
	}
	return { true, *at_rest, at_onset };
}

/// The mean place in a part of the rest, without the furthest back of several, which may be a single frame
/// that is elsewhere.
class RestPart {
public:
	void add(const FeaturePlace &place, const FeaturePlace &way) {
		const bool is_behind = count_ == 0 || (place - furthest_back_).dot(way) < 0.0;
		furthest_back_ = is_behind ? place : furthest_back_;
		sum_ += place;
		++count_;
	}
	[[nodiscard]] bool empty() const { return count_ == 0; }
	[[nodiscard]] FeaturePlace mean() const {
		return count_ > 2 ? FeaturePlace((sum_ - furthest_back_) / (count_ - 1))
						  : FeaturePlace(sum_ / count_);
	}

private:
	FeaturePlace sum_ = FeaturePlace::Zero(), furthest_back_ = FeaturePlace::Zero();
	int count_ = 0;
};

} // namespace

FeaturePlace start_of(const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) {
	const StepAtRest rest = step_at_rest(stroke, strokes);
	FeaturePlace start = stroke.seen_from;
	if (rest.is_back) {
		start -= rest.at_onset_m - rest.step_m;
	}
	RestPart part;
	double since_s = -std::numeric_limits<double>::infinity();
	const auto end_part = [&] {
		if (!part.empty() && (part.mean() - start).dot(way) < 0.0) {
			start = part.mean();
		}
		part = {};
	};
	strokes.frames_since(stroke.onset_s - BEFORE_ONSET_S,
			[&](double frame_s, const FeaturePlace &seen, const FeaturePlace &step) {
				if (frame_s > stroke.onset_s || step.hasNaN()) {
					return;
				}
				if (frame_s > since_s + REST_PART_S) {
					end_part();
					since_s = frame_s;
				}
				part.add(rest.is_back ? FeaturePlace(seen - (step - rest.step_m)) : seen, way);
			});
	end_part();
	return start;
}

} // namespace steadyhand
