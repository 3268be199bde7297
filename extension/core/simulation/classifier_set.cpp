#include "simulation/classifier_set.h"

#include "base/random.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace steadyhand {
namespace {

constexpr double MOST_TURN_DEG = 20.0;
constexpr std::uint64_t TURN_SEED = 7, NOISE_SEED = 8;
/// White noise of other trackers: the errors of the simulated sensors are correlated between frames.
constexpr std::array NOISES_M{ 0.0, 0.0, 0.001, 0.0, 0.002 };

/// Random unit vector, uniform on the spherical cap around an axis.
Eigen::Vector3d turned(const Eigen::Vector3d &axis, double most_deg, Random &r_random) {
	const double cosine = r_random.uniform(std::cos(most_deg * std::numbers::pi / 180.0), 1.0);
	const double side = r_random.uniform(0.0, 2.0 * std::numbers::pi);
	const Eigen::Vector3d aside = axis.unitOrthogonal(), upright = axis.cross(aside);
	return cosine * axis +
			std::sqrt(1.0 - cosine * cosine) * (std::cos(side) * aside + std::sin(side) * upright);
}

void add_white_noise(Track &r_track, double deviation_m, Random &r_random) {
	for (HandFrame &frame : r_track.frames) {
		for (Eigen::Vector3d &position_m : frame.positions_m) {
			for (double &coordinate_m : position_m) {
				coordinate_m += r_random.normal(0.0, deviation_m);
			}
		}
	}
}

} // namespace

Result<std::vector<SyntheticTrial>> make_turned_trials(const SyntheticSetOptions &options) {
	std::vector<SyntheticTrial> trials;
	Random random(TURN_SEED);
	for (SyntheticTrialRequest request : plan_synthetic_set(options)) {
		Result<SyntheticTrial> made = make_synthetic_trial(request);
		if (made && made.value().trial.has_axis()) {
			const Trial &straight = made.value().trial;
			request.subject.pace = possible_pace(straight.gesture, straight.axis, request.subject.pace);
			request.place = GestureTask{ straight.start_m, turned(straight.axis, MOST_TURN_DEG, random),
				straight.amplitude_m };
			made = make_synthetic_trial(request);
		}
		if (!made) {
			return Error{ made.error() };
		}
		trials.push_back(std::move(made.value()));
	}
	return trials;
}

std::vector<ClassifierRecording> classifier_recordings(const std::vector<SyntheticTrial> &trials) {
	std::vector<ClassifierRecording> recordings;
	for (const SyntheticTrial &made : trials) {
		const Trial &trial = made.trial;
		recordings.push_back({ trial.gesture, trial.has_axis() ? "index_along_axis" : "tips_circumradius",
				{ trial.trial, { trial.start_m, trial.axis, trial.amplitude_m }, trial.start_s, trial.end_s,
						made.measured, made.reference } });
	}
	return recordings;
}

Result<ClassifierModel> train_own_classifier() {
	SyntheticSetOptions drags;
	drags.population = Population::TRAIN;
	drags.subjects = 16;
	drags.repetitions = 8;
	drags.gestures = { "horizontal_drag", "vertical_drag" };
	drags.paces = { 1.0, 0.6, 0.4, 0.25 };
	SyntheticSetOptions others = drags;
	others.gestures = { "tap", "zoom", std::string(NO_GESTURE) };
	others.paces = { 1.0, 0.6, 0.4, 1.6 };
	std::vector<SyntheticTrial> trials;
	for (const SyntheticSetOptions &options : { drags, others }) {
		Result<std::vector<SyntheticTrial>> made = make_turned_trials(options);
		if (!made) {
			return Error{ made.error() };
		}
		std::ranges::move(made.value(), std::back_inserter(trials));
	}
	Random random(NOISE_SEED);
	for (std::size_t i = 0; i < trials.size(); ++i) {
		add_white_noise(trials[i].measured, NOISES_M[i % NOISES_M.size()], random);
	}
	return train_classifier(classifier_recordings(trials));
}

} // namespace steadyhand
