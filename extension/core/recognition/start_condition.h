#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace steadyhand {

/// Condition that a hand must meet for a gesture to begin.
enum class StartKind : std::uint8_t {
	NONE,          ///< nothing
	DWELL,         ///< hold its index tip still
	PINCH,         ///< hold thumb and index tip together, until the gesture ends
	POINTING_POSE, ///< extend the index and curl middle, ring and little finger: the paper's start
};

struct StartSettings {
	StartKind kind = StartKind::NONE;
	/// Time of DWELL, s: the best one in gaze typing (Helmert et al. 2008, doi:10.16910/jemr.2.4.3).
	double dwell_s = 0.5;
	/// Distance of the tips for PINCH, m, as in Ultraleap's detector. The 10 mm of StereoKit is too small for
	/// a Leap: in the pinch of leapjs-playback the tips come no nearer than 18 mm.
	double pinch_m = 0.025;
};

/// Decides whether a gesture may begin. A hand in a dropout longer than parameters::SHORT_DROPOUT_S, or with
/// a low confidence, does not meet the condition, and not at once after such a dropout either.
class StartCondition {
public:
	explicit StartCondition(const StartSettings &settings = {}) : settings_(settings) {}

	/// joint_bits() of the joints that the condition needs; 0 for NONE.
	[[nodiscard]] static std::uint8_t joints(StartKind kind);

	/// Time stamps must not decrease.
	void push(const HandFrame &frame);

	/// The newest frame has the joints that the condition needs.
	[[nodiscard]] bool has_joints() const { return has_joints_; }
	/// As of the newest frame; always true for NONE.
	[[nodiscard]] bool is_met() const { return settings_.kind == StartKind::NONE || is_met_; }
	/// A gesture may begin at onset_s: the condition was met then, or shortly before.
	[[nodiscard]] bool may_begin(double onset_s) const;
	/// PINCH: the fingers have opened, or their closing was not a pinch. An active gesture must be aborted.
	[[nodiscard]] bool is_released() const { return is_released_; }

private:
	StartSettings settings_;
	bool has_joints_ = false;
	bool is_met_ = false;
	bool is_released_ = false;
	bool reports_confidence_ = false;
	double seen_s_ = -INFINITY;      ///< last frame in which the hand was tracked well
	double found_s_ = -INFINITY;     ///< first such frame after a dropout
	double met_from_s_ = INFINITY;   ///< last period in which the condition was met: begin
	double met_to_s_ = -INFINITY;    ///< and end
	double open_from_s_ = INFINITY;  ///< PINCH: time at which the fingers opened
	double still_from_s_ = INFINITY; ///< DWELL: time since which the tip is at still_at_m_
	double left_s_ = INFINITY;       ///< DWELL: time at which the tip left still_at_m_
	Eigen::Vector3d still_at_m_ = Eigen::Vector3d::Zero();

	/// The condition depends on the fingers. Trackers measure them wrongly before and after a dropout.
	[[nodiscard]] bool is_pose() const { return settings_.kind != StartKind::DWELL; }
	[[nodiscard]] bool is_seen_well(const HandFrame &frame);
	void lose();
	[[nodiscard]] bool judge(const HandFrame &frame);
	[[nodiscard]] bool is_still(const HandFrame &frame);
	void meet(double t_s);
	void fail(double t_s);
};

} // namespace steadyhand
