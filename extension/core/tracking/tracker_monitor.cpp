#include "tracking/tracker_monitor.h"

#include "base/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace steadyhand {
namespace {

using namespace parameters::tracker;

} // namespace

Measurement TrackerMonitor::push(double t_s, const Eigen::Vector3d &position_m) {
	Measurement measurement{ .t_s = t_s, .position_m = position_m };
	const double frame_gap_s = t_s - frame_s_;
	const bool is_first = !has_frame_ || frame_gap_s < 0.0;
	is_in_burst_ = !is_first && is_in_burst(t_s);
	is_burst_used_ = is_burst_used_ && is_in_burst_;
	if (is_first) {
		has_frame_ = true;
		delayed_frames_ = 0;
		gap_ended_s_ = -INFINITY;
		new_s_ = kept_s_ = t_s;
		position_m_ = position_m;
		restart(t_s, position_m);
		noise_.push(t_s, position_m);
	} else if (position_m == position_m_ && frame_gap_s <= overdue_s()) {
		repeat(measurement);
	} else {
		read(measurement, frame_gap_s);
	}
	frame_s_ = t_s;
	measurement.noise_m = noise_m();
	measurement.displacement_m = displacement_m_;
	replace_in_burst(measurement);
	return measurement;
}

double TrackerMonitor::noise_m() const {
	return noise_.deviation_m().norm() / std::sqrt(3.0);
}

double TrackerMonitor::overdue_s() const {
	return std::max(DROPOUT_PERIODS * period_s_, LEAST_DROPOUT_S);
}

void TrackerMonitor::restart(double t_s, const Eigen::Vector3d &position_m) {
	noise_.interrupt();
	hand_ = HandTrack(t_s, position_m, Eigen::Vector3d::Zero(), noise_.deviation_m());
	jump_.reset();
	accepted_.reset();
	displacement_m_.setZero();
	fastest_m_s_.setZero();
	fastest_s_ = t_s;
	is_frozen_ = false;
}

/// Equal stamps, or a frame that was missing in the gap before and arrives long before the next one is due.
bool TrackerMonitor::is_in_burst(double t_s) const {
	return t_s - kept_s_ < BURST_S || (delayed_frames_ > 0 && t_s - new_s_ < 0.5 * period_before_gap_s_);
}

/// Delayed frames of a burst have the stamp of their arrival, but only the last one is that new. Each frame
/// of a burst therefore replaces the one before.
void TrackerMonitor::replace_in_burst(Measurement &r_measurement) {
	if (r_measurement.is_usable()) {
		r_measurement.replaces_last = is_burst_used_;
		is_burst_used_ = true;
	}
}

void TrackerMonitor::repeat(Measurement &r_measurement) {
	const double repeated_s = r_measurement.t_s - new_s_;
	const double chance = std::pow(noise_.repeat_probability(), std::floor(repeated_s / period_s_ + 0.5));
	const double prior = std::min(FAULTS_PER_S * repeated_s, 0.5);
	r_measurement.status = MeasurementStatus::REPEATED;
	if (repeated_s <= FREEZE_PERIODS * period_s_) {
		return;
	}
	if (prior > (1.0 - prior) * chance) {
		r_measurement.status = MeasurementStatus::FROZEN;
		faults_.freezes += is_frozen_ ? 0 : 1;
		is_frozen_ = true;
		return;
	}
	// A hand at rest, and a tracker without noise.
	if (jump_ && r_measurement.t_s - jump_->since_s < LONGEST_JUMP_S) {
		jump_->track.predict(r_measurement.t_s, 0.0);
		jump_->track.correct(r_measurement.position_m, noise_.deviation_m());
		return;
	}
	if (jump_) {
		accept_jump(*jump_);
	}
	r_measurement.status = MeasurementStatus::TRACKED;
	hand_.predict(r_measurement.t_s, 0.0);
	hand_.correct(r_measurement.position_m, noise_.deviation_m());
}

void TrackerMonitor::accept_jump(const Jump &jump) {
	hand_ = jump.track;
	accepted_ = jump;
	displacement_m_ += jump.displacement_m();
	jump_.reset();
}

