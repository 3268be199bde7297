// Effect of start conditions: false alarms per minute of hands that make no gesture, and detection rate of
// gestures, with and without a task.
//
//     bench_starts [MODELS [FOLDER...]]
//
// MODELS: folder of the models (default: models). FOLDER: has track CSV of hands that make no gesture.

#include "recogniser_of.h"
#include "shown_changes.h"
#include "trials.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

struct NamedStart {
	const char *name;
	StartKind kind;
};
constexpr std::array STARTS{ NamedStart{ "none", StartKind::NONE }, NamedStart{ "dwell", StartKind::DWELL },
	NamedStart{ "pinch", StartKind::PINCH }, NamedStart{ "pointing pose", StartKind::POINTING_POSE } };

/// Interval of the checks for events. Gestures last longer.
constexpr double LOOK_S = 0.004;

struct Counts {
	double minutes = 0.0;
	int begun = 0, ended = 0;
	double met_minutes = 0.0; ///< time in which the start condition was met
	bool has_joints = false;  ///< a frame has the joints of the condition
	/// Indices of the gestures that ended.
	std::vector<int> gestures = {};
};

Counts follow(const Models &models, StartKind start, const std::vector<HandFrame> &frames,
		const std::optional<Task> &task) {
	GestureRecogniser recogniser = test::recogniser_of(models, task, { .latency_s = USUAL_SENSOR_LATENCY_S });
	recogniser.set_start_condition({ .kind = start });
	Counts counts;
	if (frames.empty()) {
		return counts;
	}
	test::ShownChanges shown;
	std::size_t next = 0;
	const double first_s = frames.front().t_s, last_s = frames.back().t_s;
	for (int look = 0; first_s + LOOK_S * look <= last_s; ++look) {
		const double t_s = first_s + LOOK_S * look;
		for (; next < frames.size() && frames[next].t_s <= t_s; ++next) {
			recogniser.push(frames[next]);
			counts.has_joints |= frames[next].has_all(StartCondition::joints(start));
		}
		recogniser.advance(t_s);
		counts.met_minutes += recogniser.start_condition().is_met() ? LOOK_S / 60.0 : 0.0;
		const GestureChanges changes = shown.next(recogniser);
		counts.begun += changes.started ? 1 : 0;
		if (changes.ended) {
			++counts.ended;
			counts.gestures.push_back(recogniser.gesture());
		}
	}
	counts.minutes = (last_s - first_s) / 60.0;
	return counts;
}

using Tracks = std::vector<std::vector<HandFrame>>;

/// Tracks of all files. If one cannot be read: none, and an error on stderr.
Tracks read_tracks(const std::string &folder) {
	std::vector<std::string> paths;
	for (const auto &entry : std::filesystem::directory_iterator(folder)) {
		if (entry.path().extension() == ".csv") {
			paths.push_back(entry.path().string());
		}
	}
	std::ranges::sort(paths);
	Tracks tracks;
	for (const std::string &path : paths) {
		Result<Track> track = parse_track_csv(read_text(path), path);
		if (!track) {
			std::fprintf(stderr, "%s\n", track.error().c_str());
			return {};
		}
		tracks.push_back(std::move(track.value().frames));
	}
	return tracks;
}

std::vector<SyntheticTrial> synthetic(std::vector<std::string> gestures) {
	SyntheticSetOptions options;
	options.population = Population::TUNE;
	options.gestures = std::move(gestures);
	options.paces = { 1.0, 0.5, 2.0 };
	std::vector<SyntheticTrial> trials;
	for (const SyntheticTrialRequest &request : plan_synthetic_set(options)) {
		trials.push_back(make_synthetic_trial(request).value());
	}
	return trials;
}

void print_false_alarms(const Models &models, const std::string &name, const Tracks &tracks) {
	for (const NamedStart &start : STARTS) {
		Counts all;
		for (const std::vector<HandFrame> &frames : tracks) {
			const Counts one = follow(models, start.kind, frames, std::nullopt);
			all.minutes += one.minutes;
			all.begun += one.begun;
			all.ended += one.ended;
			all.met_minutes += one.met_minutes;
			all.has_joints |= one.has_joints;
		}
		std::printf("| %s | %s | ", name.c_str(), start.name);
		if (all.has_joints) {
			std::printf("%.2f (%d in %.1f min) | %.2f | %.0f %% |\n", all.ended / all.minutes, all.ended,
					all.minutes, all.begun / all.minutes, 100.0 * all.met_minutes / all.minutes);
		} else {
			std::printf("no joints | | |\n");
		}
		std::fflush(stdout);
	}
}

/// The frames with the thumb tip at the index tip.
std::vector<HandFrame> pinched(std::vector<HandFrame> frames) {
	for (HandFrame &frame : frames) {
		if (frame.has(Joint::INDEX) && frame.has(Joint::THUMB)) {
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - Eigen::Vector3d(0.0, 0.012, 0.0));
		}
	}
	return frames;
}

void print_recognised(const Models &models, std::size_t gesture, bool has_task) {
	const std::vector<SyntheticTrial> trials = synthetic({ GESTURES.at(gesture) });
	std::printf("| %s, %s |", GESTURES.at(gesture), has_task ? "with its task" : "without a task");
	for (const NamedStart &start : STARTS) {
		std::array<int, 2> right{}, all{};
		for (const SyntheticTrial &trial : trials) {
			const std::vector<HandFrame> &frames = trial.measured.frames;
			const Counts counts = follow(has_task ? Models{ models[gesture] } : models, start.kind,
					start.kind == StartKind::PINCH ? pinched(frames) : frames,
					has_task ? std::optional(task_of(trial)) : std::nullopt);
			const int wanted = has_task ? 0 : static_cast<int>(gesture);
			const std::size_t place = trial.trial.position == HandPosition::STABLE ? 0 : 1;
			right.at(place) += std::ranges::count(counts.gestures, wanted) > 0 ? 1 : 0;
			++all.at(place);
		}
		std::printf(" %.1f / %.1f |", 100.0 * right[0] / all[0], 100.0 * right[1] / all[1]);
		std::fflush(stdout);
	}
	std::printf("\n");
}

} // namespace

int main(int count, char **arguments) {
	const std::vector<std::string> options(arguments + 1, arguments + count);
	const Models models = read_models(options.empty() ? "models" : options.front());
	if (models.empty()) {
		return 1;
	}
	std::printf("| hands | start condition | false alarms per minute | starts per minute | condition met |\n"
				"| --- | --- | ---: | ---: | ---: |\n");
	for (std::size_t i = 1; i < options.size(); ++i) {
		const Tracks tracks = read_tracks(options[i]);
		if (tracks.empty()) {
			return 1;
		}
		print_false_alarms(models, std::filesystem::path(options[i]).filename().string(), tracks);
	}
	Tracks others;
	for (SyntheticTrial &trial : synthetic({ "none" })) {
		others.push_back(std::move(trial.measured.frames));
	}
	print_false_alarms(models, "synthetic, none", others);

	std::printf(
			"\nDetection rate, %%, stable / unstable position. Pinch: the thumb tip is at the index tip.\n\n"
			"| gesture | none | dwell | pinch | pointing pose |\n| --- | ---: | ---: | ---: | ---: |\n");
	for (std::size_t gesture = 0; gesture < GESTURES.size(); ++gesture) {
		for (const bool has_task : { false, true }) {
			print_recognised(models, gesture, has_task);
		}
	}
	return 0;
}
