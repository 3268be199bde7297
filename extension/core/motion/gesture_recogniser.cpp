#include "motion/gesture_recogniser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {

GestureRecogniser::GestureRecogniser(std::vector<std::shared_ptr<const GestureModel>> models,
		const std::optional<Task> &task, MotionMode mode) :
		models_(std::move(models)),
		filtered_(models_.size()), time_s_(-std::numeric_limits<double>::infinity()) {
	followers_.reserve(models_.size());
	for (const std::shared_ptr<const GestureModel> &model : models_) {
		followers_.emplace_back(*model, task.value_or(model->typical_task), task.has_value(), mode);
	}
}

void GestureRecogniser::push(const HandFrame &frame) {
	if (!std::isfinite(frame.t_s) || frame.t_s < time_s_) {
		return;
	}
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (followers_[i].push(frame)) {
			filtered_[i].push(frame.t_s, followers_[i].measured_m());
		}
	}
	time_s_ = frame.t_s;
	choose_leader();
}

void GestureRecogniser::advance(double t_s) {
	if (!(t_s > time_s_)) {
		return;
	}
	for (GestureFollower &follower : followers_) {
		follower.advance(t_s);
	}
	time_s_ = t_s;
	choose_leader();
}

void GestureRecogniser::choose_leader() {
	const bool over = leader_ < 0 || follower()->stage() == GestureFollower::Stage::RESTING;
	int best = -1;
	double best_likelihood = -std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		const GestureFollower &candidate = followers_[i];
		if (candidate.stage() != GestureFollower::Stage::RESTING &&
				candidate.mean_log_likelihood() > best_likelihood) {
			best = static_cast<int>(i);
			best_likelihood = candidate.mean_log_likelihood();
		}
	}
	// A gesture that has arrived keeps its end; one that is moving yields to a likelier one.
	if (over || follower()->stage() == GestureFollower::Stage::MOVING) {
		leader_ = best;
	}
}

Motion GestureRecogniser::motion(MotionSource source) const {
	if (followers_.empty()) {
		return {};
	}
	// While all rest, the first model's motion element is the one that is shown.
	const auto shown = static_cast<std::size_t>(std::max(leader_, 0));
	const GestureFollower &follower = followers_[shown];
	if (source == MotionSource::SYNTHESISED) {
		return follower.motion(time_s_);
	}
	const double value_m = filtered_[shown].value_m(source);
	return { value_m, 0.0, 0.0, std::clamp(value_m / follower.task().amplitude_m, 0.0, 1.0) };
}

} // namespace steadyhand
