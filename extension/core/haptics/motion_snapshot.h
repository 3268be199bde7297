#pragma once

#include "signal/quintic_piece.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// The motion has come to where it leads: a tap to its surface, a drag to its end.
struct Arrival {
	std::uint32_t number = 0; ///< counts them, from 1; 0: none
	double time_s = 0.0;
	double speed_m_s = 0.0;
};

/// The analytic motion around now, small enough to be handed over as a whole: its values and derivatives at
/// instants a period apart, between them the quintic that has all of these at both ends.
struct MotionSnapshot {
	struct Knot {
		double position = 0.0;
		double velocity = 0.0;
		double acceleration = 0.0;
		bool moving = false; ///< a gesture is under way and has not arrived, from here to the next knot
	};
	static constexpr std::size_t MOST_KNOTS = 32;

	double time_s = 0.0; ///< of the first knot
	double period_s = 0.001;
	std::size_t count = 0;
	double amplitude_m = 0.0; ///< of the task
	Arrival arrival;          ///< the last one
	Arrival expected; ///< the next one, if all goes on as it does; with a later snapshot it may be gone
	std::array<Knot, MOST_KNOTS> knots{};

	[[nodiscard]] double end_s() const { return time_s + period_s * static_cast<double>(count - 1); }

	/// In units of the amplitude: 0 at the start, 1 at the end. NaN where the snapshot is. Before the first
	/// knot: as it began there. After the last one the motion coasts to a stop. At rest at 0 where there is
	/// none.
	[[nodiscard]] MotionPoint at(double t_s) const;
	[[nodiscard]] bool is_moving(double t_s) const;
	/// The first instant at or after from_s, up to the last knot, at which the position is `level` or more;
	/// NaN where there is none.
	[[nodiscard]] double reaches_s(double level, double from_s) const;
};

/// A snapshot that is asked for one instant after the other: its quintic of the present instant is kept.
class MotionCurve {
public:
	/// Of its knots those that count are copied.
	void set(const MotionSnapshot &snapshot) {
		snapshot_.time_s = snapshot.time_s;
		snapshot_.period_s = snapshot.period_s;
		snapshot_.count = snapshot.count;
		snapshot_.amplitude_m = snapshot.amplitude_m;
		snapshot_.arrival = snapshot.arrival;
		snapshot_.expected = snapshot.expected;
		std::copy_n(snapshot.knots.begin(), snapshot.count, snapshot_.knots.begin());
		length_s_ = 0.0;
	}
	[[nodiscard]] const MotionSnapshot &snapshot() const { return snapshot_; }

	/// snapshot().at(t_s), up to rounding
	[[nodiscard]] MotionPoint at(double t_s) {
		const double s = t_s - began_s_;
		if (!(s >= 0.0 && s < length_s_) && !find(t_s)) {
			return snapshot_.at(t_s);
		}
		return piece_.at(t_s - began_s_);
	}

	/// snapshot().is_moving(t_s)
	[[nodiscard]] bool is_moving(double t_s) const {
		const double s = t_s - began_s_;
		return s >= 0.0 && s < length_s_ ? is_moving_ : snapshot_.is_moving(t_s);
	}

private:
	MotionSnapshot snapshot_;
	QuinticPiece piece_;
	double began_s_ = 0.0, length_s_ = 0.0; ///< of the piece
	bool is_moving_ = false;                ///< in it

	bool find(double t_s);
};

} // namespace steadyhand
