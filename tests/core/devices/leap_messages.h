#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace steadyhand::test {

/// Text of the messages of a Leap service, written without a JSON library.

/// As the services print numbers; "%f" loses less than 1 nm of a position in mm.
inline std::string leap_number(double number) {
	std::array<char, 400> text{};
	std::snprintf(text.data(), text.size(), "%f", number);
	return text.data();
}

inline std::string leap_vector(const Eigen::Vector3d &vector) {
	return "[" + leap_number(vector.x()) + "," + leap_number(vector.y()) + "," + leap_number(vector.z()) +
			"]";
}

/// A bone's basis: rows x, y, z.
inline std::string leap_basis(const Eigen::Matrix3d &axes) {
	return "[" + leap_vector(axes.col(0)) + "," + leap_vector(axes.col(1)) + "," + leap_vector(axes.col(2)) +
			"]";
}

struct LeapTip {
	int hand_id = 0;
	int finger = 0;
	Eigen::Vector3d tip_m;
};

struct LeapPalm {
	int id = 0;
	bool is_left = false;
	Eigen::Vector3d palm_m;
	double time_visible_s = 1.0;
	std::optional<double> confidence;
};

inline std::string leap_hand(const LeapPalm &hand) {
	return R"({"id":)" + std::to_string(hand.id) + R"(,"type":")" + (hand.is_left ? "left" : "right") +
			R"(","palmPosition":)" + leap_vector(hand.palm_m * 1000.0) + R"(,"timeVisible":)" +
			leap_number(hand.time_visible_s) +
			(hand.confidence ? R"(,"confidence":)" + leap_number(*hand.confidence) : std::string()) + "}";
}

/// `hands` and `pointables`: the entries of the lists, with their commas.
inline std::string leap_frame(
		std::int64_t timestamp_us, const std::string &hands, const std::string &pointables = "") {
	return R"({"currentFrameRate":110.5,"devices":[],"id":1,"timestamp":)" + std::to_string(timestamp_us) +
			R"(,"hands":[)" + hands + R"(],"pointables":[)" + pointables + "]}";
}

inline std::string leap_frame(std::int64_t timestamp_us, const std::vector<LeapPalm> &hands,
		const std::vector<LeapTip> &tips = {}) {
	std::string palms;
	for (const LeapPalm &hand : hands) {
		palms += (palms.empty() ? "" : ",") + leap_hand(hand);
	}
	std::string pointables;
	for (const LeapTip &tip : tips) {
		pointables += (pointables.empty() ? "" : ",") +
				(R"({"id":)" + std::to_string(tip.hand_id * 10 + tip.finger)) + R"(,"handId":)" +
				std::to_string(tip.hand_id) + R"(,"type":)" + std::to_string(tip.finger) +
				R"(,"tipPosition":)" + leap_vector(tip.tip_m * 1000.0) + "}";
	}
	return leap_frame(timestamp_us, palms, pointables);
}

/// The example of a frame of Orion's: one hand, one finger.
inline const std::string LEAP_EXAMPLE =
		R"({"currentFrameRate":110.7,"devices":[],"id":13319,"timestamp":810321011,)"
		R"("hands":[{"id":7,"type":"right","palmPosition":[12.0,180.5,20.1],"palmVelocity":[-3.3,5.6,1.5],)"
		R"("palmNormal":[0.1,-0.99,-0.1],"direction":[0.0,0.1,-0.99],"confidence":1,"grabStrength":0,)"
		R"("grabAngle":0.4,"pinchStrength":0,"pinchDistance":58.2,"palmWidth":88.9,"timeVisible":2.31,)"
		R"("armWidth":60.9,"armBasis":[[1,0,0],[0,1,0],[0,0,1]],"elbow":[20,60,260],"wrist":[14,160,80]}],)"
		R"("pointables":[{"id":71,"handId":7,"type":1,"tipPosition":[5.1,200.4,-72.3],)"
		R"("btipPosition":[5.1,200.4,-72.3],"dipPosition":[5.6,198.9,-55.0],"pipPosition":[7.0,193.1,-33.2],)"
		R"("mcpPosition":[9.8,186.0,5.5],"carpPosition":[12.1,170.3,70.2],"direction":[-0.05,0.08,-0.99],)"
		R"("extended":true,"length":57.6,"width":18.3,"timeVisible":2.31,"bases":[[[1,0,0],[0,1,0],[0,0,1]],)"
		R"([[1,0,0],[0,1,0],[0,0,1]],[[1,0,0],[0,1,0],[0,0,1]],[[1,0,0],[0,1,0],[0,0,1]]]}]})";

} // namespace steadyhand::test
