#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace steadyhand {

/// Disjoint sets of people, so that nothing is judged on those it was fitted to.
enum class Population : std::uint8_t { TRAIN, TUNE, EVALUATE };

[[nodiscard]] std::string_view population_name(Population population);

/// How one synthetic person moves. Deviations are from trial to trial.
struct Subject {
	std::string id;
	double tempo = 0.0;          ///< standard normal over people: slow is positive
	double pace = 1.0;           ///< times every duration: how fast the person was asked to be
	double amplitude_gain = 1.0; ///< how far the hand goes, as a share of the task's amplitude
	double amplitude_deviation = 0.0;
	double peak_fraction = 0.5; ///< when in its duration a movement is fastest
	double peak_fraction_deviation = 0.0;
	double primary_gain = 1.0; ///< share of the way that the first submovement aims to cover
	double primary_gain_deviation = 0.0;
	double corrections_mean = 0.0;  ///< submovements after the first; at most 2 are made
	double hesitation_chance = 0.0; ///< per gesture
	double bow = 0.0;               ///< sideways bend of the path at half way, as a share of the amplitude
	double bow_deviation = 0.0;
	double aim_deviation_m = 0.0; ///< sideways, at the start and at the end of a movement
	double tremor_hz = 10.0;
	double tremor_m = 0.0;      ///< standard deviation over time, per axis
	double sway_m = 0.0;        ///< slow drift of a hand held in the air, the same
	double hand_scale = 1.0;    ///< size of the hand
	double rest_before_s = 0.5; ///< at rest before a gesture, at least
	double rest_after_s = 0.8;  ///< the same after it
};

/// The person number `index` of a population; the same on every call.
[[nodiscard]] Subject draw_subject(Population population, std::uint32_t index);

} // namespace steadyhand
