#pragma once

#include <vector>

namespace steadyhand {

/// Bend `a` of the time warp w(s) = s + a s (1 - s) for which the velocity of minimum_jerk(w(s)) peaks at
/// s = peak_fraction, clamped to 0.25..0.75. The velocity and acceleration at both ends stay 0. A bend of 0
/// has the peak at 0.5.
[[nodiscard]] double bend_for_peak(double peak_fraction);

/// A submovement with a bell-shaped velocity. Submovements may overlap and are added (Novak, Miller, Houk
/// 2002, doi 10.1007/s00221-002-1060-6).
struct Submovement {
	double start_s = 0.0;
	double duration_s = 1.0;
	double amplitude = 1.0; ///< in amplitudes of the task; negative: back
	double bend = 0.0;      ///< see bend_for_peak()
};

/// The hand almost stops: the time of its movement falls behind by lost_s within 2 lost_s.
struct Hesitation {
	double t_s = 0.0;
	double lost_s = 0.0;
};

/// Progress of a hand along its task as a function of time: 0 at the task's start, 1 at its end. It is twice
/// continuously differentiable.
class Progress {
public:
	Progress(double initial, std::vector<Submovement> submovements, std::vector<Hesitation> hesitations);

	[[nodiscard]] double at(double t_s) const;
	/// Time at which all submovements have ended.
	[[nodiscard]] double duration_s() const { return duration_s_; }
	/// First time at which `level` is reached from below; duration_s() if it is never reached.
	[[nodiscard]] double crossing_s(double level) const;
	/// Time from which on the progress stays within `tolerance` of its final value.
	[[nodiscard]] double settling_s(double tolerance) const;
	/// The same movement with all times multiplied by `factor`.
	[[nodiscard]] Progress stretched(double factor) const;

private:
	double initial_;
	std::vector<Submovement> submovements_;
	std::vector<Hesitation> hesitations_;
	double duration_s_ = 0.0;
};

} // namespace steadyhand
