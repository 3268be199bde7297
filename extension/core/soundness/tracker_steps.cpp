#include "soundness/tracker_steps.h"

#include "soundness/hands.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Smaller steps spoil no stroke; nor are those told from trembling that are smaller than so many times its
/// mean.
constexpr double SMALLEST_M = 0.002;
constexpr double TREMBLES = 4.0;
constexpr double TREMBLE_SHARE = 0.02;
/// A single bend counts as no more than so many times the mean and this: jumps are no trembling.
constexpr double LARGEST_TREMBLES = 3.0;
constexpr double LARGEST_TREMBLE_M = 0.002;
/// The quickest strokes that are studied, 19 cm in 0.2 s, speed up by 27 m/s^2 (Flash & Hogan 1985), for less
/// than a frame's time on either side of their steepest.
constexpr double ACCELERATION_M_S2 = 20.0;
/// A tracker that slides back as fast as this would be back within so long, and is given twice that.
constexpr double SLIDES_BACK_S = 0.15;
/// A hand that sets out unseen has rested for so long.
constexpr double RESTS_S = 0.1;
/// What is back so soon where it rested, to the last bit, has not left; a hand that passes there may be.
constexpr double BACK_S = 0.2;

} // namespace

void TrackerSteps::restart() {
	has_last_ = is_waiting_ = false;
	held_.reset();
	velocity_m_s_ = step_m_ = FeaturePlace::Zero();
	slide_ = {};
	stand_ = {};
	interval_s_ = 0.0;
}

double TrackerSteps::floor_m() const {
	return SMALLEST_M + TREMBLES * bend_m_;
}

void TrackerSteps::remember_bend(double bend_m) {
	bends_ = std::min(bends_ + 1, static_cast<int>(1.0 / TREMBLE_SHARE));
	bend_m_ += (std::min(bend_m, LARGEST_TREMBLES * bend_m_ + LARGEST_TREMBLE_M) - bend_m_) / bends_;
}

/// What goes back along the step, beside the hand's own velocity before it, is the tracker's.
void TrackerSteps::slide_to(const Frame &frame) {
	const double left_m = slide_.left_m.norm();
	if (left_m == 0.0) {
		return;
	}
	const FeaturePlace direction = slide_.left_m / left_m;
	const double dt_s = frame.t_s - last_.t_s;
	const double back_m = -direction.dot(frame.place_m - last_.place_m - slide_.hand_m_s * dt_s);
	const FeaturePlace back = std::clamp(back_m, 0.0, left_m) * direction;
	step_m_ -= back;
	slide_.left_m -= back;
	if (back_m >= left_m || frame.t_s > slide_.until_s) {
		slide_ = {};
	}
}

void TrackerSteps::pass(const Frame &frame) {
	if (has_last_) {
		slide_to(frame);
		interval_s_ = frame.t_s - last_.t_s;
		velocity_m_s_ = (frame.place_m - last_.place_m) / interval_s_;
		stand_at(frame);
		if (velocity_m_s_.norm() > 1.5 * ACCELERATION_M_S2 * interval_s_ + bend_m_ / interval_s_) {
			moved_s_ = frame.t_s;
		}
	} else {
		moved_s_ = frame.t_s;
	}
	last_ = frame;
	has_last_ = true;
	passed_[passed_count_++] = { frame.t_s, frame.place_m - step_m_, frame.place_m };
}

void TrackerSteps::stand_at(const Frame &frame) {
	const FeaturePlace way_m = frame.place_m - stand_.place_m;
	if (way_m.norm() > 0.5 * floor_m()) {
		const double dt_s = frame.t_s - stand_.since_s;
		const double remembered_m_s = std::exp(-dt_s / BRAKES_S) * stand_.fastest_m_s;
		stand_ = { frame.t_s, frame.place_m, way_m / dt_s, std::max(remembered_m_s, way_m.norm() / dt_s) };
	}
}

