#include "devices/liberty_bytes.h"
#include "devices/liberty_protocol.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace steadyhand;
using namespace steadyhand::liberty_bytes;
using Kind = LibertyMessage::Kind;

TEST_CASE("Liberty: the worked record reads as in the manual") {
	const std::vector<Read> messages = read_all(worked_record());
	REQUIRE(messages.size() == 1);
	CHECK(messages[0].kind == Kind::RECORD);
	const LibertyRecord &record = messages[0].record;
	CHECK(record.station == 1);
	CHECK(record.command == 'C');
	CHECK(record.device_time_ms == 12500);
	CHECK(record.frame_count == 3000);
	CHECK(record.distortion == 0);
	CHECK(record.fault == '\0');
	CHECK(record.is_tracked);
	CHECK(record.source_position_m.isApprox(Eigen::Vector3d(0.10, -0.025, 0.30)));
	CHECK(record.position_m.isApprox(Eigen::Vector3d(-0.025, -0.30, -0.10)));
	CHECK(record.rotation.isApprox(Eigen::Quaterniond::Identity()));
}

TEST_CASE("Liberty: a turn in the source frame is the same turn in Godot's axes") {
	// Godot's x is the source's y, y is -z, z is -x.
	Eigen::Matrix3d godot_of_source;
	godot_of_source << 0, 1, 0, 0, 0, -1, -1, 0, 0;
	const Eigen::Quaterniond source(0.5, -0.1, 0.7, 0.5);
	const Eigen::Quaterniond unit = source.normalized();
	Bytes bytes = record(3, 7, 1.0F, 2.0F, 3.0F);
	bytes.resize(8 + 24);
	for (const double q : { unit.w(), unit.x(), unit.y(), unit.z() }) {
		bytes = bytes + float_bytes(static_cast<float>(q));
	}
	const std::vector<Read> messages = read_all(bytes);
	REQUIRE(messages.size() == 1);
	const Eigen::Matrix3d expected = godot_of_source * unit.toRotationMatrix() * godot_of_source.transpose();
	CHECK(messages[0].record.rotation.toRotationMatrix().isApprox(expected, 1e-6));
	CHECK(messages[0].record.position_m.isApprox(godot_of_source * Eigen::Vector3d(0.01, 0.02, 0.03), 1e-6));
}

TEST_CASE("Liberty: a station counts if it is detected and active, in either order") {
	for (const char *hex : { "4c 59 00 15 00 00 04 00 03 00 0f 00", "4c 59 00 15 00 00 04 00 0f 00 03 00" }) {
		const std::vector<Read> messages = read_all(from_hex(hex));
		REQUIRE(messages.size() == 1);
		CHECK(messages[0].kind == Kind::STATION_MAP);
		CHECK(messages[0].stations == 0b11);
	}
}

TEST_CASE("Liberty: a refusal names command, code and what to do") {
	const Bytes text = from_text("Invalid Command\r\n");
	const std::vector<Read> messages = read_all(header(0, 'H', 1, text.size()) + text + worked_record());
	REQUIRE(messages.size() == 2);
	CHECK(messages[0].kind == Kind::REFUSAL);
	CHECK(messages[0].command == 'H');
	CHECK(messages[0].code == 1);
	CHECK(messages[0].owned == "Invalid Command");
	CHECK(messages[1].kind == Kind::RECORD);
	const std::vector<Read> alone = read_all(header(0, 0x15, 13, 0));
	REQUIRE(alone.size() == 1);
	CHECK(liberty_message_text(alone[0]) ==
			"Liberty: command '^U' failed with error 13: no sensor processor was found. Switch the tracker "
			"off and on if this comes again.");
}

TEST_CASE("Liberty: text without a header is a message of its own") {
	for (const char *end : { "\r\n", "" }) {
		const std::vector<Read> messages =
				read_all(from_text("Invalid Command") + from_text(end) + worked_record());
		REQUIRE(messages.size() == 2);
		CHECK(messages[0].kind == Kind::TEXT);
		CHECK(messages[0].owned == "Invalid Command");
		CHECK(messages[1].record.frame_count == 3000);
	}
}

