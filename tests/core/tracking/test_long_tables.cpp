// The time for a line is proportional to its length, and long cells give short messages.

#include "tracking/csv_text.h"
#include "tracking/track_csv.h"
#include "tracking/trial_set.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

using namespace steadyhand;

namespace {

std::string repeated(std::string_view unit, std::size_t count) {
	std::string text;
	text.reserve(unit.size() * count);
	for (std::size_t i = 0; i < count; ++i) {
		text += unit;
	}
	return text;
}

std::string header_of(std::size_t columns) {
	std::string text = "t";
	for (std::size_t i = 0; i < columns; ++i) {
		text += ",c" + std::to_string(i);
	}
	return text + '\n';
}

constexpr std::string_view TRIALS_HEADER =
		"trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_z,axis_x,axis_y,axis_z,"
		"amplitude_m";

} // namespace

// A quadratic algorithm needs minutes to hours for these lines, and exceeds the time limit of the suite.
TEST_SUITE("long tables") {
	TEST_CASE("a line of two million open quotes is split at its commas") {
		std::vector<std::string_view> cells;
		std::string unescaped;
		const std::size_t count = 2'000'000;
		for (const std::string_view unit : { ",\"a", ",\"\"a", " ,\t\"a\" b", ",\"a\"\"b" }) {
			const std::string line = "t" + repeated(unit, count);
			split_cells(line, cells, unescaped);
			CHECK(cells.size() == count + 1);
		}
	}

	TEST_CASE("a header that repeats an open quote is refused") {
		const Result<Track> track = parse_track_csv("t," + repeated(",\"a", 1'000'000) + "\n", "a.csv");
		REQUIRE_FALSE(track.ok());
		CHECK(track.error() == "a.csv:1: \"a: the column comes twice");
	}

	TEST_CASE("a header of 300,000 columns is read") {
		const Result<Track> track = parse_track_csv(header_of(300'000), "a.csv");
		REQUIRE_MESSAGE(track.ok(), track.error());
		CHECK(track.value().unknown_columns.size() == 300'000);
		const std::string more = ',' + header_of(300'000);
		CHECK(parse_trials_csv(std::string(TRIALS_HEADER) + more, "trials.csv").ok());
		CHECK_FALSE(parse_trials_csv(header_of(300'000), "trials.csv").ok());
	}

	TEST_CASE("the last of 300,000 columns that comes twice is named") {
		std::string header = header_of(300'000);
		header.insert(header.size() - 1, ",c299999");
		const Result<Track> track = parse_track_csv(header, "a.csv");
		REQUIRE_FALSE(track.ok());
		CHECK(track.error() == "a.csv:1: c299999: the column comes twice");
	}

	TEST_CASE("faults of many rows under a long column name stay short") {
		const std::string name = repeated("\xC3\xA4", 50'000);
		std::string text = std::string(TRIALS_HEADER) + ',' + name + '\n';
		text += repeated("a,tap,stable,s,0,1,0,0,0,1,0,0,0.1\n", 10'000); // without the last cell
		const Result<TrialTable> table = parse_trials_csv(text, "trials.csv");
		REQUIRE_MESSAGE(table.ok(), table.error());
		CHECK(table.value().faults.size() == 10'000);
		CHECK(table.value().faults.front() ==
				"trials.csv:2: " + repeated("\xC3\xA4", 20) + "...: the row ends after 13 cells of 14");
	}

	TEST_CASE("rows of open quotes are read in a track of two columns") {
		const std::string text = "t,note\n" + repeated("1,\"a\n", 200'000);
		const Result<Track> track = parse_track_csv(text, "a.csv");
		REQUIRE_MESSAGE(track.ok(), track.error());
		CHECK(track.value().frames.size() == 200'000);
	}
}
