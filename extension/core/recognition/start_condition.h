#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace steadyhand {

/// What a hand has to do for a gesture to begin.
enum class StartKind : std::uint8_t {
	NONE,          ///< nothing
	DWELL,         ///< hold its index tip still
	PINCH,         ///< hold thumb and index tip together, for as long as the gesture takes
	POINTING_POSE, ///< extend the index and curl middle, ring and little finger: the paper's start
};

struct StartSettings {
	StartKind kind = StartKind::NONE;
	/// s, of DWELL: the best in gaze typing (Helmert et al. 2008, doi:10.16910/jemr.2.4.3).
	double dwell_s = 0.5;
	/// m, of PINCH, between the tips: Ultraleap's detector. StereoKit's 10 mm asks for more than a Leap
	/// shows: the pinch recorded in leapjs-playback comes no nearer than 18 mm.
	double pinch_m = 0.025;
};

/// Says whether a gesture may begin. A hand that is lost, or whose confidence is low, does not meet the
/// condition, nor does it at once when it is seen again.
class StartCondition {
public:
	explicit StartCondition(const StartSettings &settings = {}) : settings_(settings) {}

	/// joint_bits() of what the condition is judged by; 0 for NONE.
	[[nodiscard]] static std::uint8_t joints(StartKind kind);

	/// Stamps must not decrease.
	void push(const HandFrame &frame);

	/// The newest frame held the joints that the condition is judged by.
	[[nodiscard]] bool has_joints() const { return has_joints_; }
	/// As of the newest frame; always true for NONE.
	[[nodiscard]] bool is_met() const { return settings_.kind == StartKind::NONE || is_met_; }
	/// Whether a gesture may have begun at onset_s: the condition was met then, or a moment before.
	[[nodiscard]] bool may_begin(double onset_s) const;
	/// PINCH: the fingers were seen to open, or their closing was no pinch; a gesture under way is over.
	[[nodiscard]] bool is_released() const { return is_released_; }

private:
	StartSettings settings_;
	bool has_joints_ = false;
	bool is_met_ = false;
	bool is_released_ = false;
	bool reports_confidence_ = false;
	double seen_s_ = -INFINITY;      ///< when the hand was last seen well
	double found_s_ = -INFINITY;     ///< when it was first seen after it was lost
	double met_from_s_ = INFINITY;   ///< the last time that the condition was met: from here
	double met_to_s_ = -INFINITY;    ///< to here
	double open_from_s_ = INFINITY;  ///< PINCH: since when it is seen open
	double still_from_s_ = INFINITY; ///< DWELL: since when the tip is at still_at_m_
	double left_s_ = INFINITY;       ///< since when it is seen elsewhere
	Eigen::Vector3d still_at_m_ = Eigen::Vector3d::Zero();

	/// Judged by the fingers, which a tracker may show wrongly where it loses and finds the hand.
	[[nodiscard]] bool is_pose() const { return settings_.kind != StartKind::DWELL; }
	[[nodiscard]] bool is_seen_well(const HandFrame &frame);
	void lose();
	[[nodiscard]] bool judge(const HandFrame &frame);
	[[nodiscard]] bool is_still(const HandFrame &frame);
	void meet(double t_s);
	void fail(double t_s);
};

} // namespace steadyhand
