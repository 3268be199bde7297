#include "recognition/gesture_recogniser.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

/// The point for TrackerMonitor. For a radius: x and y of the fingertips' mean, and the radius. place: of the
/// feature in the frame.
std::optional<Eigen::Vector3d> tracked_point(
		const Feature &feature, const std::optional<FeaturePlace> &place, const HandFrame &frame) {
	if (place) {
		return feature.is_radius ? Eigen::Vector3d(place->x(), place->y(), place->w())
								 : Eigen::Vector3d(place->head<3>());
	}
	return feature.place == nullptr && frame.has(Joint::INDEX) ? std::optional(frame.position(Joint::INDEX))
															   : std::nullopt;
}

} // namespace

void GestureRecogniser::WatchedFeature::push(const HandFrame &frame) {
	place = feature->place != nullptr ? feature->place(frame) : std::nullopt;
	measurement = { .t_s = frame.t_s };
	if (const std::optional<Eigen::Vector3d> point_m = tracked_point(*feature, place, frame);
			point_m && point_m->allFinite()) {
		measurement = monitor.push(frame.t_s, *point_m);
	}
	if (place && !place->allFinite()) {
		place.reset();
	}
	if (place) {
		const Eigen::Vector3d &offset_m = measurement.displacement_m;
		displacement_m = feature->is_radius ? FeaturePlace(offset_m.x(), offset_m.y(), 0.0, offset_m.z())
											: FeaturePlace(offset_m.x(), offset_m.y(), offset_m.z(), 0.0);
		strokes.push(measurement, *place, displacement_m);
	}
}

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
	advance_sessions(std::nextafter(frame.t_s, -INFINITY));
	for (WatchedFeature &watched : watched_) {
		watched.push(frame);
	}
	start_condition_.push(frame);
	if (spotter_) {
		spotter_->push(frame);
	}
	const std::optional<Motion> before = show_nearest(frame.t_s);
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (sessions_[i]->push(frame, watched(i).hand(), watched(i).strokes, watched(i).measurement)) {
			filtered_[i].push(frame.t_s, sessions_[i]->measured_m());
		}
	}
	time_s_ = frame.t_s;
	if (before) {
		blend_from(*before, CHANGE_BLEND_PER_S);
	}
	schedule_dropout();
	judge_starts();
	abort_parts();
	decide_ends();
	choose_leader();
}

void GestureRecogniser::advance(double t_s) {
	if (!(t_s > time_s_) || t_s > FARTHEST_S) {
		return;
	}
	advance_sessions(t_s);
	time_s_ = t_s;
	judge_starts();
	choose_leader();
}

void GestureRecogniser::schedule_dropout() {
	next_dropout_s_ = INFINITY;
	for (const WatchedFeature &watched : watched_) {
		for (const double dropout_s : GestureSession::DROPOUTS_S) {
			const double due_s = watched.strokes.last_measurement_s() + dropout_s;
			const bool is_to_come = due_s >= time_s_ && due_s > last_dropout_s_;
			next_dropout_s_ = is_to_come ? std::min(next_dropout_s_, due_s) : next_dropout_s_;
		}
	}
}

void GestureRecogniser::advance_sessions(double t_s) {
	while (next_dropout_s_ <= t_s) {
		time_s_ = last_dropout_s_ = next_dropout_s_;
		step_sessions(time_s_);
		for (std::size_t i = 0; i < sessions_.size(); ++i) {
			sessions_[i]->on_dropout(time_s_, watched(i).strokes);
		}
		judge_starts();
		abort_parts();
		decide_ends();
		choose_leader();
		schedule_dropout();
	}
	step_sessions(t_s);
}

void GestureRecogniser::step_sessions(double t_s) {
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		sessions_[i]->advance(t_s, watched(i).strokes, watched(i).monitor);
	}
}

double GestureRecogniser::part_penalty(std::size_t session) const {
	const std::uint8_t joints = watched(session).feature->joints;
	double whole = 0.0; // greatest movement of another gesture or of its return, amplitudes
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		const GestureSession &other = *sessions_[i];
		const Feature &feature = *watched(i).feature;
		const std::span<const Stroke> strokes = watched(i).strokes.strokes();
		const bool has_more = feature.joints != joints && (feature.joints & joints) == joints;
		if (!has_more || strokes.empty() || feature.direction == nullptr) {
			continue;
		}
		const Stroke &stroke = strokes.front();
		if (other.stage() != GestureSession::Stage::IDLE || other.stage_began_s() > stroke.onset_s) {
			const double length_m = std::abs((stroke.to - stroke.from).dot(feature.direction(other.task())));
			whole = std::max(whole, std::min(length_m / other.task().amplitude_m, 1.0));
		}
	}
	return PART * whole;
}