TrackerSteps::Leap TrackerSteps::leap_before(const Frame &next) const {
	Leap leap;
	leap.dt_s = waiting_.t_s - (waits_after_rest_ ? rest_shown_s_ : last_.t_s);
	leap.next_s = next.t_s - waiting_.t_s;
	leap.way_m = waiting_.place_m - last_.place_m;
	leap.knows_before = interval_s_ > 0.0 || held_;
	leap.after_m_s = (next.place_m - waiting_.place_m) / leap.next_s;
	if (leap.knows_before && leap.after_m_s.norm() > FASTEST_M_S) {
		leap.after_m_s = velocity_m_s_; // a step again
	}
	leap.before_m_s = leap.knows_before ? velocity_m_s_ : leap.after_m_s;
	return leap;
}

/// For a single frame: the next is where the hand would be without the one that is waiting.
bool TrackerSteps::was_elsewhere(const Leap &leap, const Frame &next) const {
	if (waits_after_rest_) {
		return (next.place_m - last_.place_m).norm() < floor_m();
	}
	const double both_s = leap.dt_s + leap.next_s;
	const double off_m = (next.place_m - last_.place_m - velocity_m_s_ * both_s).norm();
	return leap.knows_before && off_m < floor_m() + 0.25 * ACCELERATION_M_S2 * both_s * both_s;
}

/// A hand that has set out while the tracker held its last pose, and has not nearly come to its end, is
/// faster than in the mean; or faster than it can have become since it was shown there. Before a tracker that
/// trembled where it held the pose, both.
bool TrackerSteps::set_out_unseen(const Leap &leap) const {
	const double along_m_s = leap.way_m.normalized().dot(leap.after_m_s);
	const double reached_m_s = ACCELERATION_M_S2 * (leap.dt_s + 0.5 * leap.next_s);
	const bool is_as_fast = along_m_s * LONGEST_HELD_S > leap.way_m.norm();
	if (waits_after_rest_) {
		return is_as_fast || along_m_s > reached_m_s;
	}
	return last_.t_s - moved_s_ > RESTS_S && is_as_fast && along_m_s > reached_m_s + bend_m_ / leap.next_s;
}

/// To where the hand has gone while a tracker that lost it showed it standing.
bool TrackerSteps::catches_up(const Leap &leap) const {
	const double lost_s = waiting_.t_s - stand_.since_s;
	const bool has_braked = stand_.came_m_s.norm() < BRAKED * stand_.fastest_m_s;
	if (lost_s > LONGEST_HELD_S || has_braked || leap.way_m.dot(stand_.came_m_s) <= 0.0) {
		return false;
	}
	const FeaturePlace gone_m = 0.5 * lost_s * (stand_.came_m_s + leap.after_m_s);
	const double noise_m_s = bend_m_ / leap.next_s;
	double off_m = floor_m() + 0.5 * (gone_m.norm() + lost_s * std::min(noise_m_s, stand_.came_m_s.norm()));
	// No hand stops so soon.
	if (stand_.came_m_s.norm() > 2.0 * ACCELERATION_M_S2 * leap.dt_s + noise_m_s) {
		off_m += 0.25 * ACCELERATION_M_S2 * lost_s * lost_s;
	}
	return (leap.way_m - gone_m).norm() < off_m;
}

/// next: the frame after the one that is waiting.
void TrackerSteps::resolve(const Frame &next) {
	is_waiting_ = false;
	const Leap leap = leap_before(next);
	if (was_elsewhere(leap, next)) {
		return;
	}
	if (waits_after_rest_ && !has_rested_ && next.place_m != waiting_.place_m) {
		pass(waiting_);
		return;
	}
	const bool has_set_out = set_out_unseen(leap);
	if (has_set_out && waits_after_rest_) {
		return;
	}
	// The hand's own way between two places at known velocities; those are half an interval too old and new.
	const FeaturePlace step_m = leap.way_m - 0.5 * leap.dt_s * (leap.before_m_s + leap.after_m_s);
	const double before_s = waits_after_rest_ ? 0.0 : interval_s_;
	const double hands_m = 0.25 * ACCELERATION_M_S2 * leap.dt_s * (leap.dt_s + before_s + leap.next_s);
	const bool is_step = !has_set_out && step_m.norm() > floor_m() + hands_m;
	if (is_step && catches_up(leap)) {
		pass(waiting_);
		velocity_m_s_ = leap.after_m_s;
		interval_s_ = leap.next_s;
	} else if (is_step) {
		take_out(step_m, leap);
	} else {
		pass(waiting_);
	}
}

