// The messages of Leap Motion and Ultraleap services.

#include "devices/leap_connection.h"
#include "devices/leap_messages.h"
#include "devices/leap_protocol.h"
#include "near.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <random>
#include <string>
#include <variant>
#include <vector>

using namespace steadyhand;
using test::LEAP_EXAMPLE;
using J = SkeletonJoint;

namespace {

LeapFrame frame_of(const std::string &text) {
	const LeapMessage message = parse_leap_message(text);
	if (const auto *error = std::get_if<Error>(&message)) {
		FAIL(error->message);
	}
	REQUIRE(std::holds_alternative<LeapFrame>(message));
	return std::get<LeapFrame>(message);
}

std::string error_of(const std::string &text) {
	const LeapMessage message = parse_leap_message(text);
	const auto *error = std::get_if<Error>(&message);
	return error == nullptr ? "no error" : error->message;
}

/// The example with one part of its text exchanged.
std::string example_with(const std::string &part, const std::string &instead) {
	std::string text = LEAP_EXAMPLE;
	REQUIRE(text.find(part) != std::string::npos);
	return text.replace(text.find(part), part.size(), instead);
}

void check_position(const HandSkeleton &skeleton, J joint, double x_m, double y_m, double z_m) {
	CAPTURE(static_cast<int>(joint));
	CHECK(skeleton.has(joint));
	CHECK((skeleton.position(joint) - Eigen::Vector3d(x_m, y_m, z_m)).norm() < 1e-12);
}

Eigen::Matrix3d rotation(const HandSkeleton &skeleton, J joint) {
	REQUIRE((skeleton.rotated & HandSkeleton::bit(joint)) != 0);
	return skeleton.rotations[static_cast<std::size_t>(joint)].toRotationMatrix();
}

std::string pointable(int finger, const std::string &rest) {
	return R"({"handId":7,"type":)" + std::to_string(finger) + "," + rest + "}";
}

/// One hand, and these pointables of it.
HandSkeleton skeleton_with(const std::string &pointables, bool is_left = false) {
	const std::string hand = test::leap_hand({ 7, is_left, { 0.0, 0.2, 0.0 }, 1.0, {} });
	return frame_of(test::leap_frame(1000, hand, pointables)).hands.at(0).skeleton;
}

/// Random, of determinant 1.
Eigen::Matrix3d some_rotation(std::mt19937 &random) {
	std::normal_distribution<double> normal;
	return Eigen::Quaterniond{ normal(random), normal(random), normal(random), normal(random) }
			.normalized()
			.toRotationMatrix();
}

} // namespace

TEST_CASE("the example frame gives its joints in metres") {
	const LeapFrame frame = frame_of(LEAP_EXAMPLE);
	CHECK(frame.id == 13319);
	CHECK(frame.timestamp_us == 810321011);
	CHECK(frame.device_time_s() == test::near(810.321011));
	CHECK(frame.frame_rate_hz == 110.7);
	REQUIRE(frame.hands.size() == 1);
	const LeapHand &hand = frame.hands[0];
	CHECK(hand.id == 7);
	CHECK_FALSE(hand.is_left);
	CHECK(hand.confidence == 1.0);
	CHECK(hand.grab == 0.0);
	CHECK(hand.pinch == 0.0);
	CHECK(hand.time_visible_s == 2.31);
	check_position(hand.skeleton, J::PALM, 0.012, 0.1805, 0.0201);
	check_position(hand.skeleton, J::WRIST, 0.014, 0.160, 0.080);
	check_position(hand.skeleton, J::INDEX_METACARPAL, 0.0121, 0.1703, 0.0702);
	check_position(hand.skeleton, J::INDEX_PROXIMAL, 0.0098, 0.186, 0.0055);
	check_position(hand.skeleton, J::INDEX_INTERMEDIATE, 0.007, 0.1931, -0.0332);
	check_position(hand.skeleton, J::INDEX_DISTAL, 0.0056, 0.1989, -0.055);
	check_position(hand.skeleton, J::INDEX_TIP, 0.0051, 0.2004, -0.0723);
	CHECK(hand.skeleton.positioned == 0b0111'1100'0011);
	CHECK(hand.skeleton.rotated == 0b0111'1100'0001);
	CHECK(hand.skeleton.inferred == 0);
	CHECK(rotation(hand.skeleton, J::INDEX_TIP).isIdentity(1e-12));
}

