#pragma once

#include "gesture/task.h"
#include "haptics/motion_snapshot.h"

namespace steadyhand {

/// Finds where a motion comes to where it leads: the first time that it reaches `level`, by default the 95 %
/// of the amplitude that define a gesture's end (docs/method.md), or where the gesture is said to have ended
/// and does not get there soon; once a gesture, and again where the hand has gone back to half of the way in
/// between.
class ArrivalDetector {
public:
	static constexpr double DEFAULT_LEVEL = END_LEVEL;

	void set_level(double level) { level_ = level; }
	[[nodiscard]] double level() const { return level_; }

	/// Time starts anew: nothing connects.
	void restart();
	/// The motion at an instant; gesture: number of the one under way, 0: none; has_ended: by another's
	/// judgement. Instants must not decrease.
	void push(double t_s, const MotionSnapshot::Knot &motion, std::uint32_t gesture, double amplitude_m,
			bool has_ended = false);

	/// A gesture is under way and has not arrived.
	[[nodiscard]] bool is_moving() const { return awaits_ && !was_there_; }
	[[nodiscard]] const Arrival &last() const { return last_; }
	/// The last start of a gesture: the first instant at which it was under way.
	[[nodiscard]] const Arrival &onset() const { return onset_; }
	/// The next one by what the snapshot says of the time after `after_s`; number 0 where it says none.
	[[nodiscard]] Arrival expected(const MotionSnapshot &ahead, double after_s) const;

private:
	double level_ = DEFAULT_LEVEL;
	std::uint32_t gesture_ = 0;
	bool awaits_ = false;
	bool was_there_ = false; ///< in this gesture
	bool connected_ = false;
	double before_s_ = 0.0;
	double changed_s_ = 0.0; ///< since then the position has been before_'s
	MotionSnapshot::Knot before_;
	std::uint32_t number_ = 0; ///< of the arrival that is awaited or was the last
	Arrival last_;
	std::uint32_t starts_ = 0;
	Arrival onset_;
};

} // namespace steadyhand
