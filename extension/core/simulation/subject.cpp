#include "simulation/subject.h"

#include "base/random.h"

#include <algorithm>
#include <array>

namespace steadyhand {

std::string_view population_name(Population population) {
	constexpr std::array<std::string_view, 3> NAMES = { "train", "tune", "evaluate" };
	return NAMES[static_cast<std::size_t>(population)];
}

Subject draw_subject(Population population, std::uint32_t index) {
	Random random(stream_seed(static_cast<std::uint64_t>(population), index));
	Subject subject;
	subject.id = std::string(population_name(population)) + '_' + std::to_string(index);
	subject.tempo = std::clamp(random.normal(), -2.5, 2.5);
	subject.amplitude_gain = random.normal(1.0, 0.02);
	// The deviation of endpoints is at most a quarter of the 4 cm markers (ISO 9241-411: effective width =
	// 4.133 deviations).
	subject.amplitude_deviation = random.uniform(0.01, 0.05);
	subject.peak_fraction = random.uniform(0.37, 0.48);
	subject.peak_fraction_deviation = random.uniform(0.005, 0.02);
	subject.primary_gain = random.uniform(0.92, 1.0);
	subject.primary_gain_deviation = random.uniform(0.02, 0.06);
	subject.corrections_mean = random.uniform(0.0, 1.2);
	subject.hesitation_chance = random.uniform(0.0, 0.06);
	subject.bow = random.normal(0.0, 0.03);
	subject.bow_deviation = random.uniform(0.005, 0.02);
	subject.aim_deviation_m = random.uniform(0.001, 0.005);
	// Tremor of a fingertip: 120 to 150 um with the arm held out, a third of it with support (Growdon et al.
	// 2000).
	subject.tremor_hz = random.uniform(8.0, 12.0);
	subject.tremor_m = random.uniform(40e-6, 150e-6);
	subject.sway_m = random.uniform(0.2e-3, 0.8e-3);
	subject.hand_scale = std::clamp(random.normal(1.0, 0.06), 0.8, 1.2);
	subject.rest_before_s = random.uniform(0.5, 0.9);
	subject.rest_after_s = random.uniform(0.8, 1.2);
	return subject;
}

} // namespace steadyhand
