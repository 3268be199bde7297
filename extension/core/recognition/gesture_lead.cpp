// Choice of the shown gesture of a GestureRecogniser, and the blend from the last one.

#include "base/parameters.h"
#include "recognition/gesture_recogniser.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

} // namespace

/// Reports the end of the leader. One movement may start several neighbouring tasks; those that end beside
/// this one are aborted.
void GestureRecogniser::report_end() {
	if (leader_ < 0 || session()->stage() != GestureSession::Stage::ENDED || session()->is_end_reported()) {
		return;
	}
	sessions_[shown()]->report_end();
	ended_s_ = time_s_;
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (ends_off_path(shown(), i)) {
			sessions_[i]->abort(time_s_);
		}
	}
}

void GestureRecogniser::choose_leader() {
	using Stage = GestureSession::Stage;
	report_end();
	const auto is_moving = [&](std::size_t i) { return sessions_[i]->stage() == Stage::ACTIVE; };
	if (leader_ < 0 || session()->stage() == Stage::IDLE || !starts_[shown()].is_allowed) {
		set_leader(likeliest([&](std::size_t i) { return is_moving(i) && may_show(i); }));
		return;
	}
	// An ended gesture stays the leader until a later one is likelier than none. Of tasks along one path, the
	// first one ends first, and the next one when the hand gets there.
	const bool has_ended = session()->stage() == Stage::ENDED;
	const double odds = log_odds(shown()), since_s = session()->stage_began_s();
	const int best = likeliest([&](std::size_t i) {
		const Stage stage = sessions_[i]->stage();
		const bool is_news = stage != Stage::IDLE && sessions_[i]->stage_began_s() > since_s &&
				!sessions_[i]->is_end_reported();
		const double tolerance = ends_off_path(shown(), i) ? 0.0 : SWITCH_MARGIN;
		const bool wins = has_ended ? is_news && (stage == Stage::ENDED || log_odds(i) > 0.0)
				: is_moving(i)      ? log_odds(i) > odds + SWITCH_MARGIN
									: is_news && log_odds(i) > odds - tolerance;
		return wins && may_show(i);
	});
	if (best >= 0) {
		set_leader(best);
	}
}

void GestureRecogniser::set_leader(int session) {
	if (session == leader_) {
		return;
	}
	const Motion before = motion(MotionSource::SYNTHESISED);
	const double rate_per_s = leader_ < 0 ? START_BLEND_PER_S : CHANGE_BLEND_PER_S;
	leader_ = session;
	if (leader_ >= 0) {
		shown_ = static_cast<std::size_t>(leader_);
	} else if (!gestures_[shown_].task) {
		shown_ = 0;
	}
	blend_from(before, rate_per_s);
}

/// Blends from `before` to the motion of the shown session. A step to a task with another path is not
/// blended: there the same hand has another value.
void GestureRecogniser::blend_from(const Motion &before, double rate_per_s) {
	const Motion now = synthesised(time_s_);
	const double step_m = std::abs(before.value_m - now.value_m);
	blend_ = {};
	if (!gestures_[shown_].task || step_m < SAME_PATH * sessions_[shown_]->task().amplitude_m) {
		blend_.start(time_s_, before, now, rate_per_s);
	}
}

/// Index of the session with the nearest start, the first one of equals.
std::size_t GestureRecogniser::nearest() const {
	const auto nearest = std::ranges::min_element(sessions_, {},
			[](const std::unique_ptr<GestureSession> &one) { return one->start_distance_m(); });
	return static_cast<std::size_t>(nearest - sessions_.begin());
}

/// Shows the nearest task. Must be called before the sessions get the frame of t_s: a gesture starts from the
/// shown motion. Returns the motion until now if another session is shown from now on.
std::optional<Motion> GestureRecogniser::show_nearest(double t_s) {
	if (sessions_.empty()) {
		return std::nullopt;
	}
	const bool was_seen = sessions_[shown_]->start_distance_m() < INFINITY;
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (const std::optional<FeaturePlace> &place = track(i).place()) {
			sessions_[i]->locate(*place);
		}
	}
	std::optional<Motion> before;
	const std::size_t other = leader_ < 0 ? nearest() : shown_;
	if (sessions_[other]->start_distance_m() < NEARER * sessions_[shown_]->start_distance_m()) {
		before = was_seen ? std::optional(motion(MotionSource::SYNTHESISED, t_s)) : std::nullopt;
		shown_ = other;
		blend_ = {};
	}
	sessions_[shown_]->follow_hand(t_s);
	return before;
}

/// With a task an idle session follows the hand too.
Motion GestureRecogniser::synthesised(double t_s) const {
	return leader_ >= 0 || gestures_[shown_].task ? sessions_[shown_]->motion(t_s) : Motion{};
}

Motion GestureRecogniser::motion(MotionSource source, double t_s) const {
	if (sessions_.empty()) {
		return {};
	}
	const GestureSession &session = *sessions_[shown()];
	if (source == MotionSource::SYNTHESISED) {
		return blend_.completed(synthesised(t_s), t_s);
	}
	const double value_m = filtered_[shown()].value_m(source);
	return { value_m, 0.0, 0.0, std::clamp(value_m / session.task().amplitude_m, 0.0, 1.0) };
}

} // namespace steadyhand