/// step_m: of the leap, the tracker's.
void TrackerSteps::take_out(const FeaturePlace &step_m, const Leap &leap) {
	const double length_m = step_m.norm();
	// A step ends the slide before it, which is not taken for the hand's motion either.
	const FeaturePlace hand_m_s = slide_.left_m.isZero(0.0) ? leap.before_m_s : slide_.hand_m_s;
	slide_ = {};
	pass(waiting_);
	step_m_ += step_m;
	const double back_m_s = -step_m.normalized().dot(leap.after_m_s - hand_m_s);
	// Beside what a hand speeds up by between two intervals, and unlike trembling.
	const double least_m_s = length_m / SLIDES_BACK_S + 0.5 * ACCELERATION_M_S2 * (leap.dt_s + leap.next_s);
	if (back_m_s > least_m_s && length_m > 2.0 * floor_m()) {
		slide_ = { step_m, waiting_.t_s + 2.0 * SLIDES_BACK_S, hand_m_s };
	}
	passed_[passed_count_ - 1].place_m -= step_m;
	velocity_m_s_ = leap.after_m_s;
	interval_s_ = leap.next_s;
}

/// To the place that the tracker held: whatever it showed meanwhile, the hand is where it was. step_m: all
/// that was taken out until then.
void TrackerSteps::come_back(const Frame &frame, const FeaturePlace &step_m) {
	shows_elsewhere_ = shows_elsewhere_ || is_waiting_;
	is_waiting_ = false;
	step_m_ = step_m;
	slide_ = {};
	pass(frame);
	velocity_m_s_.setZero();
}

std::span<const TrackerSteps::Passed> TrackerSteps::push(
		double t_s, const FeaturePlace &place_m, double rest_shown_s) {
	passed_count_ = 0;
	const Frame frame{ t_s, place_m };
	if (held_ && t_s - held_->shown_s < BACK_S && place_m == held_->place_m) {
		come_back(frame, held_->step_m);
		return { passed_.data(), passed_count_ };
	}
	if (is_waiting_) {
		const double waiting_s = waiting_.t_s;
		resolve(frame);
		if (last_.t_s < waiting_s) { // another place, which is dropped
			rest_shown_s = NEVER_S;
		}
	}
	if (!has_last_) {
		pass(frame);
		return { passed_.data(), passed_count_ };
	}
	const double dt_s = t_s - last_.t_s;
	const double bend_m = (place_m - last_.place_m - velocity_m_s_ * dt_s).norm();
	has_rested_ = rest_shown_s > last_.t_s;
	rest_shown_s_ = std::max(rest_shown_s, stayed_until_s_);
	waits_after_rest_ = rest_shown_s_ > last_.t_s;
	const double since_s = waits_after_rest_ ? t_s - rest_shown_s_ : dt_s;
	if (bend_m > floor_m() + 0.25 * ACCELERATION_M_S2 * since_s * since_s) {
		waiting_ = frame;
		is_waiting_ = true;
	} else {
		pass(frame);
	}
	if (interval_s_ > 0.0) {
		remember_bend(bend_m);
	}
	return { passed_.data(), passed_count_ };
}

std::span<const TrackerSteps::Passed> TrackerSteps::stay(double t_s, bool rests) {
	passed_count_ = 0;
	if (is_waiting_ && t_s - waiting_.t_s > LONGEST_FRAME_S) {
		resolve({ t_s, waiting_.place_m });
		shows_elsewhere_ = true;
	}
	if (!is_waiting_) {
		held_ = { t_s, last_.place_m, step_m_ };
		if (t_s - last_.t_s > LONGEST_FRAME_S) {
			remember_bend(0.0);
			stayed_until_s_ = rests && shows_elsewhere_ ? t_s : stayed_until_s_;
		}
	}
	return { passed_.data(), passed_count_ };
}

} // namespace steadyhand
