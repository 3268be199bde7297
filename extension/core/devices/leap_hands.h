#pragma once

#include "devices/leap_connection.h"
#include "devices/leap_protocol.h"
#include "signal/ring.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace steadyhand {

/// Converts positions and rotations from the device's axes to those of its mounting: x right, y up, -z
/// forward. The origin stays on the device; the scene adds the device's position and tilt.
///
/// DESKTOP: the axes are the same; -z points away from the user.
/// HMD: head space, (x, y, z) -> (-x, -z, -y).
/// SCREENTOP: the device is rolled by half a turn about z, (x, y, z) -> (-x, -y, z).
[[nodiscard]] HandSkeleton leap_to_godot(const HandSkeleton &skeleton, LeapMounting mounting);

enum class HandSide : std::uint8_t { LEFT, RIGHT };

/// Follows one hand of one side through a stream of frames. Of several hands of the side it chooses the last
/// chosen one, otherwise the one that is visible for longest.
///
/// A service sometimes labels a left hand as right, or the reverse. A hand counts as mislabelled
/// - if it changes its side and keeps its id, or
/// - if it is new or jumps, to within SAME_PLACE_M of a hand of the other side that is just lost.
/// A mislabelled hand is not chosen for either side, because its joints are mirrored. This ends when the hand
/// has its former label again. After MISLABELLED_S the new label counts as right.
class LeapHandChooser {
public:
	static constexpr double SAME_PLACE_M = 0.05; ///< half a hand's width
	static constexpr double MISLABELLED_S = 0.3; ///< wrong labels last for some frames, at 50 to 110 Hz

	explicit LeapHandChooser(HandSide side) : side_(side) {}

	/// The chosen hand, null if there is none. Points into `frame`. Must get every frame, in order. A
	/// timestamp that goes back clears all hands.
	const LeapHand *choose(const LeapFrame &frame);

	/// Drops all hands. Call it after a new connection.
	void clear();

private:
	/// Last state in which the hand was not mislabelled, and since when it is mislabelled.
	struct Known {
		std::int64_t id = 0;
		bool is_left = false;
		Eigen::Vector3d palm_m = Eigen::Vector3d::Zero();
		std::int64_t seen_us = 0;
		std::optional<std::int64_t> mislabelled_since_us;
	};

	[[nodiscard]] const Known *find(std::int64_t id) const;
	/// State of the hand after this frame.
	[[nodiscard]] Known judge(const LeapHand &hand, const LeapFrame &frame) const;
	[[nodiscard]] bool is_mislabelled(const LeapHand &hand, const Known *known, const LeapFrame &frame) const;
	[[nodiscard]] bool is_at_lost_hand(const LeapHand &hand, const LeapFrame &frame) const;

	HandSide side_;
	Ring<Known, 2 * LEAP_HANDS_MAX> known_; ///< hands of the last frame, and recently lost ones
	std::optional<std::int64_t> chosen_id_;
	std::int64_t last_us_ = 0;
};

} // namespace steadyhand
