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
		unseen_ = { .has_set_out = true, .log_odds = 0.0 };
		return;
	}
	way_ = feature.direction(task);
	start_ = feature.is_radius ? FeaturePlace(0.0, 0.0, 0.0, task.start_m.x())
							   : FeaturePlace(task.start_m.x(), task.start_m.y(), task.start_m.z(), 0.0);
}

void TaskStrokes::look(const StrokeFinder &strokes) {
	has_set_out_ = heads_along_ = unseen_.has_set_out;
	for (const Stroke &stroke : counted(strokes)) {
		const double gone_m = (stroke.to - stroke.from).dot(way_);
		const bool sets_out = gone_m > SMALLEST_MOVE * amplitude_m_ && may_begin(stroke);
		has_set_out_ = has_set_out_ || sets_out;
		heads_along_ = heads_along_ || (sets_out && gone_m > ALONG * (stroke.to - stroke.from).norm());
	}
}

double TaskStrokes::off_start_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	return way_(3) != 0.0 ? std::abs(off_m.dot(way_)) : off_m.norm(); // a radius has no place
}

double TaskStrokes::off_way_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	const double along_m = std::clamp(off_m.dot(way_), 0.0, amplitude_m_);
	return way_(3) != 0.0 ? 0.0 : (off_m - along_m * way_).norm();
}

void TaskStrokes::begin() {
	best_of_one_ = of_all_ = NO_STROKE;
	before_last_.reset();
	last_.reset();
}

void TaskStrokes::add(const StrokeFinder &strokes) {
	if (strokes.strokes().empty() || !counts(strokes.strokes().front())) {
		return;
	}
	const Stroke &now = strokes.strokes().front();
	if (last_ && has_ended_ && now.onset_s != last_->onset_s) { // while it goes on its onset is refined
		before_last_ = before_last_ ? joined(*before_last_, *last_) : *last_;
	}
	last_ = now;
	has_ended_ = strokes.ended();
}

bool TaskStrokes::may_begin(const Stroke &stroke) const {
	return LOG_PRIOR_TASK + most_task_evidence(stroke, start_, way_, amplitude_m_) > 0.0;
}

double TaskStrokes::log_odds(const Stroke &stroke) const {
	return LOG_PRIOR_TASK + task_evidence(stroke, start_, way_, amplitude_m_);
}

double TaskStrokes::judge(const StrokeFinder &strokes) {
	double best = unseen_.log_odds;
	best_of_one_ = std::max(best_of_one_, best);
	for (const Stroke &stroke : counted(strokes)) {
		const double of_this = log_odds(stroke);
		best = std::max(best, of_this);
		if ((stroke.to - stroke.from).norm() > LONG_ENOUGH * amplitude_m_) {
			best_of_one_ = std::max(best_of_one_, of_this);
		}
	}
	if (before_last_ && last_) {
		of_all_ = log_odds(joined(*before_last_, *last_));
		best = std::max(best, of_all_);
	}
	return best;
}

double TaskStrokes::best_log_odds() const {
	return std::max(best_of_one_, of_all_);
}

} // namespace steadyhand