TEST_CASE("a palm's z points from the fingers to the wrist, its y out of the back") {
	const HandSkeleton skeleton = frame_of(LEAP_EXAMPLE).hands.at(0).skeleton;
	const Eigen::Matrix3d palm = rotation(skeleton, J::PALM);
	CHECK((palm.col(2) - Eigen::Vector3d(0.0, -0.1, 0.99).normalized()).norm() < 1e-12);
	CHECK(palm.col(1).y() > 0.98);
	CHECK(palm.col(0).x() > 0.98);
	CHECK(palm.determinant() == test::near(1.0));
}

TEST_CASE("a thumb's joints are Leap's from mcp on, with the bases of their bones") {
	std::mt19937 random(4);
	std::vector<Eigen::Matrix3d> axes;
	std::string bases;
	for (int i = 0; i < 4; ++i) {
		axes.push_back(some_rotation(random));
		bases += (i == 0 ? "" : ",") + test::leap_basis(axes.back());
	}
	const HandSkeleton skeleton = skeleton_with(pointable(0,
			R"("carpPosition":[1,2,3],"mcpPosition":[1,2,3],"pipPosition":[10,20,30],"dipPosition":[40,50,60],)"
			R"("tipPosition":[70,80,90],"bases":[)" +
					bases + "]"));
	check_position(skeleton, J::THUMB_METACARPAL, 0.001, 0.002, 0.003);
	check_position(skeleton, J::THUMB_PROXIMAL, 0.010, 0.020, 0.030);
	check_position(skeleton, J::THUMB_DISTAL, 0.040, 0.050, 0.060);
	check_position(skeleton, J::THUMB_TIP, 0.070, 0.080, 0.090);
	CHECK(skeleton.positioned == 0b11'1101);
	CHECK(rotation(skeleton, J::THUMB_METACARPAL).isApprox(axes[1], 1e-5));
	CHECK(rotation(skeleton, J::THUMB_PROXIMAL).isApprox(axes[2], 1e-5));
	CHECK(rotation(skeleton, J::THUMB_DISTAL).isApprox(axes[3], 1e-5));
	CHECK(rotation(skeleton, J::THUMB_TIP).isApprox(axes[3], 1e-5));
}

TEST_CASE("each finger number fills the joints of its own finger") {
	constexpr std::uint32_t OF_FINGER = 0b1'1111;
	for (int finger = 1; finger < 5; ++finger) {
		CAPTURE(finger);
		const HandSkeleton skeleton = skeleton_with(pointable(finger,
				R"("carpPosition":[1,2,3],"mcpPosition":[4,5,6],"pipPosition":[7,8,9],)"
				R"("dipPosition":[10,11,12],"tipPosition":[13,14,15])"));
		CHECK(skeleton.positioned == (OF_FINGER << (6 + 5 * (finger - 1)) | 1U));
		CHECK(skeleton.rotated == 0);
	}
}

TEST_CASE("a basis gives the bone's rotation, mirrored as for left hands or not") {
	std::mt19937 random(5);
	for (int i = 0; i < 50; ++i) {
		const Eigen::Matrix3d axes = some_rotation(random);
		Eigen::Matrix3d mirrored = axes;
		mirrored.col(0) *= -1.0;
		for (const Eigen::Matrix3d &sent : { axes, mirrored }) {
			const std::string basis = test::leap_basis(sent);
			const std::string bases = R"("bases":[)" + basis + "," + basis + "," + basis + "," + basis + "]";
			const HandSkeleton skeleton = skeleton_with(pointable(2, bases), true);
			CHECK(skeleton.rotated == 0b1'1111 << 11);
			// Services print six decimals.
			CHECK((rotation(skeleton, J::MIDDLE_DISTAL) - axes).norm() < 1e-5);
		}
	}
}

TEST_CASE("a basis that is no rotation leaves its joint without one") {
	const std::string good = "[[1,0,0],[0,1,0],[0,0,1]]";
	for (const std::string bad :
			{ "[[0,0,0],[0,0,0],[0,0,0]]", "[[2,0,0],[0,2,0],[0,0,2]]", "[[1,0,0],[0,1,0]]",
					"[[1,0,0],[0,1,0],[0,1,0]]", "[[1,0,0],[0,1,0],[0,0,\"1\"]]", "[[0,0,1],[0,1,0],[0,0,1]]",
					"null", "[[1e200,0,0],[0,1e200,0],[0,0,1e200]]", "[[1,0,0],[0,1,0],[0,0]]" }) {
		CAPTURE(bad);
		const HandSkeleton skeleton = skeleton_with(
				pointable(1, R"("bases":[)" + good + "," + bad + "," + good + "," + good + "]"));
		CHECK(skeleton.rotated == 0b111'0100'0000);
	}
	for (const std::string &bases : { std::string("[]"), "[" + good + "]", std::string("{}") }) {
		CAPTURE(bases);
		CHECK(skeleton_with(pointable(1, R"("bases":)" + bases)).rotated == 0);
	}
}

TEST_CASE("a joint that is no place is absent, the others stay") {
	for (const std::string bad : { "[0,0,0]", "[1,2]", "[1,2,3,4]", "[1,2,null]", "[1,\"2\",3]", "null", "5",
				 "{}", "[10001,0,0]", "[1e308,1e308,1e308]", "[[1],[2],[3]]" }) {
		CAPTURE(bad);
		const HandSkeleton skeleton =
				skeleton_with(pointable(1, R"("pipPosition":)" + bad + R"(,"dipPosition":[1,2,3])"));
		CHECK_FALSE(skeleton.has(J::INDEX_INTERMEDIATE));
		CHECK(skeleton.has(J::INDEX_DISTAL));
	}
}

TEST_CASE("the bone's end stands in for a missing tip") {
	check_position(
			skeleton_with(pointable(1, R"("btipPosition":[1,2,3])")), J::INDEX_TIP, 0.001, 0.002, 0.003);
	check_position(skeleton_with(pointable(1, R"("btipPosition":[1,2,3],"tipPosition":[4,5,6])")),
			J::INDEX_TIP, 0.004, 0.005, 0.006);
}

TEST_CASE("tools and pointables of no hand are ignored") {
	const std::string tip = R"("tipPosition":[1,2,3])";
	for (const std::string &ignored : { pointable(1, tip + R"(,"tool":true)"), pointable(5, tip),
				 pointable(-1, tip), R"({"handId":8,"type":1,)" + tip + "}", R"({"type":1,)" + tip + "}",
				 R"({"handId":7,)" + tip + "}", std::string("null"), std::string("[]") }) {
		CAPTURE(ignored);
		CHECK(skeleton_with(ignored).positioned == 1);
	}
	CHECK(skeleton_with(pointable(1, tip + R"(,"tool":false)")).has(J::INDEX_TIP));
}

TEST_CASE("malformed hands are left out, the others stay") {
	const std::string good = test::leap_hand({ 7, true, { 0.0, 0.2, 0.0 }, 1.0, {} });
	for (const std::string bad :
			{ R"({"type":"left","palmPosition":[1,2,3]})", R"({"id":1,"palmPosition":[1,2,3]})",
					R"({"id":1,"type":"left"})", R"({"id":"1","type":"left","palmPosition":[1,2,3]})",
					R"({"id":1,"type":"both","palmPosition":[1,2,3]})",
					R"({"id":1,"type":0,"palmPosition":[1,2,3]})",
					R"({"id":1,"type":"left","palmPosition":[0,0,0]})",
					R"({"id":1e300,"type":"left","palmPosition":[1,2,3]})", "null", "[]", "7" }) {
		CAPTURE(bad);
		std::string hands = bad;
		hands += "," + good;
		const LeapFrame frame = frame_of(test::leap_frame(1000, hands));
		REQUIRE(frame.hands.size() == 1);
		CHECK(frame.hands[0].id == 7);
		CHECK(frame.hands[0].is_left);
	}
}

TEST_CASE("of hands with one id the first counts, and no more than eight are kept") {
	std::vector<test::LeapPalm> hands;
	for (int i = 0; i < 20; ++i) {
		hands.push_back({ i / 2, i % 2 == 0, { 0.001 * (i + 1), 0.2, 0.0 }, 1.0, {} });
	}
	const LeapFrame frame = frame_of(test::leap_frame(1000, hands));
	REQUIRE(frame.hands.size() == LEAP_HANDS_MAX);
	for (std::size_t i = 0; i < LEAP_HANDS_MAX; ++i) {
		CHECK(frame.hands[i].id == static_cast<std::int64_t>(i));
		CHECK(frame.hands[i].is_left);
	}
}

TEST_CASE("shares outside of 0..1 are clamped, missing ones have their defaults") {
	const LeapHand plain =
			frame_of(test::leap_frame(1, { { 1, true, { 0.0, 0.1, 0.0 }, 2.0, {} } })).hands.at(0);
	CHECK(plain.confidence == 1.0);
	CHECK(plain.time_visible_s == 2.0);
	const LeapHand odd = frame_of(
			example_with(R"("confidence":1,"grabStrength":0)", R"("confidence":-0.5,"grabStrength":1.5)"))
								 .hands.at(0);
	CHECK(odd.confidence == 0.0);
	CHECK(odd.grab == 1.0);
}

TEST_CASE("both forms of the version message are read") {
	const LeapMessage original = parse_leap_message(R"({"serviceVersion":"2.3.1+33747","version":6})");
	REQUIRE(std::holds_alternative<LeapVersion>(original));
	CHECK(std::get<LeapVersion>(original).version == 6);
	CHECK(std::get<LeapVersion>(original).service_version == "2.3.1+33747");
	const LeapMessage bridge = parse_leap_message(R"({"version":6})");
	REQUIRE(std::holds_alternative<LeapVersion>(bridge));
	CHECK(std::get<LeapVersion>(bridge).version == 6);
	CHECK(std::get<LeapVersion>(bridge).service_version.empty());
}

TEST_CASE("device events are read with ids of text and of numbers") {
	const LeapMessage original = parse_leap_message(
			R"({"event":{"type":"deviceEvent","state":{"id":"LP95597022824","type":"Peripheral",)"
			R"("attached":true,"streaming":true}}})");
	REQUIRE(std::holds_alternative<LeapDevice>(original));
	const auto &device = std::get<LeapDevice>(original);
	CHECK(device.id == "LP95597022824");
	CHECK(device.type == "peripheral");
	CHECK(device.attached);
	CHECK(device.streaming);
	const LeapMessage bridge = parse_leap_message(
			R"({"event":{"type":"deviceEvent","state":{"id":42,"type":"peripheral","attached":false,)"
			R"("streaming":true}}})");
	REQUIRE(std::holds_alternative<LeapDevice>(bridge));
	CHECK(std::get<LeapDevice>(bridge).id == "42");
	CHECK_FALSE(std::get<LeapDevice>(bridge).attached);
	CHECK_FALSE(std::get<LeapDevice>(bridge).streaming);
}

TEST_CASE("messages of no interest are no errors") {
	for (const std::string text : { "{}", R"({"event":{"type":"somethingElse"}})", R"({"focused":true})" }) {
		CAPTURE(text);
		CHECK(std::holds_alternative<LeapOther>(parse_leap_message(text)));
	}
}

TEST_CASE("messages that are unsound are errors that say why") {
	CHECK(error_of("undefined") == "invalid JSON");
	CHECK(error_of("") == "invalid JSON");
	CHECK(error_of(LEAP_EXAMPLE + "}") == "invalid JSON");
	CHECK(error_of(example_with("12.0", "nan")) == "invalid JSON");
	CHECK(error_of(example_with("12.0", "1e999")) == "invalid JSON");
	CHECK(error_of(std::string("{\"a\":\"\xff\"}")) == "invalid JSON");
	CHECK(error_of("[1]") == "message is not a JSON object");
	CHECK(error_of("6") == "message is not a JSON object");
	CHECK(error_of(example_with("\"id\":13319", "\"id\":\"13319\"")) == "frame: 'id' is not a number");
	CHECK(error_of(example_with("\"id\":13319,", "")) == "frame: 'id' is not a number");
	CHECK(error_of(example_with("810321011", "null")) == "frame: 'timestamp' is not a number");
	CHECK(error_of(example_with("810321011", "1e17")) == "frame: 'timestamp' is not a number");
	CHECK(error_of(R"({"id":1,"timestamp":2})") == "frame: 'hands' is not a list");
	CHECK(error_of(R"({"id":1,"timestamp":2,"hands":{}})") == "frame: 'hands' is not a list");
	CHECK(error_of(R"({"id":1,"timestamp":2,"hands":[],"pointables":3})") ==
			"frame: 'pointables' is not a list");
	CHECK(error_of(R"({"version":"6"})") == "'version' is not a number of 1..1000");
	CHECK(error_of(R"({"version":1e30})") == "'version' is not a number of 1..1000");
	CHECK(error_of(R"({"event":7})") == "'event' is not an object");
	CHECK(error_of(R"({"event":{"type":"deviceEvent"}})") == "device event: 'state' is not an object");
	CHECK(error_of(std::string(300000, ' ')) == "message of 300000 bytes, more than 262144");
}

TEST_CASE("whole numbers that the bridge prints with decimals are read") {
	const LeapFrame frame = frame_of(example_with("810321011", "810321011.000000"));
	CHECK(frame.timestamp_us == 810321011);
}

TEST_CASE("the client sends background, mode and focus, in at most 31 bytes each") {
	using Messages = std::array<std::string_view, 3>;
	CHECK(leap_greeting(LeapMounting::DESKTOP) ==
			Messages{ "{\"background\":true}", "{\"optimizeHMD\":false}", "{\"focused\":true}" });
	CHECK(leap_greeting(LeapMounting::HMD) ==
			Messages{ "{\"background\":true}", "{\"optimizeHMD\":true}", "{\"focused\":true}" });
	CHECK(leap_greeting(LeapMounting::SCREENTOP) ==
			Messages{ "{\"background\":true}", "{\"optimizeScreentop\":true}", "{\"focused\":true}" });
	CHECK(LEAP_SCREENTOP_OFF.size() <= 31);
	CHECK(leap_path(6) == "/v6.json");
}

TEST_CASE("close code 1001 before a version message lowers the version by one") {
	CHECK(next_version(6, 1001, false) == 5);
	CHECK(next_version(2, 1001, false) == 1);
	CHECK_FALSE(next_version(1, 1001, false).has_value());
	CHECK_FALSE(next_version(6, 1001, true).has_value());
	CHECK_FALSE(next_version(6, 1000, false).has_value());
	CHECK_FALSE(next_version(6, -1, false).has_value());
}

TEST_CASE("the delay between attempts doubles from 0.5 s to 8 s") {
	const std::vector<double> expected{ 0.5, 1.0, 2.0, 4.0, 8.0, 8.0 };
	for (std::size_t i = 0; i < expected.size(); ++i) {
		CHECK(reconnect_delay_s(static_cast<int>(i)) == expected[i]);
	}
	CHECK(reconnect_delay_s(2147483647) == 8.0);
	CHECK(reconnect_delay_s(-3) == 0.5);
}