double GestureRecogniser::comparable_log_odds(std::size_t session, double log_odds) const {
	const GestureSession &one = *sessions_[session];
	bool has_rival = false;
	for (std::size_t i = 0; i < sessions_.size() && one.strike_log_odds() < 0.0; ++i) {
		has_rival = has_rival || (i != session && sessions_[i]->shares_path(one));
	}
	return log_odds - part_penalty(session) + (has_rival ? one.strike_log_odds() : 0.0);
}

double GestureRecogniser::posterior(std::size_t session) const {
	// The largest odds are factored out, so that no exponential overflows.
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
		if (session.gestures_started() != start.number) {
			start = { session.gestures_started(), start_condition_.may_begin(session.started_s()) };
		} else if (start.is_allowed && start_condition_.is_released() &&
				session.stage() == GestureSession::Stage::ACTIVE) {
			start.is_allowed = false;
			session.abort(time_s_);
		}
	}
}

void GestureRecogniser::abort_parts() {
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (gestures_[i].task || sessions_[i]->stage() == GestureSession::Stage::ENDED) {
			continue;
		}
		const double penalty = part_penalty(i);
		const bool is_part = penalty > 0.0 && sessions_[i]->best_log_odds() < penalty;
		if ((is_part && sessions_[i]->stage() == GestureSession::Stage::ACTIVE) || returns_from_other(i)) {
			sessions_[i]->abort(time_s_);
		}
	}
}

bool GestureRecogniser::returns_from_other(std::size_t session) const {
	const std::span<const Stroke> strokes = watched(session).strokes.strokes();
	for (std::size_t i = 0; i < sessions_.size() && !strokes.empty(); ++i) {
		const bool is_other = i != session && watched_by_[i] == watched_by_[session];
		if (is_other && sessions_[i]->is_return(strokes.front())) {
			return true;
		}
	}
	return false;
}

bool GestureRecogniser::ends_off_path(std::size_t one, std::size_t other) const {
	const std::optional<Task> &task = gestures_[one].task, &other_task = gestures_[other].task;
	const auto is_straight = [this](std::size_t i) {
		const Feature &feature = *watched(i).feature;
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

bool GestureRecogniser::may_lose(std::size_t best) const {
	if (sessions_[best]->is_end_usual()) {
		return false;
	}
	const double own = std::max(comparable_log_odds(best, sessions_[best]->log_odds_if(true)),
			comparable_log_odds(best, sessions_[best]->log_odds_if(false)));
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		const GestureSession &other = *sessions_[i];
		const bool is_rival =
				i != best && !gestures_[i].task && other.stage() == GestureSession::Stage::ACTIVE;
		const bool goes_on = !other.may_end() || other.is_end_predicted();
		if (is_rival && goes_on && comparable_log_odds(i, other.best_log_odds()) > own) {
			return true;
		}
	}
	return false;
}

void GestureRecogniser::decide_ends() {
	const auto likeliest_if = [this](bool comes_back) {
		return likeliest([&](std::size_t i) { return sessions_[i]->may_end(); },
				[&](std::size_t i) { return comparable_log_odds(i, sessions_[i]->log_odds_if(comes_back)); });
	};
	const int best = likeliest_if(true);
	if (best < 0 || best != likeliest_if(false) || may_lose(static_cast<std::size_t>(best))) {
		return;
	}
	sessions_[static_cast<std::size_t>(best)]->count_end();
	const int task = likeliest([&](std::size_t i) { return sessions_[i]->is_near_end(); });
	const double odds = log_odds(static_cast<std::size_t>(best));
	// A likelier gesture with a task, near its end, ends by itself.
	const bool is_of_task = task >= 0 && log_odds(static_cast<std::size_t>(task)) > odds;
	if (is_of_task || odds <= 0.0 || !may_show(static_cast<std::size_t>(best))) {
		for (const std::unique_ptr<GestureSession> &session : sessions_) {
			if (session->may_end()) {
				session->abort(time_s_);
			}
		}
		return;
	}
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (static_cast<int>(i) == best) {
			sessions_[i]->end_gesture(time_s_);
		} else {
			sessions_[i]->abort(time_s_);
		}
	}
	set_leader(best);
}

} // namespace steadyhand
