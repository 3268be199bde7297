#include "simulation/synthetic_trial.h"

#include "base/random.h"
#include "simulation/earlier_rounds.h"
#include "simulation/gesture_motion.h"
#include "simulation/other_motion.h"
#include "simulation/sensor.h"

#include <Eigen/Geometry>

#include <string_view>
#include <utility>

namespace steadyhand {

namespace {

enum Stream : std::uint64_t { MOTION, MEASURED, REFERENCE };

template <class Row>
Error unknown_name(std::string_view what, std::string_view name, std::span<const Row> table,
		std::string_view one_more = {}) {
	std::string message = "no synthetic " + std::string(what) + " '" + std::string(name) + "', there are:";
	for (const Row &row : table) {
		message += ' ' + std::string(row.name);
	}
	message += one_more;
	return Error{ std::move(message) };
}

/// FNV-1a hash. It is equal on every platform, unlike std::hash.
std::uint64_t text_bits(std::string_view text) {
	std::uint64_t bits = 0xCBF29CE484222325U;
	for (const char character : text) {
		bits = (bits ^ static_cast<unsigned char>(character)) * 0x100000001B3U;
	}
	return bits;
}

/// Turns and shifts a track from the task `from` to the task `to`.
void move_track(Track &r_track, const GestureTask &from, const GestureTask &to) {
	const Eigen::Quaterniond turn = from.axis.isZero(0.0) || to.axis.isZero(0.0)
			? Eigen::Quaterniond::Identity()
			: Eigen::Quaterniond::FromTwoVectors(from.axis, to.axis);
	for (HandFrame &frame : r_track.frames) {
		for (Eigen::Vector3d &position_m : frame.positions_m) {
			position_m = to.start_m + turn * (position_m - from.start_m);
		}
	}
}

} // namespace

Result<SyntheticTrial> make_synthetic_trial(const SyntheticTrialRequest &request) {
	const std::string_view default_sensor =
			request.position == HandPosition::STABLE ? "leap_stable" : "leap_unstable";
	const std::string_view sensor_name =
			request.sensor.empty() ? default_sensor : std::string_view(request.sensor);
	const SensorProfile *const sensor = find_sensor_profile(sensor_name);
	if (sensor == nullptr) {
		return unknown_name("sensor", sensor_name, sensor_profiles());
	}

	SyntheticTrial made;
	made.trial = { .trial = request.name,
		.gesture = request.gesture,
		.position = request.position,
		.subject = request.subject.id };
	Random random(stream_seed(request.seed, MOTION));
	TrueMotion motion;
	GestureTask task;
	std::string_view kind_name;
	if (request.gesture == "none") {
		const OtherMotion &any_kind = other_motions()[random.index(other_motions().size())];
		const OtherMotion *const kind = request.kind.empty() ? &any_kind : find_other_motion(request.kind);
		if (kind == nullptr) {
			return unknown_name("kind of other motion", request.kind, other_motions());
		}
		kind_name = kind->name;
		motion = make_other_motion(*kind, request.position, request.subject, request.duration_s, random);
	} else {
		const SimulatedGesture *const gesture = find_simulated_gesture(request.gesture);
		if (gesture == nullptr) {
			return unknown_name("gesture", request.gesture, simulated_gestures(), " none");
		}
		task = draw_task(*gesture, request.position, random);
		Subject subject = request.subject;
		if (!request.place) {
			subject.pace = possible_pace(request.gesture, task.axis, subject.pace);
		} else {
			task.amplitude_m = request.place->amplitude_m;
			task.radius_m = task.axis.isZero(0.0) ? request.place->radius_m : task.radius_m;
		}
		motion = after_earlier_rounds(
				make_gesture_motion(*gesture, task, request.position, subject, request.duration_s, random),
				request.earlier_rounds);
		const GestureTask &seen = request.place ? *request.place : task;
		made.trial.start_m = task.axis.isZero(0.0) ? Eigen::Vector3d(task.radius_m, 0.0, 0.0) : seen.start_m;
		made.trial.axis = task.axis.isZero(0.0) ? task.axis : seen.axis;
		made.trial.amplitude_m = task.amplitude_m;
	}
	made.trial.start_s = motion.start_s;
	made.trial.end_s = motion.end_s;
	made.measured = record_track(motion, *sensor, stream_seed(request.seed, MEASURED));
	made.reference =
			record_track(motion, *find_sensor_profile("liberty"), stream_seed(request.seed, REFERENCE));
	for (Track *track : { &made.measured, &made.reference }) {
		if (request.place && request.gesture != "none") {
			move_track(*track, task, *request.place);
		}
		track->metadata.insert(track->metadata.begin(),
				{ { "origin", "synthetic" }, { "subject", request.subject.id },
						{ "seed", std::to_string(request.seed) } });
		if (!kind_name.empty()) {
			track->metadata.emplace_back("kind", kind_name);
		}
	}
	return made;
}

std::vector<SyntheticTrialRequest> plan_synthetic_set(const SyntheticSetOptions &options) {
	std::vector<std::string> gestures = options.gestures;
	if (gestures.empty()) {
		for (const SimulatedGesture &gesture : simulated_gestures()) {
			if (!gesture.is_example) {
				gestures.emplace_back(gesture.name);
			}
		}
		gestures.emplace_back("none");
	}
	std::vector<SyntheticTrialRequest> requests;
	for (std::uint32_t person = 0; person < options.subjects; ++person) {
		const Subject subject = draw_subject(options.population, person);
		for (const std::string &gesture : gestures) {
			for (const HandPosition position : options.positions) {
				for (std::uint32_t repetition = 0; repetition < options.repetitions; ++repetition) {
					SyntheticTrialRequest request;
					request.name = subject.id + '_' + gesture + '_' + std::string(position_name(position)) +
							'_' + std::to_string(repetition);
					request.gesture = gesture;
					request.position = position;
					request.subject = subject;
					request.subject.pace = options.paces[repetition % options.paces.size()];
					request.seed = text_bits(request.name);
					request.duration_s = options.duration_s;
					request.earlier_rounds = options.earlier_rounds;
					requests.push_back(std::move(request));
				}
			}
		}
	}
	return requests;
}

} // namespace steadyhand
