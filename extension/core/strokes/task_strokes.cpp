#include "strokes/task_strokes.h"

#include "base/parameters.h"
#include "strokes/stroke_evidence.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters::strokes;
using namespace parameters::sessions;

} // namespace

TaskStrokes::TaskStrokes(const Feature &feature, const Task &task) : amplitude_m_(task.amplitude_m) {
	if (feature.place == nullptr) {
		without_stroke_ = { .has_onset = true, .log_odds = 0.0 };
		return;
	}
	direction_ = feature.direction(task);
	start_ = feature.is_radius ? FeaturePlace(0.0, 0.0, 0.0, task.start_m.x())
							   : FeaturePlace(task.start_m.x(), task.start_m.y(), task.start_m.z(), 0.0);
}

void TaskStrokes::update(const StrokeFinder &strokes) {
	has_onset_ = is_along_axis_ = without_stroke_.has_onset;
	for (const Stroke &stroke : counted(strokes)) {
		const double along_m = (stroke.to - stroke.from).dot(direction_);
		const bool is_onset = along_m > START_VALUE * amplitude_m_ && may_begin(stroke);
		has_onset_ = has_onset_ || is_onset;
		is_along_axis_ =
				is_along_axis_ || (is_onset && along_m > PARALLEL * (stroke.to - stroke.from).norm());
	}
}

double TaskStrokes::start_distance_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	return direction_(3) != 0.0 ? std::abs(off_m.dot(direction_)) : off_m.norm(); // a radius has no position
}

double TaskStrokes::path_distance_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	const double along_m = std::clamp(off_m.dot(direction_), 0.0, amplitude_m_);
	return direction_(3) != 0.0 ? 0.0 : (off_m - along_m * direction_).norm();
}

void TaskStrokes::begin() {
	best_of_one_ = of_all_ = NO_STROKE;
	earlier_.reset();
	last_.reset();
}

void TaskStrokes::add(const StrokeFinder &strokes) {
	if (strokes.strokes().empty() || !counts(strokes.strokes().front())) {
		return;
	}
	const Stroke &now = strokes.strokes().front();
	if (last_ && has_ended_ &&
			now.onset_s != last_->onset_s) { // the onset of a present stroke may still change
		earlier_ = earlier_ ? joined(*earlier_, *last_) : *last_;
	}
	last_ = now;
	has_ended_ = strokes.ended();
}

bool TaskStrokes::may_begin(const Stroke &stroke) const {
	return LOG_PRIOR_TASK + max_task_evidence(stroke, start_, direction_, amplitude_m_) > 0.0;
}

double TaskStrokes::log_odds(const Stroke &stroke) const {
	return LOG_PRIOR_TASK + task_evidence(stroke, start_, direction_, amplitude_m_);
}

double TaskStrokes::judge(const StrokeFinder &strokes) {
	double best = without_stroke_.log_odds;
	best_of_one_ = std::max(best_of_one_, best);
	for (const Stroke &stroke : counted(strokes)) {
		const double of_this = log_odds(stroke);
		best = std::max(best, of_this);
		if ((stroke.to - stroke.from).norm() > UNDER_WAY * amplitude_m_) {
			best_of_one_ = std::max(best_of_one_, of_this);
		}
	}
	if (earlier_ && last_) {
		of_all_ = log_odds(joined(*earlier_, *last_));
		best = std::max(best, of_all_);
	}
	return best;
}

double TaskStrokes::best_log_odds() const {
	return std::max(best_of_one_, of_all_);
}

} // namespace steadyhand
