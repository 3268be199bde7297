// Which hand of a Leap frame is used, and the axes that it is put into.

#include "devices/leap_hands.h"
#include "tracking/track_csv.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace steadyhand;

namespace {

const Eigen::Vector3d LEFT_PLACE_M(-0.15, 0.2, 0.0);
const Eigen::Vector3d RIGHT_PLACE_M(0.15, 0.2, 0.0);

LeapHand hand_at(std::int64_t id, bool is_left, const Eigen::Vector3d &palm_m, double time_visible_s = 1.0) {
	LeapHand hand;
	hand.id = id;
	hand.is_left = is_left;
	hand.time_visible_s = time_visible_s;
	hand.skeleton.set(SkeletonJoint::PALM, palm_m);
	return hand;
}

/// Both choosers over one stream at 100 Hz.
struct Hands {
	LeapHandChooser left{ HandSide::LEFT };
	LeapHandChooser right{ HandSide::RIGHT };
	std::int64_t timestamp_us = 1'000'000;
	std::int64_t left_id = 0; ///< chosen last; 0: none
	std::int64_t right_id = 0;

	void see(const std::vector<LeapHand> &hands, double step_s = 0.01) {
		timestamp_us += static_cast<std::int64_t>(step_s * 1e6);
		LeapFrame frame;
		frame.timestamp_us = timestamp_us;
		frame.hands = hands;
		const LeapHand *chosen_left = left.choose(frame);
		const LeapHand *chosen_right = right.choose(frame);
		left_id = chosen_left == nullptr ? 0 : chosen_left->id;
		right_id = chosen_right == nullptr ? 0 : chosen_right->id;
		CHECK((chosen_left == nullptr || chosen_left->is_left));
		CHECK((chosen_right == nullptr || !chosen_right->is_left));
	}
	void see_both(int frames = 10) {
		for (int i = 0; i < frames; ++i) {
			see({ hand_at(2, false, RIGHT_PLACE_M), hand_at(1, true, LEFT_PLACE_M) });
		}
		CHECK(left_id == 1);
		CHECK(right_id == 2);
	}
};

void check_axes(
		LeapMounting mounting, const Eigen::Vector3d &x, const Eigen::Vector3d &y, const Eigen::Vector3d &z) {
	const Eigen::Vector3d place(0.1, 0.2, 0.3);
	const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
	HandSkeleton skeleton;
	skeleton.set(SkeletonJoint::INDEX_TIP, place);
	skeleton.rotations[static_cast<std::size_t>(SkeletonJoint::INDEX_TIP)] = turn;
	skeleton.rotated = HandSkeleton::bit(SkeletonJoint::INDEX_TIP);
	skeleton.inferred = skeleton.rotated;
	const auto moved = [&](const Eigen::Vector3d &v) -> Eigen::Vector3d {
		return x * v.x() + y * v.y() + z * v.z();
	};

	const HandSkeleton out = leap_to_godot(skeleton, mounting);
	CHECK((out.position(SkeletonJoint::INDEX_TIP) - moved(place)).norm() < 1e-12);
	CHECK(out.positioned == skeleton.positioned);
	CHECK(out.rotated == skeleton.rotated);
	CHECK(out.inferred == skeleton.inferred);
	// A joint's own axes turn with it: each points where its place in the device's axes would be moved.
	for (int i = 0; i < 3; ++i) {
		const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
		const Eigen::Vector3d seen = out.rotations[static_cast<std::size_t>(SkeletonJoint::INDEX_TIP)] * axis;
		CHECK((seen - moved(turn * axis)).norm() < 1e-12);
	}
}

} // namespace

TEST_CASE("each mounting turns positions and rotations into Godot's axes") {
	using V = Eigen::Vector3d;
	check_axes(LeapMounting::DESKTOP, V(1, 0, 0), V(0, 1, 0), V(0, 0, 1));
	check_axes(LeapMounting::HMD, V(-1, 0, 0), V(0, 0, -1), V(0, -1, 0));
	check_axes(LeapMounting::SCREENTOP, V(-1, 0, 0), V(0, -1, 0), V(0, 0, 1));
}

