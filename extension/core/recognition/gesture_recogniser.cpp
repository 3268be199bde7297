#include "recognition/gesture_recogniser.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

/// Longest gap that is stepped through symbol by symbol. A jump of the clock must not take long.
constexpr double LONGEST_GAP_S = 10.0;

} // namespace

void GestureRecogniser::set_completion(double share) {
	completion_ = share;
	for (const std::unique_ptr<GestureSession> &session : sessions_) {
		session->set_completion(share);
	}
}

void GestureRecogniser::push(const HandFrame &frame) {
	if (!(std::abs(frame.t_s) <= FARTHEST_S) || frame.t_s < time_s_ || frame.repeats(last_frame_)) {
		return;
	}
	last_frame_ = frame;
	// Steps before this frame must not use it.
	step_sessions(std::nextafter(frame.t_s, -INFINITY));
	for (FeatureTrack &track : tracks_) {
		track.push(frame);
	}
	start_condition_.push(frame);
	if (spotter_) {
		spotter_->push(frame);
	}
	const std::optional<Motion> before = show_nearest(frame.t_s);
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (sessions_[i]->push(frame, track(i))) {
			filtered_[i].push(frame.t_s, sessions_[i]->measured_m());
		}
	}
	time_s_ = frame.t_s;
	if (before) {
		blend_from(*before, CHANGE_BLEND_PER_S);
	}
	update_gestures();
}

void GestureRecogniser::advance(double t_s) {
	if (!(t_s > time_s_) || t_s > FARTHEST_S) {
		return;
	}
	step_sessions(t_s);
	time_s_ = t_s;
}

void GestureRecogniser::step_sessions(double t_s) {
	if (time_s_ == -INFINITY) {
		clock_.start(t_s);
	} else if (t_s - clock_.next_s() > LONGEST_GAP_S) {
		clock_.start(t_s - LONGEST_GAP_S);
	}
	for (; clock_.due(t_s); clock_.advance()) {
		time_s_ = clock_.next_s();
		for (std::size_t i = 0; i < sessions_.size(); ++i) {
			sessions_[i]->step(time_s_, track(i));
		}
		update_gestures();
	}
}

void GestureRecogniser::update_gestures() {
	judge_starts();
	decide_ends();
	choose_leader();
}

double GestureRecogniser::posterior(std::size_t session) const {
	// With the larger of these odds and 0 factored out, neither overflows.
	const double odds = log_odds(session), largest = std::max(odds, 0.0);
	double all = std::exp(-largest);
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (i == session || sessions_[i]->stage() == GestureSession::Stage::ACTIVE) {
			all += std::exp(log_odds(i) - largest);
		}
	}
	return std::exp(odds - largest) / all;
}

double GestureRecogniser::confidence() const {
	return leader_ >= 0 ? posterior(shown()) : 0.0;
}

bool GestureRecogniser::may_show(std::size_t session) const {
	const bool is_likely =
			min_confidence_ <= 0.0 || gestures_[session].task || posterior(session) >= min_confidence_;
	return is_likely && starts_[session].is_allowed;
}

void GestureRecogniser::judge_starts() {
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		GestureSession &session = *sessions_[i];
		Start &start = starts_[i];
		if (session.started_s() != start.onset_s) {
			start = { session.started_s(), start_condition_.may_begin(session.started_s()) };
		} else if (start.is_allowed && start_condition_.is_released() &&
				session.stage() == GestureSession::Stage::ACTIVE) {
			start.is_allowed = false;
			session.abort(time_s_);
		}
	}
}

bool GestureRecogniser::ends_off_path(std::size_t one, std::size_t other) const {
	const std::optional<Task> &task = gestures_[one].task, &other_task = gestures_[other].task;
	const auto is_straight = [this](std::size_t i) {
		const Feature &feature = track(i).feature();
		return feature.direction != nullptr && !feature.is_radius;
	};
	if (!task || !other_task || !is_straight(one) || !is_straight(other)) {
		return false;
	}
	const auto end_m = [](const Task &of) { return of.start_m + of.amplitude_m * of.axis; };
	const Eigen::Vector3d apart_m = end_m(*other_task) - end_m(*task);
	const double along_m = apart_m.dot(task->axis);
	return (apart_m - along_m * task->axis).norm() > std::abs(along_m);
}

void GestureRecogniser::decide_ends() {
	const int ended = likeliest([&](std::size_t i) { return sessions_[i]->may_end(); });
	if (ended < 0) {
		return;
	}
	const auto best = static_cast<std::size_t>(ended);
	const int task = likeliest([&](std::size_t i) { return sessions_[i]->is_near_end(); });
	// A likelier gesture with a task, near its end, ends by itself.
	const bool is_of_task = task >= 0 && log_odds(static_cast<std::size_t>(task)) > log_odds(best);
	if (is_of_task || log_odds(best) <= 0.0 || !may_show(best)) {
		sessions_[best]->abort(time_s_);
		return;
	}
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (i == best) {
			sessions_[i]->end_gesture(time_s_);
		} else {
			sessions_[i]->abort(time_s_);
		}
	}
	set_leader(ended);
}

} // namespace steadyhand