TEST_CASE("Liberty: messages read the same wherever transfers are cut") {
	const Bytes map = from_hex("4c 59 00 15 00 00 04 00 03 00 0f 00");
	const Bytes stream = from_text("Invalid Command\r\n") + map + worked_record() + record(2, 3000, 1, 2, 3) +
			header(0, 'Q', 20, 5) + from_text("hello") + record(16, 3001, 4, 5, 6);
	for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
		LibertyParser parser;
		const std::vector<Read> messages = read_all(parser, stream, piece);
		REQUIRE(messages.size() == 6);
		CHECK(messages[0].owned == "Invalid Command");
		CHECK(messages[1].stations == 3);
		CHECK(messages[2].record.station == 1);
		CHECK(messages[3].record.station == 2);
		CHECK(messages[4].owned == "hello");
		CHECK(messages[5].record.station == 16);
		CHECK(messages[5].record.source_position_m.isApprox(Eigen::Vector3d(0.04, 0.05, 0.06), 1e-6));
		CHECK(parser.waiting_bytes() == 0);
	}
}

TEST_CASE("Liberty: random garbage between records hides none of them") {
	std::mt19937 random(7);
	std::size_t found = 0;
	constexpr std::uint32_t COUNT = 2000;
	LibertyParser parser;
	for (std::uint32_t frame = 1; frame <= COUNT; ++frame) {
		Bytes garbage(random() % 40);
		for (std::uint8_t &byte : garbage) {
			byte = static_cast<std::uint8_t>(random());
		}
		for (const Read &message :
				read_all(parser, garbage + record(1, frame, 10, 20, 30), 1 + random() % 60)) {
			if (message.kind == Kind::RECORD) {
				++found;
				CHECK(message.record.frame_count == found);
				CHECK(message.record.is_tracked);
			}
		}
	}
	CHECK(found == COUNT);
}

TEST_CASE("Liberty: tags among garbage do not hide the next record") {
	for (const char *hex : { "4c", "50", "4c 59", "4c 55", "50 41", "4c 4c", "4c 59 11", "4c 59 01 43 99",
				 "4c 59 01 43 00 00 ff ff", "4c 59 01 43 00 00 e9 03" }) {
		const std::vector<Read> messages = read_all(from_hex(hex) + worked_record());
		REQUIRE(messages.size() == 1);
		CHECK(messages[0].record.frame_count == 3000);
	}
}

TEST_CASE("Liberty: a record cut short at any byte costs no other record") {
	for (std::size_t size = 1; size < 48; ++size) {
		Bytes cut = record(1, 100, 30.0F, 10.0F, -25.0F, 0, 0.6F);
		const Bytes y = float_bytes(0.8F);
		std::copy(y.begin(), y.end(), cut.end() - 4);
		cut.resize(size);
		const std::vector<Read> messages = read_all(cut + record(1, 101, 1, 2, 3) + record(1, 102, 4, 5, 6));
		REQUIRE(messages.size() == 2);
		CHECK(messages[0].record.frame_count == 101);
		CHECK(messages[1].record.frame_count == 102);
		CHECK(messages[1].record.is_tracked);
	}
}

TEST_CASE("Liberty: time stamps that look like a header are read as numbers") {
	// 0x0201594C ms: the bytes of the time stamp are 'L', 'Y', 1, 2.
	const Bytes bytes = header(1, 'C', 0, 40) +
			from_hex("4c 59 01 02 00 00 28 00 00 00 00 00 00 00 20 41 00 00 20 c0 "
					 "00 00 f0 41 00 00 80 3f 00 00 00 00 00 00 00 00 00 00 00 00");
	const std::vector<Read> messages = read_all(bytes);
	REQUIRE(messages.size() == 1);
	CHECK(messages[0].record.device_time_ms == 0x0201594C);
	CHECK(messages[0].record.frame_count == 0x00280000);
}

TEST_CASE("Liberty: a damaged stream gives finite poses and loses nothing for long") {
	std::mt19937 random(23);
	LibertyParser parser;
	for (int round = 0; round < 3000; ++round) {
		Bytes stream;
		for (std::uint32_t frame = 0; frame < 4; ++frame) {
			stream = stream + record(1 + frame % 2, frame, 10, 20, 30);
		}
		for (std::uint32_t i = random() % 4; i > 0; --i) { // changed, lost and doubled bytes
			const auto place = stream.begin() + static_cast<std::ptrdiff_t>(random() % stream.size());
			switch (random() % 3) {
				case 0:
					*place = static_cast<std::uint8_t>(random());
					break;
				case 1:
					stream.erase(place);
					break;
				default:
					stream.insert(place, *place);
					break;
			}
		}
		for (const Read &message : read_all(parser, stream, 1 + random() % 100)) {
			CHECK(message.record.position_m.allFinite());
			CHECK(message.record.rotation.norm() == doctest::Approx(1.0));
		}
		// The longest frame that a changed length can announce, and the records that show that there is none.
		const std::vector<Read> after = read_all(parser, record(3, 7, 1, 2, 3) + record(4, 8, 1, 2, 3), 96);
		REQUIRE_FALSE(after.empty());
		CHECK(after.back().record.station == 4);
		CHECK(parser.waiting_bytes() == 0);
	}
}

