// Recognition by HMM without a task, in `phase` mode. Prints docs/recognition.md:
//
//     bench_classifier [MODELS [REAL]]
//
// MODELS: folder of the models (default: models). REAL: folder of recordings (drags, lm_digits,
// leapjs_playback, leap_qtm). Without REAL only synthetic people.

#include "events/gesture_events.h"
#include "models.h"
#include "simulation/classifier_set.h"
#include "timing.h"
#include "trials.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

using Frames = std::vector<HandFrame>;

/// After the last frame. The recogniser decides what a hand did that is lost for 0.3 s.
constexpr double AFTER_S = 0.5;

struct Stream {
	std::string kind;
	int gesture = -1; ///< -1: none
	double start_s = 0.0, end_s = 0.0;
	Frames frames;

	[[nodiscard]] double length_s() const { return frames.back().t_s - frames.front().t_s; }
};

int gesture_index(std::string_view gesture) {
	const auto found = std::find(GESTURES.begin(), GESTURES.end(), gesture);
	return found == GESTURES.end() ? -1 : static_cast<int>(found - GESTURES.begin());
}

/// Streams of trials. The kind is "none" and the motion, or gesture and position.
std::vector<Stream> streams_of(const std::vector<SyntheticTrial> &trials, const std::string &prefix) {
	std::vector<Stream> streams;
	for (const auto &[trial, measured, reference] : trials) {
		const bool is_none = trial.gesture == NO_GESTURE;
		std::string kind = is_none ? "none: " : prefix + trial.gesture;
		if (trial.gesture == "tap") {
			kind += trial.axis.y() < -0.7 ? " down" : " forward";
		}
		for (const auto &[key, value] : measured.metadata) {
			kind += is_none && key == "kind" ? value : "";
		}
		kind += is_none ? "" : trial.position == HandPosition::STABLE ? ", stable" : ", unstable";
		streams.push_back(
				{ kind, gesture_index(trial.gesture), trial.start_s, trial.end_s, measured.frames });
	}
	return streams;
}

/// All track files of a folder with hands that make no gesture.
std::vector<Stream> recordings_in(const std::string &folder, const std::string &name) {
	std::vector<std::string> files;
	for (const auto &entry : std::filesystem::directory_iterator(folder + "/" + name)) {
		if (entry.path().extension() == ".csv") {
			files.push_back(entry.path().string());
		}
	}
	std::sort(files.begin(), files.end());
	std::vector<Stream> streams;
	for (const std::string &file : files) {
		const Result<Track> track = parse_track_csv(read_text(file), file);
		if (!track || track.value().frames.empty()) {
			continue; // not a track
		}
		Frames frames = track.value().frames;
		for (const UnknownColumn &column : track.value().unknown_columns) {
			for (std::size_t i = 0; column.name == "valid" && i < frames.size(); ++i) {
				frames[i].tracked = column.cells[i] == "0" ? 0 : frames[i].tracked;
			}
		}
		// A digit 1 is a straight line down of about 22 cm, from rest to rest, like a gesture.
		const bool is_line = file.find("digit1_") != std::string::npos;
		streams.push_back(
				{ "none: real " + name + (is_line ? ", digit 1" : ""), -1, 0.0, 0.0, std::move(frames) });
	}
	return streams;
}

/// Results for one kind of stream.
struct Row {
	int trials = 0, right = 0, wrong = 0, alarms = 0;
	double seconds = 0.0;
	std::vector<double> begins_s{}; ///< after the movement's start
};

/// Adds a stream. The first gesture that ends counts. For hands that make no gesture, each end is an alarm.
void add(Row &r_row, const Stream &stream, const std::vector<GestureEvent> &events) {
	++r_row.trials;
	r_row.seconds += stream.length_s();
	const auto ended = std::ranges::find(events, EventKind::ENDED, &GestureEvent::kind);
	if (stream.gesture < 0) {
		r_row.alarms += static_cast<int>(std::ranges::count(events, EventKind::ENDED, &GestureEvent::kind));
		return;
	}
	r_row.right += ended != events.end() && ended->gesture == stream.gesture ? 1 : 0;
	r_row.wrong += ended != events.end() && ended->gesture != stream.gesture ? 1 : 0;
	const auto begun = std::ranges::find_if(events, [&](const GestureEvent &one) {
		return one.kind == EventKind::STARTED && one.gesture == stream.gesture;
	});
	if (begun != events.end()) {
		r_row.begins_s.push_back(begun->t_s - stream.start_s);
	}
}

