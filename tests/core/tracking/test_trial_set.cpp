#include "tracking/trial_set.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

using namespace steadyhand;

namespace {

const std::string HEADER =
		"trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_z,axis_x,axis_y,axis_z,"
		"amplitude_m\n";

std::string error_of(const std::string &rows) {
	const Result<TrialTable> table = parse_trials_csv(HEADER + rows, "trials.csv");
	REQUIRE_MESSAGE(table.ok(), table.error());
	return table.value().faults.empty() ? "no error" : table.value().faults.front();
}

std::vector<Trial> parsed(const std::string &text) {
	Result<TrialTable> table = parse_trials_csv(text, "trials.csv");
	REQUIRE_MESSAGE(table.ok(), table.error());
	CHECK(table.value().faults.empty());
	return std::move(table).value().trials;
}

} // namespace

TEST_SUITE("trial set") {
	TEST_CASE("a drag fills all cells, zoom radius and growth, none nothing") {
		const std::vector<Trial> trials = parsed(HEADER +
				"d1,horizontal_drag,unstable,s1,0.5,1.75,0.1,0.2,-0.3,-1,0,0,0.2\n"
				"z1,zoom,stable,s2,0.5,1.5,0.015,,,,,,0.03\n"
				"n1,none,stable,s2,0,4,,,,,,,\n"
				"n2,none,stable,s2,,,,,,,,,\n");
		REQUIRE(trials.size() == 4);
		CHECK(trials[0].trial == "d1");
		CHECK(trials[0].gesture == "horizontal_drag");
		CHECK(trials[0].position == HandPosition::UNSTABLE);
		CHECK(trials[0].subject == "s1");
		CHECK(trials[0].start_s == 0.5);
		CHECK(trials[0].end_s == 1.75);
		CHECK(trials[0].start_m == Eigen::Vector3d(0.1, 0.2, -0.3));
		CHECK(trials[0].axis == Eigen::Vector3d(-1, 0, 0));
		CHECK(trials[0].amplitude_m == 0.2);
		CHECK(trials[0].has_axis());
		CHECK(trials[1].start_m == Eigen::Vector3d(0.015, 0, 0));
		CHECK_FALSE(trials[1].has_axis());
		CHECK(trials[1].amplitude_m == 0.03);
		CHECK_FALSE(trials[2].has_axis());
		CHECK(trials[2].amplitude_m == 0.0);
		CHECK(trials[2].end_s == 4.0);
		CHECK(trials[3].end_s == 0.0);
	}

	TEST_CASE("a gesture of any name is described by its filled cells") {
		const std::vector<Trial> trials = parsed(HEADER +
				"c1,circle,stable,s1,0,1,0,0,0,0,0,1,0.1\n"
				"c2,squeeze,stable,s1,0,1,0.03,,,,,,0.02\n"
				"c3,wave,stable,s1,0,1,,,,,,,\n");
		CHECK(trials[0].has_axis());
		CHECK(trials[1].start_m.x() == 0.03);
		CHECK(trials[2].amplitude_m == 0.0);
	}

	TEST_CASE("columns may have any order; unknown columns are ignored") {
		const std::vector<Trial> trials =
				parsed("note,amplitude_m,trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_"
					   "z,axis_x,"
					   "axis_y,axis_z\r\nhello,0.15,t1,tap,stable,s,0,1,1,2,3,0,0,-1\r\n\r\n");
		REQUIRE(trials.size() == 1);
		CHECK(trials[0].amplitude_m == 0.15);
		CHECK(trials[0].start_m == Eigen::Vector3d(1, 2, 3));
		CHECK(trials[0].axis == Eigen::Vector3d(0, 0, -1));
	}

	TEST_CASE("quoted cells are read, and keep their commas") {
		std::string header = HEADER;
		for (std::size_t i = header.find(','); i != std::string::npos; i = header.find(',', i + 3)) {
			header.replace(i, 1, "\",\"");
		}
		const std::vector<Trial> trials = parsed("\"" + header.substr(0, header.size() - 1) + "\"\n" +
				"\"t1\",\"tap\",\"stable\",\"Doe, J\",0,1.5,\"1\",2,3,0,0,-1,0.15\n");
		REQUIRE(trials.size() == 1);
		CHECK(trials[0].gesture == "tap");
		CHECK(trials[0].subject == "Doe, J");
		CHECK(format_trials_csv(trials) == HEADER + "t1,tap,stable,\"Doe, J\",0,1.5,1,2,3,0,0,-1,0.15\n");
	}

	TEST_CASE("any set reads back to the last bit") {
		std::mt19937_64 engine(5);
		std::uniform_real_distribution<double> uniform(-1.0, 1.0);
		std::vector<Trial> trials;
		for (int i = 0; i < 200; ++i) {
			Trial trial;
			trial.trial = "trial " + std::to_string(i) + "_ä";
			trial.gesture = std::array{ "horizontal_drag", "tap", "zoom", "none" }[i % 4];
			trial.position = i % 3 == 0 ? HandPosition::UNSTABLE : HandPosition::STABLE;
			trial.subject = std::array{ "s1", "s2", "s3" }[i % 3];
			trial.start_s = uniform(engine);
			trial.end_s = trial.start_s + uniform(engine) + 1.0;
			if (i % 4 < 2) {
				trial.start_m = { uniform(engine), uniform(engine), uniform(engine) };
				trial.axis =
						Eigen::Vector3d{ uniform(engine), uniform(engine), uniform(engine) }.normalized();
			} else if (i % 4 == 2) {
				trial.start_m.x() = 1.0 + uniform(engine);
			}
			trial.amplitude_m = i % 4 == 3 ? 0.0 : 1.5 + uniform(engine);
			trials.push_back(trial);
		}
		const std::vector<Trial> again = parsed(format_trials_csv(trials));
		REQUIRE(again.size() == trials.size());
		for (std::size_t i = 0; i < trials.size(); ++i) {
			CHECK(again[i].trial == trials[i].trial);
			CHECK(again[i].gesture == trials[i].gesture);
			CHECK(again[i].position == trials[i].position);
			CHECK(again[i].subject == trials[i].subject);
			CHECK(again[i].start_s == trials[i].start_s);
			CHECK(again[i].end_s == trials[i].end_s);
			CHECK(again[i].start_m == trials[i].start_m);
			CHECK(again[i].axis == trials[i].axis);
			CHECK(again[i].amplitude_m == trials[i].amplitude_m);
		}
	}

	TEST_CASE("bad rows give one error with file, line and column") {
		const std::string task = "0,1,1,2,3,0,0,-1,0.15\n";
		CHECK(error_of("t1,tap,stable,s," + task) == "no error");
		CHECK(error_of("../t1,tap,stable,s," + task) ==
				"trials.csv:2: trial: '../t1' has a character that no file name may have");
		CHECK(error_of("..,tap,stable,s," + task) ==
				"trials.csv:2: trial: '..' starts or ends with a dot or space, which no file name may");
		CHECK(error_of("a\\b,tap,stable,s," + task) ==
				"trials.csv:2: trial: 'a\\b' has a character that no file name may have");
		CHECK(error_of(",tap,stable,s," + task) == "trials.csv:2: trial: '' is empty");
		const std::string too_long(201, 'n');
		CHECK(error_of(too_long + ",tap,stable,s," + task) ==
				"trials.csv:2: trial: '" + std::string(40, 'n') + "...' is too long for a file name");
		CHECK(error_of("t1,tap,stable,s," + task + "t1,tap,stable,s," + task) ==
				"trials.csv:3: trial: 't1' comes twice");
		CHECK(error_of("t1,,stable,s," + task) == "trials.csv:2: gesture: '' is empty");
		CHECK(error_of("t1,zoom/in,stable,s," + task) ==
				"trials.csv:2: gesture: 'zoom/in' has a character that no file name may have");
		CHECK(error_of("t1,tap,shaky,s," + task) ==
				"trials.csv:2: position: 'shaky' is neither stable nor unstable");
		CHECK(error_of("t1,tap,stable,s,,1,1,2,3,0,0,-1,0.15\n") == "trials.csv:2: start_s: empty");
		CHECK(error_of("t1,tap,stable,s,2,1,1,2,3,0,0,-1,0.15\n") ==
				"trials.csv:2: end_s: 1 is not after start_s 2");
		CHECK(error_of("t1,tap,stable,s,1,1,1,2,3,0,0,-1,0.15\n") ==
				"trials.csv:2: end_s: 1 is not after start_s 1");
		CHECK(error_of("t1,tap,stable,s,0,inf,1,2,3,0,0,-1,0.15\n") ==
				"trials.csv:2: end_s: 'inf' is not finite");
		CHECK(error_of("t1,tap,stable,s,0,1,1,,3,0,0,-1,0.15\n") == "trials.csv:2: start_y: empty");
		CHECK(error_of("t1,tap,stable,s,0,1,1,2,3,0,0,-2,0.15\n") ==
				"trials.csv:2: axis_x: the axis is no unit vector, its length is 2");
		CHECK(error_of("t1,tap,stable,s,0,1,1,2,3,0,0,-1,0\n") ==
				"trials.csv:2: amplitude_m: '0' is not positive");
		CHECK(error_of("z1,zoom,stable,s,0,1,0.01,0,0,,,,0.03\n") ==
				"trials.csv:2: start_y: '0' where zoom has none");
		CHECK(error_of("z1,zoom,stable,s,0,1,-0.01,,,,,,0.03\n") ==
				"trials.csv:2: start_x: '-0.01' is no radius");
		CHECK(error_of("n1,none,stable,s,0,1,,,,,,,0.2\n") ==
				"trials.csv:2: amplitude_m: '0.2' where none has none");
		CHECK(error_of("t1,tap,stable\n") == "trials.csv:2: subject: the row ends after 3 cells of 13");
		CHECK(parse_trials_csv("trial,gesture\n", "x").error() ==
				"x:1: position: the header has no such column");
		CHECK(parse_trials_csv("", "x").error() == "x:1: trial: no header line");
	}

	TEST_CASE("a bad row does not invalidate other rows") {
		const Result<TrialTable> table = parse_trials_csv(HEADER +
						"t1,tap,stable,s,0,1,1,2,3,0,0,-1,0.15\n"
						"t2,tap,stable,s,0,1,1,2,3,0,0,-1,-0.15\n"
						"t3,tap,stable,s,0,1,1,2,3,0,0,-1,0.15\n"
						"t4,tap,sta",
				"trials.csv");
		REQUIRE(table.ok());
		REQUIRE(table.value().trials.size() == 2);
		CHECK(table.value().trials[1].trial == "t3");
		CHECK(table.value().faults ==
				std::vector<std::string>{ "trials.csv:3: amplitude_m: '-0.15' is not positive",
						"trials.csv:5: subject: the row ends after 3 cells of 13" });
	}

	TEST_CASE("a rounded axis is normalised") {
		const std::vector<Trial> trials = parsed(HEADER +
				"t1,tap,stable,s,0,1,1,2,3,0.94,0,-0.34,0.15\n"
				"t2,tap,stable,s,0,1,1,2,3,0.93969,0,-0.34202,0.15\n"
				"t3,tap,stable,s,0,1,1,2,3,0.57,0.57,0.57,0.15\n");
		REQUIRE(trials.size() == 3);
		CHECK((trials[0].axis - Eigen::Vector3d(0.94, 0, -0.34).normalized()).norm() < 1e-15);
		CHECK(trials[1].axis == Eigen::Vector3d(0.93969, 0, -0.34202));
		CHECK(std::abs(trials[2].axis.norm() - 1.0) < 1e-15);
	}

	TEST_CASE("a trial's name may begin with #; comments precede the header only") {
		const std::vector<Trial> trials =
				parsed("# made by hand\n" + HEADER + "#1,tap,stable,s,0,1,1,2,3,0,0,-1,0.15\n");
		REQUIRE(trials.size() == 1);
		CHECK(trials[0].trial == "#1");
	}

	TEST_CASE("real trial sets are read, with each trial's tracks") {
		for (const std::filesystem::path folder : { "../shared/real/drags", "../shared/real/drags_train" }) {
			if (!std::filesystem::exists(folder)) {
				MESSAGE("skipped: no " << folder.string() << " here");
				continue;
			}
			std::ostringstream text;
			text << std::ifstream(folder / "trials.csv", std::ios::binary).rdbuf();
			const std::vector<Trial> trials = parsed(text.str());
			CHECK(trials.size() > 10);
			for (const Trial &trial : trials) {
				CHECK(trial.has_axis());
				CHECK(std::filesystem::exists(folder / (trial.trial + ".measured.csv")));
				CHECK(std::filesystem::exists(folder / (trial.trial + ".reference.csv")));
			}
		}
	}
}