TEST_CASE("Liberty: endless garbage is skipped without growth, then a record is read") {
	std::mt19937 random(11);
	LibertyParser parser;
	LibertyMessage message;
	for (int i = 0; i < 200; ++i) {
		Bytes garbage(20000);
		for (std::uint8_t &byte : garbage) {
			byte = static_cast<std::uint8_t>('a' + random() % 26);
		}
		parser.feed(garbage);
		while (parser.next(message)) {
			CHECK(message.kind == Kind::TEXT);
		}
		CHECK(parser.waiting_bytes() < LibertyParser::BODY_SIZE_MAX + LibertyParser::HEADER_SIZE);
	}
	parser.feed(worked_record());
	int records = 0;
	while (parser.next(message)) {
		records += message.kind == Kind::RECORD ? 1 : 0;
	}
	CHECK(records == 1);
	CHECK(parser.skipped_bytes() > 3'000'000);
}

TEST_CASE("Liberty: a record of another output list is refused with advice") {
	const Bytes bytes = header(2, 'C', 0, 28) + Bytes(28, 0) + worked_record();
	const std::vector<Read> messages = read_all(bytes);
	REQUIRE(messages.size() == 2);
	CHECK(messages[0].kind == Kind::WRONG_RECORD);
	CHECK(liberty_message_text(messages[0]) ==
			"Liberty station 2: a record has 28 bytes, must have 40. Another program changed the output "
			"list. "
			"Close it, then start the tracker again.");
	CHECK(messages[1].kind == Kind::RECORD);
}

TEST_CASE("Liberty: positions that cannot be are not tracked") {
	const float nan = std::numeric_limits<float>::quiet_NaN(),
				infinity = std::numeric_limits<float>::infinity();
	for (const float x : { nan, infinity, -infinity, 3000.0F, -1e30F }) {
		const std::vector<Read> messages = read_all(record(1, 5, x, 1, 1));
		REQUIRE(messages.size() == 1);
		CHECK_FALSE(messages[0].record.is_tracked);
		CHECK(messages[0].record.frame_count == 5);
		CHECK(messages[0].record.position_m.isZero());
	}
	CHECK_FALSE(read_all(record(1, 5, 0, 0, 0))[0].record.is_tracked);
	CHECK_FALSE(read_all(record(1, 5, 1, 1, 1, 0, 0.0F))[0].record.is_tracked);
	CHECK_FALSE(read_all(record(1, 5, 1, 1, 1, 0, nan))[0].record.is_tracked);
	CHECK(read_all(record(1, 5, 1500, 0, 0))[0].record.is_tracked);
}

TEST_CASE("Liberty: a fault letter comes with its record") {
	for (const char letter : std::string_view("abcdefgABCDEFGIu")) {
		const std::vector<Read> messages = read_all(record(1, 5, 1, 2, 3, static_cast<std::uint8_t>(letter)));
		REQUIRE(messages.size() == 1);
		CHECK(messages[0].kind == Kind::RECORD);
		CHECK(messages[0].record.fault == letter);
		CHECK(messages[0].record.is_tracked);
		CHECK(liberty_error_text(static_cast<std::uint8_t>(letter)) != "unknown error");
	}
	CHECK(liberty_error_text('e') == "the source fails in axes x and z");
	CHECK(liberty_error_text(3) == "invalid parameter");
	CHECK(liberty_error_text(24) == "the firmware of the I/O processor is outdated");
	CHECK(liberty_error_text(25) == "unknown error");
	CHECK(read_all(record(1, 5, 1, 2, 3, ' '))[0].record.fault == '\0');
}

TEST_CASE("Liberty: Patriot and Latus tags are read too") {
	for (const char *tag : { "PA", "LU" }) {
		Bytes bytes = worked_record();
		bytes[0] = static_cast<std::uint8_t>(tag[0]);
		bytes[1] = static_cast<std::uint8_t>(tag[1]);
		CHECK(read_all(bytes).size() == 1);
	}
}
