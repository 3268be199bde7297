// A jump of the clock in a track is removed, with a warning.

#include "tracking/track_csv.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace steadyhand;

namespace {

/// Rows of time, a note and a resting fingertip, under one line of metadata: the first row is line 3.
std::string track_of(const std::vector<std::string> &times) {
	std::string text = "# a: b\nt,note,index_x,index_y,index_z\n";
	for (std::size_t i = 0; i < times.size(); ++i) {
		text += times[i] + ',' + std::to_string(i) + ",0,1,0\n";
	}
	return text;
}

TrackReading reading_of(const std::vector<std::string> &times) {
	TrackReading reading = read_track_csv(track_of(times), "a.csv");
	CHECK_FALSE(reading.error);
	CHECK(reading.track.frames.size() == times.size());
	return reading;
}

std::vector<double> times_of(const TrackReading &reading) {
	std::vector<double> times_s;
	for (const HandFrame &frame : reading.track.frames) {
		times_s.push_back(frame.t_s);
	}
	return times_s;
}

} // namespace

TEST_SUITE("clock jumps") {
	TEST_CASE("one jump of 200,000 s is closed up with one warning") {
		const TrackReading reading = reading_of({ "0", "0.5", "1", "200001", "200001.5", "200002.25" });
		CHECK(times_of(reading) == std::vector<double>{ 0.0, 0.5, 1.0, 1.5, 2.0, 2.75 });
		REQUIRE(reading.warnings.size() == 1);
		CHECK(reading.warnings.front() ==
				"a.csv:6: t: the clock jumps by 200000 s; this row is read as 0.5 s after the row above");
		CHECK(reading.track.unknown_columns[0].cells.size() == 6);
	}

	TEST_CASE("two jumps are both closed up, each with its line") {
		const TrackReading reading = reading_of({ "0", "1", "2", "1e6", "1000001", "1000002", "2e6" });
		CHECK(times_of(reading) == std::vector<double>{ 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 });
		REQUIRE(reading.warnings.size() == 2);
		CHECK(reading.warnings[0].starts_with("a.csv:6: t: "));
		CHECK(reading.warnings[1].starts_with("a.csv:9: t: "));
	}

	TEST_CASE("a pause of an hour stays as it is") {
		const TrackReading reading = reading_of({ "0", "0.5", "3600.5", "3601" });
		CHECK(times_of(reading) == std::vector<double>{ 0.0, 0.5, 3600.5, 3601.0 });
		CHECK(reading.warnings.empty());
	}

	TEST_CASE("a first time of days is no jump") {
		CHECK(reading_of({ "900000", "900000.5" }).warnings.empty());
	}

	TEST_CASE("microseconds get one warning and keep their times") {
		const TrackReading reading = reading_of({ "0", "10000", "20000", "30000" });
		CHECK(times_of(reading) == std::vector<double>{ 0.0, 10000.0, 20000.0, 30000.0 });
		REQUIRE(reading.warnings.size() == 1);
		CHECK(reading.warnings.front() ==
				"a.csv:4: t: most rows are more than an hour apart; times must be in seconds");
	}

	TEST_CASE("ten of many jumps have a warning each, the others one together") {
		std::vector<std::string> times;
		for (int i = 0; i < 100; ++i) {
			for (int k = 0; k < 4; ++k) {
				times.push_back(std::to_string(10000 * i + k));
			}
		}
		const TrackReading reading = reading_of(times);
		REQUIRE(reading.warnings.size() == 11);
		CHECK(reading.warnings.back() == "a.csv:399: t: 89 more clock jumps up to this line");
		CHECK(times_of(reading).back() == 399.0);
	}

	TEST_CASE("a clock that goes back is an error") {
		for (const char *const back : { "0.5", "-200000" }) {
			const TrackReading reading = read_track_csv(track_of({ "0", "1", back }), "a.csv");
			REQUIRE(reading.error);
			CHECK(reading.error->message == "a.csv:5: t: " + std::string(back) + " is before the row above");
			CHECK(reading.track.frames.size() == 2);
		}
	}

	TEST_CASE("a real move with a jump of 200,000 s is closed up") {
		const std::filesystem::path file = "../shared/cases/file_clock_jump.csv";
		if (!std::filesystem::exists(file)) {
			MESSAGE("skipped: no ../shared/cases here");
			return;
		}
		std::ostringstream text;
		text << std::ifstream(file, std::ios::binary).rdbuf();
		const TrackReading reading = read_track_csv(text.str(), "jump.csv");
		REQUIRE(reading.warnings.size() == 1);
		CHECK(reading.warnings.front().starts_with("jump.csv:138: t: the clock jumps by 2000"));
		CHECK(reading.track.frames.back().t_s < 10.0);
	}
}