TEST_CASE("a hand in front of a headset is ahead, one below a screen's device is below") {
	HandSkeleton skeleton;
	skeleton.set(SkeletonJoint::PALM, { 0.0, 0.3, 0.0 }); // 30 cm out of the device
	const auto palm = [&skeleton](LeapMounting mounting) {
		return leap_to_godot(skeleton, mounting).position(SkeletonJoint::PALM);
	};
	CHECK(palm(LeapMounting::DESKTOP) == Eigen::Vector3d(0.0, 0.3, 0.0));
	CHECK(palm(LeapMounting::HMD) == Eigen::Vector3d(0.0, 0.0, -0.3));
	CHECK(palm(LeapMounting::SCREENTOP) == Eigen::Vector3d(0.0, -0.3, 0.0));
}

TEST_CASE("of several hands of a side the longest visible is chosen first") {
	Hands hands;
	hands.see({ hand_at(3, false, { 0.1, 0.2, 0.0 }, 0.5), hand_at(4, false, { 0.2, 0.2, 0.0 }, 2.0),
			hand_at(5, false, { 0.3, 0.2, 0.0 }, 1.0) });
	CHECK(hands.right_id == 4);
	CHECK(hands.left_id == 0);
}

TEST_CASE("a chosen hand stays chosen while it is there, whatever comes") {
	Hands hands;
	hands.see({ hand_at(3, false, { 0.1, 0.2, 0.0 }, 0.5) });
	for (int i = 0; i < 50; ++i) {
		hands.see({ hand_at(4, false, { 0.3, 0.2, 0.0 }, 9.0), hand_at(3, false, { 0.1, 0.2, 0.0 }, 0.5) });
		CHECK(hands.right_id == 3);
	}
	hands.see({ hand_at(4, false, { 0.3, 0.2, 0.0 }, 9.0) });
	CHECK(hands.right_id == 4);
}

TEST_CASE("a lost hand that comes back with another id is chosen at once") {
	Hands hands;
	hands.see_both();
	for (int i = 0; i < 60; ++i) {
		hands.see({});
		CHECK(hands.right_id == 0);
	}
	hands.see({ hand_at(9, false, RIGHT_PLACE_M) });
	CHECK(hands.right_id == 9);
}

TEST_CASE("a hand that keeps its id and changes its side belongs to neither") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	for (int i = 0; i < 29; ++i) {
		hands.see({ hand_at(2, true, RIGHT_PLACE_M) });
		CHECK(hands.left_id == 0);
		CHECK(hands.right_id == 0);
	}
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	CHECK(hands.right_id == 2);
}

TEST_CASE("a changed side is believed after 0.3 s") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	for (int i = 0; i < 32; ++i) {
		hands.see({ hand_at(2, true, RIGHT_PLACE_M) });
	}
	CHECK(hands.left_id == 2);
	CHECK(hands.right_id == 0);
}

TEST_CASE("a new hand of the other side at a vanished hand's place is not taken") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	for (int i = 0; i < 6; ++i) {
		hands.see({ hand_at(3, true, RIGHT_PLACE_M + Eigen::Vector3d(0.0, 0.03, 0.0)) });
		CHECK(hands.left_id == 0);
	}
	SUBCASE("it comes back under another id") {
		hands.see({ hand_at(4, false, RIGHT_PLACE_M) });
		CHECK(hands.right_id == 4);
	}
	SUBCASE("the new hand gets the right side") {
		hands.see({ hand_at(3, false, RIGHT_PLACE_M) });
		CHECK(hands.right_id == 3);
	}
	SUBCASE("the new hand is of that side for 0.3 s") {
		for (int i = 0; i < 26; ++i) {
			hands.see({ hand_at(3, true, RIGHT_PLACE_M) });
		}
		CHECK(hands.left_id == 3);
	}
}

TEST_CASE("a new hand of the other side at a free place is taken at once") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	hands.see({ hand_at(3, true, RIGHT_PLACE_M + Eigen::Vector3d(-0.06, 0.0, 0.0)) });
	CHECK(hands.left_id == 3);
}

