#include "haptics/arrival_detector.h"

#include <cmath>

namespace steadyhand {
namespace {

/// Below this the hand is on its way for another time.
constexpr double AGAIN_BELOW = 0.5;
/// A gesture that has ended is waited for if at its speed it reaches the level within this time.
constexpr double SOON_S = 0.05;

} // namespace

void ArrivalDetector::restart() {
	gesture_ = 0;
	awaits_ = connected_ = false;
}

void ArrivalDetector::push(double t_s, const MotionSnapshot::Knot &motion, std::uint32_t gesture,
		double amplitude_m, bool has_ended) {
	if (last_.time_s > t_s) {
		last_ = {}; // of a run whose time was another
	}
	if (onset_.time_s > t_s) {
		onset_ = {};
	}
	const bool begins = gesture != 0 && gesture != gesture_;
	const bool again = gesture != 0 && !awaits_ && motion.position < AGAIN_BELOW;
	if (begins) {
		onset_ = { ++starts_, t_s, std::abs(motion.velocity) * amplitude_m };
	}
	if (begins || again) {
		awaits_ = true;
		++number_;
		was_there_ = was_there_ && !begins;
	}
	awaits_ = awaits_ && gesture != 0;
	gesture_ = gesture;
	const bool is_there = motion.position >= level_;
	const bool ends_short = has_ended && !was_there_ && motion.position + SOON_S * motion.velocity < level_;
	if (awaits_ && (is_there || ends_short)) {
		awaits_ = false;
		was_there_ = true;
		last_ = { number_, t_s, std::abs(motion.velocity) * amplitude_m };
		if (is_there && connected_ && t_s > before_s_ && before_.position < level_) {
			MotionSnapshot step;
			step.time_s = before_s_;
			step.period_s = t_s - before_s_;
			step.count = 2;
			step.knots[0] = before_;
			step.knots[1] = motion;
			last_.time_s = step.reaches_s(level_, before_s_);
			// A condition that holds its frames steps from one to the next: it moved for as long as it held.
			const bool was_held = changed_s_ < before_s_;
			const double speed = was_held ? (motion.position - before_.position) / (t_s - changed_s_)
										  : step.at(last_.time_s).velocity;
			last_.speed_m_s = std::abs(speed) * amplitude_m;
		}
	}
	changed_s_ = connected_ && motion.position == before_.position ? changed_s_ : t_s;
	before_ = motion;
	before_s_ = t_s;
	connected_ = true;
}

Arrival ArrivalDetector::expected(const MotionSnapshot &ahead, double after_s) const {
	const double time_s = awaits_ ? ahead.reaches_s(level_, after_s) : NAN;
	if (std::isnan(time_s)) {
		return {};
	}
	return { number_, time_s, std::abs(ahead.at(time_s).velocity) * ahead.amplitude_m };
}

} // namespace steadyhand
