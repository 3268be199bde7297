#include "tracking/track_csv.h"

#include <doctest/doctest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>

using namespace steadyhand;

namespace {

std::string error_of(std::string_view text) {
	const Result<Track> track = parse_track_csv(text, "a.csv");
	return track ? "no error" : track.error();
}

Track parsed(std::string_view text) {
	Result<Track> track = parse_track_csv(text, "a.csv");
	REQUIRE_MESSAGE(track.ok(), track.error());
	return std::move(track).value();
}

/// Random finite double with a uniform exponent.
double any_double(std::mt19937_64 &r_engine, double magnitude_max) {
	for (;;) {
		const double number = std::bit_cast<double>(r_engine());
		if (std::isfinite(number) && std::abs(number) <= magnitude_max) {
			return number;
		}
	}
}

bool same_bits(double left, double right) {
	return std::bit_cast<std::uint64_t>(left) == std::bit_cast<std::uint64_t>(right);
}

Track any_track(std::mt19937_64 &r_engine) {
	Track track;
	track.joints = static_cast<std::uint8_t>(r_engine() & 0x7F);
	track.has_confidence = (r_engine() & 1U) != 0;
	track.metadata = { { "origin", "a test: with a colon" }, { "", "a plain comment" }, { "empty", "" } };
	if ((r_engine() & 1U) != 0) {
		track.unknown_columns = { { "hand id", {} }, { "größe", {} } };
	}
	double t_s = any_double(r_engine, 1e6);
	const std::size_t count = r_engine() % 8;
	for (std::size_t i = 0; i < count; ++i) {
		HandFrame frame;
		t_s += std::abs(any_double(r_engine, 1e3));
		frame.t_s = t_s;
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			if (((track.joints >> joint) & 1U) != 0 && (r_engine() & 3U) != 0) {
				frame.set(static_cast<Joint>(joint),
						{ any_double(r_engine, 1e9), any_double(r_engine, 1e9), any_double(r_engine, 1e9) });
			}
		}
		if (track.has_confidence) {
			frame.confidence = std::abs(any_double(r_engine, 1.0));
		}
		track.frames.push_back(frame);
		for (UnknownColumn &column : track.unknown_columns) {
			column.cells.push_back((r_engine() & 1U) != 0 ? "µ" : (r_engine() & 1U) != 0 ? "\"a\"" : "");
		}
	}
	return track;
}

void check_same(const Track &left, const Track &right) {
	CHECK(left.joints == right.joints);
	CHECK(left.has_confidence == right.has_confidence);
	CHECK(left.metadata == right.metadata);
	REQUIRE(left.unknown_columns.size() == right.unknown_columns.size());
	for (std::size_t i = 0; i < left.unknown_columns.size(); ++i) {
		CHECK(left.unknown_columns[i].name == right.unknown_columns[i].name);
		CHECK(left.unknown_columns[i].cells == right.unknown_columns[i].cells);
	}
	REQUIRE(left.frames.size() == right.frames.size());
	for (std::size_t i = 0; i < left.frames.size(); ++i) {
		CHECK(same_bits(left.frames[i].t_s, right.frames[i].t_s));
		CHECK(same_bits(left.frames[i].confidence, right.frames[i].confidence));
		REQUIRE(left.frames[i].tracked == right.frames[i].tracked);
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			for (Eigen::Index axis = 0; left.frames[i].has(static_cast<Joint>(joint)) && axis < 3; ++axis) {
				CHECK(same_bits(
						left.frames[i].positions_m[joint][axis], right.frames[i].positions_m[joint][axis]));
			}
		}
	}
}

} // namespace

