#include "haptics/ahap_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steadyhand {
namespace {

/// Between two looks at a pattern: its products of straight lines bend less in between than the error.
constexpr double STEP_S = 0.002;
constexpr double CURVE_ERROR = 0.005;
/// What steps at a time has its value of before so long ahead of it.
constexpr double JUST_S = 1e-9;

using Control = AhapPattern::Control;

/// The controls' value at times that do not decrease.
class ControlReader {
public:
	ControlReader(const std::vector<Control> &controls, double before) :
			controls_(controls), value_(before) {}

	[[nodiscard]] double at(double time_s) {
		while (next_ < controls_.size() && controls_[next_].time_s <= time_s) {
			++next_;
		}
		if (next_ == 0) {
			return value_;
		}
		const Control &control = controls_[next_ - 1];
		return control.points.empty()
				? value_
				: value_at(control.points, time_s - control.time_s, control.points.front().value);
	}

private:
	const std::vector<Control> &controls_;
	double value_;
	std::size_t next_ = 0;
};

std::vector<Control> sorted(std::vector<Control> controls) {
	std::stable_sort(controls.begin(), controls.end(),
			[](const Control &one, const Control &other) { return one.time_s < other.time_s; });
	return controls;
}

/// Where the pattern may have a corner or a step, twice where it steps, and every STEP_S in between.
std::vector<double> times_of(const AhapPattern &pattern) {
	std::vector<double> corners{ 0.0 };
	for (const AhapPattern::Event &event : pattern.events) {
		if (!event.is_transient) {
			for (const double since_s :
					{ 0.0, event.attack_s, event.attack_s + event.decay_s, event.duration_s }) {
				corners.push_back(std::min(event.time_s + since_s, event.end_s()));
			}
			corners.push_back(event.end_s());
		}
	}
	const double end_s = *std::max_element(corners.begin(), corners.end());
	for (const std::vector<Control> *const controls : { &pattern.intensity, &pattern.sharpness }) {
		for (const Control &control : *controls) {
			corners.push_back(control.time_s);
			for (const Breakpoint &point : control.points) {
				corners.push_back(control.time_s + point.time_s);
			}
		}
	}
	std::sort(corners.begin(), corners.end());
	std::vector<double> times;
	for (const double corner_s : corners) {
		if (corner_s > end_s) {
			break;
		}
		while (!times.empty() && corner_s - times.back() > STEP_S + JUST_S) {
			times.push_back(times.back() + STEP_S);
		}
		if (times.empty() || corner_s > times.back() + JUST_S) {
			times.insert(times.end(), { std::max(corner_s - JUST_S, 0.0), corner_s });
		}
	}
	return times;
}

double squared(double value) {
	const double held = std::clamp(value, 0.0, 1.0);
	return held * held;
}

} // namespace

double AhapPattern::Event::end_s() const {
	return is_transient    ? time_s
			: is_sustained ? time_s + duration_s + release_s
						   : time_s + std::min(duration_s, decay_s > 0.0 ? attack_s + decay_s : duration_s);
}

double AhapPattern::Event::envelope(double since_s) const {
	if (is_transient || !(since_s >= 0.0) || time_s + since_s >= end_s()) {
		return 0.0;
	}
	const double risen = since_s < attack_s ? since_s / attack_s : 1.0;
	if (is_sustained) {
		return risen * (since_s > duration_s ? 1.0 - (since_s - duration_s) / release_s : 1.0);
	}
	const double fall_s = decay_s > 0.0 ? decay_s : duration_s - attack_s;
	return since_s < attack_s ? risen : std::max(1.0 - (since_s - attack_s) / fall_s, 0.0);
}

HapticClip AhapPattern::clip() const {
	const std::vector<double> times = times_of(*this);
	const std::vector<Control> intensities = sorted(intensity), sharpnesses = sorted(sharpness);
	ControlReader factor_reader(intensities, 1.0), summand_reader(sharpnesses, 0.0);
	std::vector<double> factors, summands;
	for (const double time_s : times) {
		factors.push_back(factor_reader.at(time_s));
		summands.push_back(summand_reader.at(time_s));
	}
	std::vector<Breakpoint> amplitudes(times.size());
	std::vector<double> weighted(times.size());
	for (const Event &event : events) {
		const auto from = std::lower_bound(times.begin(), times.end(), event.time_s) - times.begin();
		const auto to = std::upper_bound(times.begin(), times.end(), event.end_s()) - times.begin();
		for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i) {
			const double envelope = event.envelope(times[i] - event.time_s);
			const double amplitude = squared(event.intensity * envelope * factors[i]);
			amplitudes[i].value += amplitude;
			weighted[i] += amplitude * squared(event.sharpness + summands[i]);
		}
	}
	HapticClip clip;
	std::vector<Breakpoint> frequencies;
	for (std::size_t i = 0; i < times.size(); ++i) {
		amplitudes[i].time_s = times[i];
		if (amplitudes[i].value > 0.0) {
			frequencies.push_back({ times[i], weighted[i] / amplitudes[i].value });
		}
		amplitudes[i].value = std::min(amplitudes[i].value, 1.0);
	}
	clip.amplitude = simplified(amplitudes, CURVE_ERROR);
	clip.frequency = simplified(frequencies, CURVE_ERROR);
	for (const Event &event : events) {
		if (event.is_transient) {
			ControlReader factor(intensities, 1.0), summand(sharpnesses, 0.0);
			clip.transients.push_back({ event.time_s, squared(event.intensity * factor.at(event.time_s)),
					squared(event.sharpness + summand.at(event.time_s)) });
		}
	}
	std::stable_sort(clip.transients.begin(), clip.transients.end(),
			[](const Transient &one, const Transient &other) { return one.time_s < other.time_s; });
	return clip;
}

} // namespace steadyhand
