#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace steadyhand {

/// Disjoint sets of people: training, tuning and evaluation need different ones.
enum class Population : std::uint8_t { TRAIN, TUNE, EVALUATE };

[[nodiscard]] std::string_view population_name(Population population);

/// Parameters of one synthetic person. A "deviation" is a standard deviation from trial to trial.
struct Subject {
	std::string id;
	double tempo = 0.0;          ///< standard normal over people; positive: slow
	double pace = 1.0;           ///< factor of all durations, by instruction
	double amplitude_gain = 1.0; ///< length of the movement, in amplitudes of the task
	double amplitude_deviation = 0.0;
	double peak_fraction = 0.5; ///< time of the peak speed, as a fraction of the duration
	double peak_fraction_deviation = 0.0;
	double primary_gain = 1.0; ///< length of the first submovement, as a fraction of the movement
	double primary_gain_deviation = 0.0;
	double corrections_mean = 0.0;  ///< mean number of further submovements, of which there are at most 2
	double hesitation_chance = 0.0; ///< per gesture
	double bow = 0.0;               ///< offset of the path at its middle, in amplitudes
	double bow_deviation = 0.0;
	double aim_deviation_m = 0.0; ///< across the axis, at the start and at the end of a movement
	double tremor_hz = 10.0;
	double tremor_m = 0.0;      ///< standard deviation over time, per axis
	double sway_m = 0.0;        ///< slow drift of a hand in the air, standard deviation per axis
	double hand_scale = 1.0;    ///< size of the hand, relative to the average
	double rest_before_s = 0.5; ///< least rest before a gesture
	double rest_after_s = 0.8;  ///< least rest after it
};

/// Person number `index` of a population; the same one on every call.
[[nodiscard]] Subject draw_subject(Population population, std::uint32_t index);

} // namespace steadyhand