TEST_SUITE("track CSV") {
	TEST_CASE("columns may have any order; empty cells are untracked, unknown columns kept") {
		const Track track = parsed("# subject: anna\n"
								   "# sensor: leap: second unit\n"
								   "#recorded at 12:30\n"
								   "confidence,index_z,valid,index_x,t,index_y\n"
								   "0.5,3,yes,1,0.25,2\n"
								   ",3,,1,0.25,\n");
		CHECK(track.metadata ==
				std::vector<std::pair<std::string, std::string>>{ { "subject", "anna" },
						{ "sensor", "leap: second unit" }, { "", "recorded at 12:30" } });
		CHECK(track.joints == 0b0000010);
		CHECK(track.has_confidence);
		REQUIRE(track.frames.size() == 2);
		CHECK(track.frames[0].t_s == 0.25);
		CHECK(track.frames[0].confidence == 0.5);
		CHECK(track.frames[0].has(Joint::INDEX));
		CHECK(track.frames[0].position(Joint::INDEX) == Eigen::Vector3d(1, 2, 3));
		CHECK_FALSE(track.frames[1].has(Joint::INDEX));
		CHECK(track.frames[1].confidence == 1.0);
		REQUIRE(track.unknown_columns.size() == 1);
		CHECK(track.unknown_columns[0].name == "valid");
		CHECK(track.unknown_columns[0].cells == std::vector<std::string>{ "yes", "" });
	}

	TEST_CASE("byte order mark, CRLF, spaces, plus signs and blank lines are read") {
		const std::string expected =
				format_track_csv(parsed("# a: b\nt,palm_x,palm_y,palm_z\n1,2,3,4\n2,,,\n"));
		CHECK(expected == "# a: b\nt,palm_x,palm_y,palm_z\n1,2,3,4\n2,,,\n");
		for (const std::string_view text :
				{ "\xEF\xBB\xBF# a: b\r\nt,palm_x,palm_y,palm_z\r\n1,2,3,4\r\n2,,,\r\n",
						"# a: b\nt, palm_x ,palm_y,palm_z\n+1.0,\t2, 3,4e0\n2,,,",
						"# a: b\n\nt,palm_x,palm_y,palm_z\n1,2,3,4\n2,,,\n\n \n" }) {
			CHECK(format_track_csv(parsed(text)) == expected);
		}
	}

	TEST_CASE("quoted cells are read, as R and spreadsheets write them") {
		const std::string text = "t,palm_x,palm_y,palm_z,note\n1,2,3,4,\"a,b\"\n2,,,,\n";
		CHECK(format_track_csv(parsed("\"t\",\"palm_x\",\"palm_y\",\"palm_z\",\"note\"\n"
									  "\"1\", \"2\" ,3,\"4\",\"a,b\"\n2,\"\",,\"\",\"\"\n")) == text);
		// A quote within a cell, or one that is not closed before a comma, is text.
		for (const std::string cell : { "\"", "\"a", "5\"", "a \"b\"", "\"a\" b", "\"\"a\"\"" }) {
			const Track track = parsed("t,note\n1," + cell + "\n2,b\n");
			CHECK(track.unknown_columns[0].cells[1] == "b");
			check_same(track, parsed(format_track_csv(track)));
		}
		for (const std::string two_columns : { "\"a,b\",a b", "\"a \"\"b\"\", c\",\"a \"\"b\"\"  c\"" }) {
			const Track track = parsed("t," + two_columns + "\n1,\"left, then right\",\"5\"\", 6\"\"\"\n");
			check_same(track, parsed(format_track_csv(track)));
			CHECK(track.unknown_columns[0].cells[0] == "left, then right");
		}
		CHECK(parsed("t,note,next\n1,\"a \"\"b\"\", c\",\"5\"\"\"\n").unknown_columns[0].cells[0] ==
				"a \"b\", c");
		CHECK(parsed("t,note,next\n1,\"a \"\"b\"\", c\",\"5\"\"\"\n").unknown_columns[1].cells[0] == "5\"");
		CHECK(parsed("t,note\n1,\"\"a\"\"\n").unknown_columns[0].cells[0] == "\"a\"");
	}

	TEST_CASE("any quotes, commas and blanks in cells read back as they are") {
		std::mt19937_64 engine(5);
		const std::string alphabet = "\"\"\",, a";
		for (int i = 0; i < 20000; ++i) {
			std::string row = "1";
			for (std::size_t length = engine() % 30; length > 0; --length) {
				row += alphabet[engine() % alphabet.size()];
			}
			const Result<Track> track = parse_track_csv("t,a,b,c\n" + row, "a.csv");
			if (track) {
				check_same(track.value(), parsed(format_track_csv(track.value())));
			}
		}
	}

	TEST_CASE("metadata that begins with a colon reads back as it is") {
		for (const std::string line : { "# : a: b", "# :", "# : : a", "# :: a" }) {
			const Track track = parsed(line + "\nt\n");
			check_same(track, parsed(format_track_csv(track)));
		}
	}

	TEST_CASE("a track without rows, or with only times, is valid") {
		CHECK(parsed("t\n").frames.empty());
		CHECK(parsed("t\n1\n1\n2").frames.size() == 3);
	}

	TEST_CASE("any track reads back to the last bit") {
		std::mt19937_64 engine(20261121);
		for (int i = 0; i < 300; ++i) {
			const Track track = any_track(engine);
			check_same(track, parsed(format_track_csv(track)));
		}
	}

	TEST_CASE("numbers at the edges of double read back exactly") {
		for (const double x :
				{ 0.0, -0.0, 5e-324, std::numeric_limits<double>::min(), 0.1, 1.0 / 3.0, 1e9, -1e9 }) {
			HandFrame frame;
			frame.set(Joint::WRIST, { x, -x, 1.0 });
			std::string text = track_csv_header({ .joints = 1U << 6 });
			append_track_csv_row(text, frame, { .joints = 1U << 6 });
			const Track track = parsed(text);
			CHECK(same_bits(track.frames[0].position(Joint::WRIST).x(), x));
			CHECK(same_bits(track.frames[0].position(Joint::WRIST).y(), -x));
		}
	}

	TEST_CASE("rows written one by one equal the formatted track") {
		std::mt19937_64 engine(7);
		for (int i = 0; i < 50; ++i) {
			Track track = any_track(engine);
			track.unknown_columns.clear();
			const TrackColumns columns{ track.joints, track.has_confidence };
			std::string text = track_csv_header(columns, track.metadata);
			for (const HandFrame &frame : track.frames) {
				append_track_csv_row(text, frame, columns);
			}
			CHECK(text == format_track_csv(track));
		}
	}

	TEST_CASE("invalid values are written so that the file can be read") {
		HandFrame frame;
		frame.set(Joint::INDEX, { 1.0, std::numeric_limits<double>::quiet_NaN(), 2.0 });
		frame.confidence = std::numeric_limits<double>::quiet_NaN();
		const TrackColumns columns{ .joints = 1U << 1, .confidence = true };
		std::string text = track_csv_header(columns, { { "note", "two\nlines\r, and a comma" } });
		append_track_csv_row(text, frame, columns);
		CHECK(text == "# note: two lines , and a comma\nt,index_x,index_y,index_z,confidence\n0,,,,0\n");
		CHECK_FALSE(parsed(text).frames[0].has(Joint::INDEX));
	}

	TEST_CASE("a truncated recording keeps every frame before the cut") {
		const std::string whole = "t,index_x,index_y,index_z,note\n1,2,3,4,a\n2,3,4,5,b\n3,4,5,6,c\n";
		const TrackReading reading = read_track_csv(whole.substr(0, whole.size() - 5), "a.csv");
		CHECK(reading.track.frames.size() == 2);
		CHECK(reading.track.unknown_columns[0].cells.size() == 2);
		REQUIRE(reading.error);
		CHECK(reading.error->message == "a.csv:4: index_z: the row ends after 3 cells of 5");
		CHECK(reading.is_cut_off);
		CHECK_FALSE(read_track_csv(whole, "a.csv").is_cut_off);
		CHECK_FALSE(read_track_csv(whole.substr(0, whole.size() - 5) + "\n", "a.csv").is_cut_off);
		CHECK_FALSE(read_track_csv("t,index_x", "a.csv").is_cut_off);
	}

	TEST_CASE("any truncated recording gives a track or one error") {
		std::mt19937_64 engine(3);
		Track track = any_track(engine);
		while (track.frames.size() < 3) {
			track = any_track(engine);
		}
		const std::string whole = format_track_csv(track);
		for (std::size_t length = 0; length < whole.size(); ++length) {
			CHECK(read_track_csv(whole.substr(0, length), "a.csv").track.frames.size() <=
					track.frames.size());
		}
	}

	TEST_CASE("bad input gives one error with file, line and column") {
		const std::string header = "t,index_x,index_y,index_z,confidence\n";
		CHECK(error_of("") == "a.csv:1: no header line");
		CHECK(error_of("# only: metadata\n") == "a.csv:1: no header line");
		CHECK(error_of("time,index_x,index_y,index_z\n") ==
				"a.csv:1: t: the header has no such column. Rename the column of times in seconds to 't'");
		CHECK(error_of("0.01,0.1,0.2,0.3\n0.02,0.1,0.2,0.3\n") ==
				"a.csv:1: no header line: the first line holds values, '0.01'");
		CHECK(error_of("# a: b\nt,t\n") == "a.csv:2: t: the column comes twice");
		CHECK(error_of("# a: b\nt;index_x;index_y;index_z\n0,1;0,2;0,3;0,4\n") ==
				"a.csv:2: cells are separated by ';': they must be by ',', and numbers have a '.'");
		CHECK(error_of("t\tindex_x\tindex_y\tindex_z\n0.1\t0.2\t0.3\t0.4\n") ==
				"a.csv:1: cells are separated by tabs: they must be by ',', and numbers have a '.'");
		CHECK(error_of("t,a;b\n1,2;3\n") == "no error");
		CHECK(error_of("t,note,note\n") == "a.csv:1: note: the column comes twice");
		CHECK(error_of("t,index_x\n") ==
				"a.csv:1: index_y: the header has no such column. Add it, because a joint needs x, y and z");
		CHECK(error_of("t,palm_x,palm_y,index_z\n") ==
				"a.csv:1: index_x: the header has no such column. Add it, because a joint needs x, y and z");
		CHECK(error_of(header + "1,2,3\n") == "a.csv:2: index_z: the row ends after 3 cells of 5");
		CHECK(error_of(header + "1\n") == "a.csv:2: index_x: the row ends after 1 cell of 5");
		CHECK(error_of(header + "1,2,3,4,1,6\n") == "a.csv:2: 6 cells under a header of 5");
		CHECK(error_of(header + "1,2,abc,4,1\n") == "a.csv:2: index_y: 'abc' is not a number");
		CHECK(error_of(header + "1,2,3.5m,4,1\n") == "a.csv:2: index_y: '3.5m' is not a number");
		CHECK(error_of(header + "1,2,0x10,4,1\n") == "a.csv:2: index_y: '0x10' is not a number");
		CHECK(error_of(header + "1,2,+-1,4,1\n") == "a.csv:2: index_y: '+-1' is not a number");
		CHECK(error_of(header + "1,2,\"3,4,1\n") == "a.csv:2: index_y: '\"3' is not a number");
		CHECK(error_of(header + "1,2,\"3\"4,4,1\n") == "a.csv:2: index_y: '\"3\"4' is not a number");
		CHECK(error_of(header + "1,2,\"3,4\",1\n") == "a.csv:2: confidence: the row ends after 4 cells of 5");
		CHECK(error_of(header + "1,nan,3,4,1\n") == "a.csv:2: index_x: 'nan' is not finite");
		CHECK(error_of(header + "1,2,3,-inf,1\n") == "a.csv:2: index_z: '-inf' is not finite");
		CHECK(error_of(header + "NaN,2,3,4,1\n") == "a.csv:2: t: 'NaN' is not finite");
		CHECK(error_of(header + "1,2,3,1e400,1\n") == "a.csv:2: index_z: '1e400' is out of range");
		CHECK(error_of(header + "1,2,3,1e10,1\n") ==
				"a.csv:2: index_z: '1e10' is out of range, at most 1e+09");
		CHECK(error_of(header + "1e300,2,3,4,1\n") == "a.csv:2: t: '1e300' is out of range, at most 1e+12");
		CHECK(error_of(header + ",2,3,4,1\n") == "a.csv:2: t: '' is not a number");
		CHECK(error_of(header + "1,2,3,4,1.5\n") == "a.csv:2: confidence: '1.5' is not within 0..1");
		CHECK(error_of(header + "1,2,3,4,1\n0.5,2,3,4,1\n") == "a.csv:3: t: 0.5 is before the row above");
		CHECK(error_of(header + "\n1,2,3,4,1\n") == "a.csv:2: t: a blank line among the rows");
		CHECK(error_of(header + std::string("1,2,3,\x00,1\n", 10)) ==
				"a.csv:2: index_z: byte 0x00 is not text");
		CHECK(error_of("t,note\n1,\xC3\x28\n") == "a.csv:2: note: byte 0xc3 is not text");
		CHECK(error_of("t,note\n1,\xED\xA0\x80\n") == "a.csv:2: note: byte 0xed is not text");
		CHECK(error_of("# a: \x01\nt\n") == "a.csv:1: metadata: '# a: \\x01' is not text");
		CHECK(error_of("\xFF\xFEt\n") == "a.csv:1: column 1: byte 0xff is not text");
		CHECK(error_of(header + "1," + std::string(100, 'x') + ",3,4,1\n") ==
				"a.csv:2: index_x: '" + std::string(40, 'x') + "...' is not a number");
	}

	TEST_CASE("random bytes give an error or a track") {
		std::mt19937_64 engine(11);
		const std::string alphabet("t,index_xyz#: 0123456789.e-+\n\r\"\x00\xC3\xA4\xFF", 35);
		for (int i = 0; i < 5000; ++i) {
			std::string text = i % 2 == 0 ? "" : "t,index_x,index_y,index_z\n";
			for (std::size_t length = engine() % 60; length > 0; --length) {
				text += alphabet[engine() % alphabet.size()];
			}
			const TrackReading reading = read_track_csv(text, "a.csv");
			if (reading.error) {
				CHECK(reading.error->message.starts_with("a.csv:"));
			} else {
				CHECK(parse_track_csv(format_track_csv(reading.track), "b.csv").ok());
			}
		}
	}

	TEST_CASE("a locale with a decimal comma changes nothing") {
		const std::string before = std::setlocale(LC_ALL, nullptr);
		const bool has_locale = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
		const Track track = parsed("t,palm_x,palm_y,palm_z\n0.5,1.25,2.5,-3.75\n");
		CHECK(track.frames[0].position(Joint::PALM) == Eigen::Vector3d(1.25, 2.5, -3.75));
		CHECK(format_track_csv(track) == "t,palm_x,palm_y,palm_z\n0.5,1.25,2.5,-3.75\n");
		if (!has_locale) {
			MESSAGE("skipped: no German locale here");
		}
		std::setlocale(LC_ALL, before.c_str());
	}

	TEST_CASE("real recordings are read and read back the same") {
		const std::filesystem::path folder = "../shared/real";
		if (!std::filesystem::exists(folder)) {
			MESSAGE("skipped: no ../shared/real here");
			return;
		}
		int count = 0;
		for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
			const std::string name = entry.path().filename().string();
			if (!name.ends_with(".csv") || name == "trials.csv" || name == "pairs.csv" ||
					name == "metrics.csv") {
				continue;
			}
			std::ostringstream text;
			text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
			const Result<Track> track = parse_track_csv(text.str(), name);
			REQUIRE_MESSAGE(track.ok(), track.error());
			CHECK(track.value().frames.size() > 10);
			check_same(track.value(), parsed(format_track_csv(track.value())));
			++count;
		}
		CHECK(count > 0);
	}

	TEST_CASE("times in milliseconds and positions in millimetres each give a warning") {
		const auto warnings_of = [](double per_s, double per_m) {
			std::string text = "t,index_x,index_y,index_z\n";
			for (int i = 0; i < 200; ++i) {
				const double t_s = i / 90.0;
				text += std::to_string(per_s * t_s) + ',' +
						std::to_string(per_m * 0.2 * std::sin(3.0 * t_s)) + ",0,0\n";
			}
			return read_track_csv(text, "a.csv").warnings;
		};
		CHECK(warnings_of(1.0, 1.0).empty());
		const std::vector<std::string> times = warnings_of(1e3, 1.0);
		REQUIRE(times.size() == 1);
		CHECK(times.front() == "a.csv:32: t: frames are more than a second apart. Give times in seconds");
		for (const double per_m : { 1e2, 1e3 }) {
			const std::vector<std::string> lengths = warnings_of(1.0, per_m);
			REQUIRE(lengths.size() == 1);
			CHECK(lengths.front().find(": positions: the hand has been faster than 10 m/s") !=
					std::string::npos);
		}
	}
}

TEST_CASE("a track whose columns name no joint is warned of") {
	const auto warnings_of = [](std::string_view text) { return read_track_csv(text, "a.csv").warnings; };
	// The second one has an error in its second row, and the frame before it.
	for (const std::string_view text : { "t,index_tip_x,note\n1,2,3\n", "t,note\n1,a\n0.5,b\n" }) {
		CHECK(warnings_of(text) ==
				std::vector<std::string>{
						"a.csv:1: no column is named after a joint, so no hand is seen. Name those of "
						"the index fingertip index_x, index_y, index_z" });
	}
	CHECK(warnings_of("t,ring_x,ring_y,ring_z,note\n1,2,3,4,5\n").empty());
	CHECK(warnings_of("t\n1\n").empty());
}
