#pragma once

#include "devices/leap_connection.h"
#include "devices/leap_protocol.h"
#include "signal/ring.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace steadyhand {

/// `skeleton`, from the device's axes to those of what the device is fixed to: x right, y up, -z forward,
/// metres and rotations alike. The origin stays on the device: the scene adds where it is and how far it
/// tilts.
///
/// DESKTOP: the axes are the same; -z points away from the user.
/// HMD: head space, (x, y, z) -> (-x, -z, -y).
/// SCREENTOP: the device is rolled by half a turn about z, (x, y, z) -> (-x, -y, z).
[[nodiscard]] HandSkeleton leap_to_godot(const HandSkeleton &skeleton, LeapMounting mounting);

enum class HandSide : std::uint8_t { LEFT, RIGHT };

/// Follows one hand of one side through a stream of frames. Of several hands of the side it chooses the one
/// that it chose last, else the one that is visible for longest.
///
/// A service sometimes calls one hand the other. This chooser doubts a hand
/// - that changes its side and keeps its id, or
/// - that is new or jumps, to within SAME_PLACE_M of where a hand of the other side just was and is no more.
/// It chooses no hand in doubt, on either side, as its joints are mirrored. The doubt ends when the hand is
/// as before, or when it has lasted for DOUBT_S: then the hand is what the service says.
class LeapHandChooser {
public:
	static constexpr double SAME_PLACE_M = 0.05; ///< half a hand's width
	static constexpr double DOUBT_S = 0.3;       ///< mistaken sides last for some frames, at 50 to 110 Hz

	explicit LeapHandChooser(HandSide side) : side_(side) {}

	/// The hand to use, null where there is none; points into `frame`. Give every frame, in order. A
	/// timestamp that goes back starts anew.
	const LeapHand *choose(const LeapFrame &frame);

	/// Forgets all hands, as after a new connection.
	void clear();

private:
	/// A hand as it last was without doubt, and since when it is in doubt.
	struct Known {
		std::int64_t id = 0;
		bool is_left = false;
		Eigen::Vector3d palm_m = Eigen::Vector3d::Zero();
		std::int64_t seen_us = 0;
		std::optional<std::int64_t> in_doubt_since_us;
	};

	[[nodiscard]] const Known *find(std::int64_t id) const;
	/// The hand as it is known from this frame on.
	[[nodiscard]] Known judge(const LeapHand &hand, const LeapFrame &frame) const;
	[[nodiscard]] bool is_doubtful(const LeapHand &hand, const Known *known, const LeapFrame &frame) const;
	[[nodiscard]] bool is_where_another_was(const LeapHand &hand, const LeapFrame &frame) const;

	HandSide side_;
	Ring<Known, 2 * LEAP_HANDS_MAX> known_; ///< those of the last frame, and those that were lost just now
	std::optional<std::int64_t> chosen_id_;
	std::int64_t last_us_ = 0;
};

} // namespace steadyhand
