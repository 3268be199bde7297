#include "base/random.h"
#include "simulation/gesture_motion.h"
#include "simulation/sensor.h"
#include "simulation/sensor_profile.h"
#include "simulation/subject.h"
#include "tracking/track_csv.h"
#include "tracking/tracker_monitor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace steadyhand;

namespace {

const std::filesystem::path SHARED = "../shared";

/// Results of the monitor for the index tip of a track.
struct Judged {
	TrackerFaults faults;
	double seconds = 0.0;
	int outliers = 0;
	double longest_gap_s = 0.0;
};

Judged judged(const Track &track) {
	Judged result;
	TrackerMonitor monitor;
	for (const HandFrame &frame : track.frames) {
		if (!frame.has(Joint::INDEX)) {
			continue;
		}
		const Measurement measurement = monitor.push(frame.t_s, frame.position(Joint::INDEX));
		result.outliers += measurement.status == MeasurementStatus::OUTLIER ? 1 : 0;
		result.longest_gap_s = std::max(result.longest_gap_s, measurement.gap_s);
	}
	result.faults = monitor.faults();
	result.seconds = track.frames.empty() ? 0.0 : track.frames.back().t_s - track.frames.front().t_s;
	return result;
}

Track read(const std::filesystem::path &file) {
	std::ostringstream text;
	text << std::ifstream(file, std::ios::binary).rdbuf();
	return parse_track_csv(text.str(), file.string()).value();
}

/// Sum over the tracks of a folder with this end of their names.
Judged judged_folder(const std::filesystem::path &folder, const std::string &ending) {
	Judged sum;
	for (const auto &entry : std::filesystem::directory_iterator(folder)) {
		if (entry.path().filename().string().ends_with(ending)) {
			const Judged one = judged(read(entry.path()));
			sum.faults.jumps += one.faults.jumps;
			sum.faults.freezes += one.faults.freezes;
			sum.seconds += one.seconds;
		}
	}
	return sum;
}

bool is_here(const std::filesystem::path &folder) {
	if (!std::filesystem::exists(folder)) {
		MESSAGE("skipped: no " << folder.string() << " here");
		return false;
	}
	return true;
}

} // namespace

TEST_CASE("recordings of real hands with steady trackers have no jump or freeze") {
	if (is_here(SHARED / "real/leap_qtm")) {
		const Judged sum = judged_folder(SHARED / "real/leap_qtm", "_leap.csv");
		CHECK(sum.seconds > 60.0);
		CHECK(sum.faults.jumps == 0);
		CHECK(sum.faults.freezes == 0);
	}
	if (is_here(SHARED / "real/drags_train")) {
		const Judged sum = judged_folder(SHARED / "real/drags_train", ".measured.csv");
		CHECK(sum.seconds > 60.0);
		// One step is 46 mm in 10 ms: the frames before it were late.
		CHECK(sum.faults.jumps <= 1);
		CHECK(sum.faults.freezes == 0);
		const Judged reference = judged_folder(SHARED / "real/drags_train", ".reference.csv");
		CHECK(reference.faults.jumps == 0);
		CHECK(reference.faults.freezes == 0);
	}
}

TEST_CASE("simulated faults in real movements are found") {
	const std::filesystem::path cases = SHARED / "cases";
	if (!is_here(cases)) {
		return;
	}
	for (const std::string hand : { "04", "29" }) {
		CAPTURE(hand);
		const auto of = [&](const char *fault) {
			return judged(read(cases / (std::string("fault_") + fault + '_' + hand + ".measured.csv")));
		};
		CHECK(of("lost100ms").faults.dropouts == 1);
		CHECK(of("lost100ms").longest_gap_s == doctest::Approx(0.11).epsilon(0.02));
		CHECK(of("frozen").faults.freezes == 1);
		CHECK(of("frozen").longest_gap_s == doctest::Approx(0.5).epsilon(0.05));
		CHECK(of("frozen").faults.jumps == 0);
		const Judged swap = of("swap");
		CHECK(swap.faults.jumps == 1);
		CHECK(swap.outliers == 6);
		CHECK(swap.longest_gap_s == doctest::Approx(0.06).epsilon(0.05));
		// FrameFilter removes these zeros. Without it they are a jump.
		CHECK(of("zero").faults.jumps == 1);
		CHECK(of("curl").outliers > 0);
		for (const char *slow : { "hz10", "burst" }) {
			CHECK(of(slow).faults.jumps == 0);
			CHECK(of(slow).faults.freezes == 0);
			CHECK(of(slow).faults.dropouts == 0);
		}
	}
}

TEST_CASE("synthetic people with trackers without faults have no jump or freeze" *
		doctest::test_suite("figures")) {
	for (const SensorProfile &of_table : sensor_profiles()) {
		CAPTURE(of_table.name);
		SensorProfile profile = of_table;
		profile.jump_per_s = profile.freeze_per_s = profile.dropout_per_s = 0.0;
		TrackerFaults sum;
		for (std::uint32_t person = 0; person < 24; ++person) {
			for (const SimulatedGesture &gesture : simulated_gestures()) {
				Random random(stream_seed(11, person));
				const Subject subject = draw_subject(Population::TUNE, person);
				const GestureTask task = draw_task(gesture, HandPosition::STABLE, random);
				const TrueMotion motion =
						make_gesture_motion(gesture, task, HandPosition::STABLE, subject, 0.0, random);
				const Judged one = judged(record_track(motion, profile, person));
				sum.jumps += one.faults.jumps;
				sum.freezes += one.faults.freezes;
			}
		}
		CHECK(sum.jumps == 0);
		CHECK(sum.freezes == 0);
	}
}