void TrackerMonitor::read(Measurement &r_measurement, double frame_gap_s) {
	const double t_s = r_measurement.t_s;
	const double dt_s = t_s - new_s_;
	const bool is_dropout = frame_gap_s > overdue_s();
	gap_ended_s_ = frame_gap_s > 1.5 * period_s_ ? t_s : gap_ended_s_;
	faults_.dropouts += is_dropout ? 1 : 0;
	if (is_dropout || is_frozen_) {
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.gap_s = is_frozen_ ? dt_s : frame_gap_s;
		is_frozen_ = false;
	}
	if (frame_gap_s > MEMORY_S) {
		restart(t_s, r_measurement.position_m);
	} else if (jump_) {
		judge_jumped(r_measurement, *jump_);
	} else {
		judge(r_measurement, dt_s);
	}
	if (is_in_burst_) {
		--delayed_frames_;
	} else {
		delayed_frames_ = is_period_known() ? std::llround(frame_gap_s / period_s_) - 1 : 0;
		period_before_gap_s_ = period_s_;
		time(t_s);
		if (r_measurement.status != MeasurementStatus::OUTLIER) {
			noise_.push(t_s, r_measurement.position_m);
		}
		kept_s_ = t_s;
	}
	new_s_ = t_s;
	position_m_ = r_measurement.position_m;
}

void TrackerMonitor::time(double t_s) {
	intervals_s_.push(t_s - kept_s_);
	std::array<double, 8> sorted{};
	const std::size_t count = intervals_s_.size();
	for (std::size_t i = 0; i < count; ++i) {
		sorted[i] = intervals_s_[i];
	}
	const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((count - 1) / 2);
	std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(count));
	period_s_ = *middle;
}

/// Standard deviation of a reading for each axis, with the effect of the stamp's error on a moving hand. If
/// camera and reader have different clocks, a reading is up to one period old.
Eigen::Vector3d TrackerMonitor::reading_noise_m() const {
	const Eigen::Vector3d shift_m = hand_.velocity_m_s() * (period_s_ / std::sqrt(12.0));
	const Eigen::Vector3d noise_m = noise_.deviation_m();
	return (noise_m.cwiseAbs2() + shift_m.cwiseAbs2()).cwiseSqrt();
}

void TrackerMonitor::judge(Measurement &r_measurement, double dt_s) {
	const HandTrack before = hand_;
	const Eigen::Vector3d noise_m = reading_noise_m();
	hand_.predict(r_measurement.t_s, is_in_burst_ ? period_s_ : 0.0);
	const Eigen::Vector3d off_m = hand_.residual_m(r_measurement.position_m, period_s_);
	const double prior = -std::expm1(-FAULTS_PER_S * std::max(dt_s, BURST_S));
	const double log_odds = std::log(prior / (1.0 - prior)) + hand_.log_likelihood(off_m, noise_m, JUMP_M) -
			hand_.log_likelihood(off_m, noise_m);
	r_measurement.outlier_probability = 1.0 / (1.0 + std::exp(-log_odds));
	if (log_odds <= 0.0) {
		hand_.fall_behind(r_measurement.position_m);
		hand_.correct(r_measurement.position_m, noise_m);
		if (hand_.velocity_m_s().norm() >= fastest_m_s_.norm() || r_measurement.t_s - fastest_s_ > MEMORY_S) {
			fastest_m_s_ = hand_.velocity_m_s();
			fastest_s_ = r_measurement.t_s;
		}
		return;
	}
	if (accepted_ && has_returned(*accepted_, r_measurement.position_m, r_measurement.t_s)) {
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.gap_s = r_measurement.t_s - accepted_->since_s;
		r_measurement.outlier_probability = 0.0;
		hand_ = HandTrack(r_measurement.t_s, r_measurement.position_m, hand_.velocity_m_s(), noise_m);
		displacement_m_ -= accepted_->displacement_m();
		accepted_.reset();
		return;
	}
	// The first frames after a gap may be old. Then the tracker catches up with a hand that went on.
	if (r_measurement.t_s - gap_ended_s_ < MOST_BEHIND_S &&
			leads_to(r_measurement.position_m - before.position_m(), dt_s + MOST_BEHIND_S)) {
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.outlier_probability = 0.0;
		hand_ = HandTrack(r_measurement.t_s, r_measurement.position_m, fastest_m_s_, noise_m);
		return;
	}
	++faults_.jumps;
	r_measurement.status = MeasurementStatus::OUTLIER;
	jump_ = Jump{ .since_s = r_measurement.t_s,
		.gap_s = std::exchange(r_measurement.gap_s, 0.0),
		.is_catch_up = catches_up(r_measurement.position_m - before.position_m(), r_measurement.t_s),
		.from_m = hand_.position_m(),
		.hand_m_s = hand_.velocity_m_s(),
		.way_m = r_measurement.position_m - hand_.position_m(),
		.velocity_m_s = (r_measurement.position_m - before.position_m()) /
				std::max(r_measurement.t_s - before.t_s(), BURST_S),
		.track = HandTrack(r_measurement.t_s, r_measurement.position_m, before.velocity_m_s(), noise_m) };
}