using Rows = std::map<std::string, Row>;

Rows rows_of(const std::vector<Stream> &streams, const std::vector<ExpectedGesture> &gestures) {
	Rows rows;
	for (const Stream &stream : streams) {
		add(rows[stream.kind], stream,
				follow(gestures, stream.frames, stream.frames.back().t_s + AFTER_S, 0.0, MotionMode::PHASE));
	}
	return rows;
}

void print_found(const Row &row) {
	std::printf(" %d of %d | %d |", row.right, row.trials, row.wrong);
	if (row.begins_s.empty()) {
		std::printf(" - |");
	} else {
		std::printf(" %.2f |", median(row.begins_s));
	}
}

void print_alarms(const Row &row) {
	std::printf(" %.2f |", row.alarms / (row.seconds / 60.0));
}

void print_table(const Rows &rows, bool is_none) {
	for (const auto &[kind, row] : rows) {
		if (kind.starts_with("none") == is_none) {
			std::printf("| %s |", kind.c_str());
			const auto print = is_none ? print_alarms : print_found;
			print(row);
			std::printf("\n");
		}
	}
}

const char *const HEAD = R"(# Recognition without a task

`./steadyhand bench classifier` writes this page. All four models are active, in `phase` mode, and no task is given.
[Method](method.md#recognition-by-hmm-without-a-task) describes the HMMs. `paper` mode uses the same ones.

The people are simulated people of the population `evaluate`. *real* are recorded hands (`../shared/real`), where they
are there. The first gesture that ends counts: *found* is the right one, *wrong* another one. *begins* is the median
time from the movement's start to `gesture_started`, s.

| gesture | found | wrong | begins |
| --- | --- | --- | --- |
)";

const char *const ALARMS = R"(
False alarms: gestures that end a minute, of hands that make none.

| hands | false alarms |
| --- | --- |
)";

const char *const NOTES = R"(
- A tap down and a vertical drag have the same path out. Most taps down begin as a drag, and become a tap when the hand
  comes back. At unstable positions they are found least often.
- Other motion, such as typing, often starts a gesture that is then aborted. Only ends are false alarms.
- A digit 1 is a straight line down from rest to rest, as a vertical drag. Only a start condition distinguishes them.
)";

} // namespace

int main(int count, char **arguments) {
	const std::vector<std::string> given(arguments + 1, arguments + count);
	const Models models = read_models(given.empty() ? "models" : given[0]);
	if (models.empty()) {
		return 1;
	}
	SyntheticSetOptions set;
	set.population = Population::EVALUATE;
	set.subjects = 8;
	set.repetitions = 4;
	std::vector<Stream> streams = streams_of(make_turned_trials(set).value(), "");
	if (given.size() > 1) {
		const std::string &real = given[1];
		std::ranges::move(streams_of(read_trials(real + "/drags"), "real "), std::back_inserter(streams));
		for (const char *name : { "lm_digits", "leapjs_playback", "leap_qtm" }) {
			if (std::filesystem::is_directory(real + "/" + name)) {
				std::ranges::move(recordings_in(real, name), std::back_inserter(streams));
			}
		}
	}
	std::vector<ExpectedGesture> gestures;
	for (const auto &model : models) {
		gestures.push_back({ model, std::nullopt });
	}
	const Rows rows = rows_of(streams, gestures);
	std::printf("%s", HEAD);
	print_table(rows, false);
	std::printf("%s", ALARMS);
	print_table(rows, true);
	std::printf("%s", NOTES);
	return 0;
}
