// Messages of Leap services that are damaged, hostile, or real.

#include "devices/leap_messages.h"
#include "devices/leap_protocol.h"
#include "tracking/track_csv.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <variant>

using namespace steadyhand;
using test::LEAP_EXAMPLE;

namespace {

/// All numbers finite, rotations of unit length, joints in reach.
bool is_sound(const LeapFrame &frame) {
	bool sound = frame.hands.size() <= LEAP_HANDS_MAX && std::isfinite(frame.frame_rate_hz);
	for (const LeapHand &hand : frame.hands) {
		sound = sound && hand.confidence >= 0.0 && hand.confidence <= 1.0 && hand.grab >= 0.0 &&
				hand.grab <= 1.0 && hand.pinch >= 0.0 && hand.pinch <= 1.0 &&
				std::isfinite(hand.time_visible_s) && hand.skeleton.has(SkeletonJoint::PALM);
		for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
			if ((hand.skeleton.positioned >> i & 1U) != 0) {
				sound = sound && hand.skeleton.positions_m[i].norm() <= LEAP_FARTHEST_M;
			}
			if ((hand.skeleton.rotated >> i & 1U) != 0) {
				sound = sound && std::abs(hand.skeleton.rotations[i].norm() - 1.0) < 1e-9;
			}
		}
	}
	return sound;
}

bool is_error_or_sound(const std::string &text) {
	const LeapMessage message = parse_leap_message(text);
	const auto *frame = std::get_if<LeapFrame>(&message);
	return frame == nullptr || is_sound(*frame);
}

/// Processor time for one message: the least of three runs, s.
double parse_s(const std::string &text) {
	double least_s = INFINITY;
	for (int run = 0; run < 3; ++run) {
		const std::clock_t start = std::clock();
		const LeapMessage message = parse_leap_message(text);
		CHECK(message.index() < std::variant_size_v<LeapMessage>);
		least_s = std::min(least_s, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
	}
	return least_s;
}

std::string repeated(const std::string &part, std::size_t size) {
	std::string text;
	while (text.size() + part.size() <= size) {
		text += part;
	}
	return text;
}

} // namespace

TEST_CASE("a frame that is cut off anywhere is an error") {
	for (std::size_t size = 0; size < LEAP_EXAMPLE.size(); ++size) {
		CAPTURE(size);
		CHECK(std::holds_alternative<Error>(parse_leap_message(LEAP_EXAMPLE.substr(0, size))));
	}
}

TEST_CASE("frames with changed bytes are errors, or frames of sound numbers") {
	std::mt19937 random(7);
	const std::string likely = "0123456789-+.eE,:[]{}\"ntfu\\ \xff";
	int frames = 0;
	for (int i = 0; i < 20000; ++i) {
		std::string text = LEAP_EXAMPLE;
		for (std::size_t change = 0; change <= random() % 4; ++change) {
			const std::size_t at = random() % text.size();
			text[at] =
					random() % 4 == 0 ? static_cast<char>(random() % 256) : likely[random() % likely.size()];
		}
		CAPTURE(text);
		CHECK(is_error_or_sound(text));
		frames += std::holds_alternative<LeapFrame>(parse_leap_message(text)) ? 1 : 0;
	}
	CHECK(frames > 1000);
}

TEST_CASE("bytes that are moved, doubled or dropped give errors or sound numbers") {
	std::mt19937 random(8);
	for (int i = 0; i < 5000; ++i) {
		std::string text = LEAP_EXAMPLE;
		const std::size_t from = random() % text.size();
		const std::size_t length = random() % 60;
		const std::string part = text.substr(from, length);
		if (random() % 2 == 0) {
			text.erase(from, length);
		}
		if (random() % 2 == 0) {
			text.insert(random() % (text.size() + 1), part);
		}
		CAPTURE(text);
		CHECK(is_error_or_sound(text));
	}
}