void TrackerMonitor::judge_jumped(Measurement &r_measurement, Jump &r_jump) {
	const double t_s = r_measurement.t_s;
	const double dt_s = t_s - r_jump.track.t_s();
	const Eigen::Vector3d noise_m = reading_noise_m();
	const double stamp_error_s = is_in_burst_ ? period_s_ : 0.0;
	const Eigen::Vector3d continued_m = r_jump.track.position_m() + dt_s * r_jump.velocity_m_s;
	const bool is_second = r_jump.readings == 1;
	hand_.predict(t_s, stamp_error_s);
	r_jump.track.predict(t_s, stamp_error_s);
	++r_jump.readings;
	const Eigen::Vector3d off_m = hand_.residual_m(r_measurement.position_m, period_s_);
	const Eigen::Vector3d off_jumped_m = r_jump.track.residual_m(r_measurement.position_m, period_s_);
	const double hand = hand_.log_likelihood(off_m, noise_m);
	const double jumped = r_jump.track.log_likelihood(off_jumped_m, noise_m);
	const double elsewhere = hand_.log_likelihood(off_m, noise_m, JUMP_M);
	// A hand that made the jump continues with its velocity. After a jump of the tracker, the readings show
	// the hand's own velocity.
	const bool is_motion = is_second && r_jump.velocity_m_s.norm() < 3.0 * SPEED_M_S &&
			(r_measurement.position_m - continued_m).norm() <
					(r_measurement.position_m - r_jump.track.position_m()).norm();
	if (is_motion) { // the hand moved here while it was not tracked
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.gap_s = r_jump.gap_s + t_s - r_jump.since_s;
		hand_ = HandTrack(t_s, r_measurement.position_m, r_jump.velocity_m_s, noise_m);
		--faults_.jumps;
		jump_.reset();
		return;
	}
	if (hand >= std::max(jumped, elsewhere)) {
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.gap_s = r_jump.gap_s + t_s - r_jump.since_s;
		hand_.correct(r_measurement.position_m, noise_m);
		jump_.reset();
		return;
	}
	if (jumped >= elsewhere) {
		r_jump.track.correct(r_measurement.position_m, noise_m);
	} else {
		r_jump.track = HandTrack(t_s, r_measurement.position_m, hand_.velocity_m_s(), noise_m);
		r_jump.way_m = r_measurement.position_m - hand_.position_m();
	}
	if (t_s - r_jump.since_s >= LONGEST_JUMP_S) {
		r_measurement.status = MeasurementStatus::REAPPEARED;
		r_measurement.gap_s = r_jump.gap_s + t_s - r_jump.since_s;
		accept_jump(r_jump);
		return;
	}
	r_measurement.status = MeasurementStatus::OUTLIER;
	r_measurement.outlier_probability = 1.0 / (1.0 + std::exp(hand - std::max(jumped, elsewhere)));
}

/// Whether the fastest recent motion of the hand leads there, way_m from its last position, in most_s.
bool TrackerMonitor::leads_to(const Eigen::Vector3d &way_m, double most_s) const {
	return way_m.dot(fastest_m_s_) > 0.0 &&
			off_path_m(way_m, fastest_m_s_, most_s).norm() < STOOD * way_m.norm();
}

/// Whether the tracker catches up: it showed the hand at rest, and now shows it where its last motion leads.
/// Trackers that lose a hand do this.
bool TrackerMonitor::catches_up(const Eigen::Vector3d &way_m, double t_s) const {
	return hand_.velocity_m_s().norm() < STOOD * fastest_m_s_.norm() && leads_to(way_m, t_s - fastest_s_);
}

/// Whether the tracker has undone the jump. The hand is then where the tracked motion since the jump leads
/// without it, or on its path from before the jump.
bool TrackerMonitor::has_returned(const Jump &jump, const Eigen::Vector3d &position_m, double t_s) const {
	const double away_s = t_s - jump.since_s, undone_m = UNDONE * jump.way_m.norm();
	const Eigen::Vector3d moved_m = hand_.position_m() - jump.way_m;
	const Eigen::Vector3d off_m = off_path_m(position_m - jump.from_m, jump.hand_m_s, away_s);
	return away_s <= MEMORY_S && ((position_m - moved_m).norm() < undone_m || off_m.norm() < undone_m);
}

} // namespace steadyhand