TEST_CASE("a new hand close to one of the other side that is still there is taken at once") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	hands.see({ hand_at(2, false, RIGHT_PLACE_M),
			hand_at(3, true, RIGHT_PLACE_M + Eigen::Vector3d(-0.03, 0.0, 0.0)) });
	CHECK(hands.left_id == 3);
	CHECK(hands.right_id == 2);
}

TEST_CASE("a right hand that jumps to the left hand's place is not taken") {
	Hands hands;
	hands.see_both();
	for (int i = 0; i < 6; ++i) {
		hands.see({ hand_at(2, false, LEFT_PLACE_M) });
		CHECK(hands.right_id == 0);
		CHECK(hands.left_id == 0);
	}
	hands.see_both(1);
}

TEST_CASE("two hands that exchange their places in one frame are not taken") {
	Hands hands;
	hands.see_both();
	for (int i = 0; i < 6; ++i) {
		hands.see({ hand_at(2, false, LEFT_PLACE_M), hand_at(1, true, RIGHT_PLACE_M) });
		CHECK(hands.right_id == 0);
		CHECK(hands.left_id == 0);
	}
	hands.see_both(1);
}

TEST_CASE("hands that meet and cross stay what they are") {
	Hands hands;
	for (int i = 0; i <= 100; ++i) {
		const double x_m = 0.15 - 0.003 * i;
		hands.see({ hand_at(2, false, { x_m, 0.2, 0.0 }), hand_at(1, true, { -x_m, 0.2, 0.0 }) });
		CHECK(hands.left_id == 1);
		CHECK(hands.right_id == 2);
	}
}

TEST_CASE("a hand that moves on to where the other was lost stays what it is") {
	Hands hands;
	hands.see({ hand_at(2, false, { 0.05, 0.2, 0.0 }), hand_at(1, true, { 0.0, 0.2, 0.0 }) });
	for (int i = 1; i <= 30; ++i) {
		hands.see({ hand_at(2, false, { 0.05 - 0.005 * i, 0.2, 0.0 }) });
		CHECK(hands.right_id == 2);
	}
}

TEST_CASE("timestamps that go back start anew") {
	Hands hands;
	hands.see({ hand_at(2, false, RIGHT_PLACE_M) });
	hands.see({ hand_at(2, true, RIGHT_PLACE_M) }, -10.0);
	CHECK(hands.left_id == 2);
}

TEST_CASE("hands of recorded claps are never mistaken") {
	const std::filesystem::path folder = "../shared/real/leapjs_playback";
	if (!std::filesystem::exists(folder)) {
		MESSAGE("skipped: no " << folder.string() << " here");
		return;
	}
	const auto track_of = [&folder](const std::string &name) {
		std::ostringstream text;
		text << std::ifstream(folder / name, std::ios::binary).rdbuf();
		return parse_track_csv(text.str(), name).value().frames;
	};
	for (const std::string name : { "three-claps", "confidence2", "confidence-74fps" }) {
		CAPTURE(name);
		std::vector<HandFrame> left = track_of(name + "_left.csv");
		std::vector<HandFrame> right = track_of(name + "_right.csv");
		std::vector<double> times_s;
		for (const std::vector<HandFrame> &track : { left, right }) {
			for (const HandFrame &frame : track) {
				times_s.push_back(frame.t_s);
			}
		}
		std::sort(times_s.begin(), times_s.end());
		times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
		Hands hands;
		double last_s = 0.0;
		int seen = 0;
		for (const double t_s : times_s) {
			std::vector<LeapHand> both;
			bool has_left = false;
			bool has_right = false;
			for (const HandFrame &frame : left) {
				if (frame.t_s == t_s && frame.has(Joint::PALM)) {
					both.push_back(hand_at(1, true, frame.position(Joint::PALM)));
					has_left = true;
				}
			}
			for (const HandFrame &frame : right) {
				if (frame.t_s == t_s && frame.has(Joint::PALM)) {
					both.push_back(hand_at(2, false, frame.position(Joint::PALM)));
					has_right = true;
				}
			}
			hands.see(both, t_s - last_s);
			last_s = t_s;
			CHECK(hands.left_id == (has_left ? 1 : 0));
			CHECK(hands.right_id == (has_right ? 2 : 0));
			seen += has_left && has_right ? 1 : 0;
		}
		CHECK(seen > 100);
	}
}