TEST_CASE("100,000 nested lists or objects do not overflow the stack") {
	for (const std::string open : { "[", "{\"a\":", "[[],", "{\"hands\":[" }) {
		CAPTURE(open);
		const std::string text = repeated(open, LEAP_MESSAGE_SIZE_MAX - 100);
		CHECK(std::holds_alternative<Error>(parse_leap_message(text)));
	}
	const std::string deep = std::string(100000, '[') + std::string(100000, ']');
	CHECK(std::holds_alternative<Error>(parse_leap_message(deep)));
	const LeapMessage frame = parse_leap_message(R"({"id":1,"timestamp":2,"hands":)" + deep + "}");
	REQUIRE(std::holds_alternative<LeapFrame>(frame));
	CHECK(std::get<LeapFrame>(frame).hands.empty());
}

TEST_CASE("the largest messages of any shape take about as long as one of hands") {
	constexpr std::size_t SIZE = LEAP_MESSAGE_SIZE_MAX - 1000;
	std::string keys = "{";
	std::string hands;
	for (int i = 0; keys.size() < SIZE; ++i) {
		keys += "\"" + std::to_string(i) + "\":1,";
	}
	for (int i = 0; hands.size() < SIZE; ++i) {
		hands += (i == 0 ? "" : ",") + test::leap_hand({ i, true, { 0.0, 0.2, 0.0 }, 1.0, {} });
	}
	const std::string tip = R"({"handId":7,"type":1,"tipPosition":[1,2,3]},)";
	const std::string hand = test::leap_hand({ 7, true, { 0.0, 0.2, 0.0 }, 1.0, {} });
	const double usual_s = parse_s(test::leap_frame(1, hands));
	// A parser whose time grows with the square of the size takes hundreds of times as long.
	for (const std::string &text : { keys + "\"a\":1}",
				 test::leap_frame(1, hand, repeated(tip, SIZE) + "null"),
				 repeated("[", LEAP_MESSAGE_SIZE_MAX), "{\"a\":\"" + repeated("\\u0041", SIZE) + "\"}",
				 "{\"a\":" + std::string(SIZE, '9') + "}", std::string(100 * LEAP_MESSAGE_SIZE_MAX, '[') }) {
		CAPTURE(text.substr(0, 20));
		CHECK(parse_s(text) < 20.0 * usual_s);
	}
}

TEST_CASE("real recordings come back as they were sent, in metres") {
	const std::filesystem::path folder = "../shared/real/leapjs_playback";
	if (!std::filesystem::exists(folder)) {
		MESSAGE("skipped: no " << folder.string() << " here");
		return;
	}
	int frames = 0;
	for (const auto &entry : std::filesystem::directory_iterator(folder)) {
		if (entry.path().extension() != ".csv") {
			continue;
		}
		CAPTURE(entry.path().filename().string());
		std::ostringstream text;
		text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
		const Result<Track> track = parse_track_csv(text.str(), "recording");
		REQUIRE(track.ok());
		for (const HandFrame &sent : track.value().frames) {
			if (!sent.has(Joint::PALM)) {
				continue;
			}
			std::vector<test::LeapTip> tips;
			for (int finger = 0; finger < 5; ++finger) {
				if (sent.has(static_cast<Joint>(finger))) {
					tips.push_back({ 3, finger, sent.positions_m[static_cast<std::size_t>(finger)] });
				}
			}
			const std::int64_t timestamp_us = std::llround(sent.t_s * 1e6);
			const LeapMessage message = parse_leap_message(test::leap_frame(
					timestamp_us, { { 3, true, sent.position(Joint::PALM), 1.0, sent.confidence } }, tips));
			REQUIRE(std::holds_alternative<LeapFrame>(message));
			const auto &frame = std::get<LeapFrame>(message);
			REQUIRE(frame.hands.size() == 1);
			HandFrame got = hand_frame_of(frame.hands[0].skeleton, frame.device_time_s());
			CHECK(got.tracked == sent.tracked);
			CHECK(std::abs(got.t_s - sent.t_s) < 1e-6);
			CHECK(std::abs(frame.hands[0].confidence - sent.confidence) < 1e-6);
			for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
				if (sent.has(static_cast<Joint>(i))) {
					CHECK((got.positions_m[i] - sent.positions_m[i]).norm() < 1e-8);
				}
			}
			++frames;
		}
	}
	CHECK(frames > 1000);
}
