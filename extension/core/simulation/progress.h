#pragma once

#include <vector>

namespace steadyhand {

/// Bend `a` of the time warp w(s) = s + a s (1 - s) that puts the peak velocity of minimum_jerk(w(s)) at the
/// share `peak_fraction` of the duration, clamped to 0.25..0.75. Both ends stay at rest with no acceleration;
/// no bend leaves the peak at 0.5.
[[nodiscard]] double bend_for_peak(double peak_fraction);

/// One bell-shaped piece of a movement; pieces may overlap and add up (Novak, Miller, Houk 2002,
/// doi 10.1007/s00221-002-1060-6).
struct Submovement {
	double start_s = 0.0;
	double duration_s = 1.0;
	double amplitude = 1.0; ///< share of the task's amplitude; negative: back
	double bend = 0.0;      ///< see bend_for_peak()
};

/// The hand all but stops: its own clock falls back by `lost_s` within twice that time.
struct Hesitation {
	double t_s = 0.0;
	double lost_s = 0.0;
};

/// How far along its task a hand is, as a function of time: 0 at the task's start, 1 at its end. Twice
/// continuously differentiable.
class Progress {
public:
	Progress(double initial, std::vector<Submovement> submovements, std::vector<Hesitation> hesitations);

	[[nodiscard]] double at(double t_s) const;
	/// Time at which all submovements are over.
	[[nodiscard]] double duration_s() const { return duration_s_; }
	/// First time at which `level` is reached from below; duration_s() where it never is.
	[[nodiscard]] double crossing_s(double level) const;
	/// From this time on the progress stays within `tolerance` of where it ends.
	[[nodiscard]] double settling_s(double tolerance) const;
	/// The same movement, slower or faster.
	[[nodiscard]] Progress stretched(double factor) const;

private:
	double initial_;
	std::vector<Submovement> submovements_;
	std::vector<Hesitation> hesitations_;
	double duration_s_ = 0.0;
};

} // namespace steadyhand
