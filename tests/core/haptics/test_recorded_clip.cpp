#include "haptics/effect_preview.h"
#include "haptics/haptic_file.h"
#include "haptics/recorded_clip.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Largest difference of the clip's amplitude from a function of time, at each millisecond.
template <class Truth> double worst_amplitude(const HapticClip &clip, double end_s, Truth truth) {
	double worst = 0.0;
	for (double t_s = 0.0; t_s < end_s; t_s += 0.001) {
		worst = std::max(worst, std::abs(clip.amplitude_at(t_s) - truth(t_s)));
	}
	return worst;
}

Effect long_spring() {
	Effect spring = spring_effect();
	spring.trigger = Trigger::ALWAYS;
	return spring;
}

} // namespace

TEST_CASE("a recorded spring has the movement's amplitude within 0.02, and 180 Hz within 3 Hz") {
	const Movement movement{ PREVIEW_MOVEMENT_S };
	for (const double rate_hz : { 8000.0, 44100.0, 48000.0 }) {
		const HapticClip clip = recorded_clip(preview_of(long_spring(), rate_hz), rate_hz);
		const auto truth = [&](double t_s) { return movement.at(t_s).position; };
		// Within 5 ms of the end the last half wave ends.
		CHECK(worst_amplitude(clip, PREVIEW_LENGTH_S - 0.005, truth) < 0.021);
		for (double t_s = 0.2; t_s < 1.19; t_s += 0.01) {
			CHECK(std::abs(clip.playback.range.hz(clip.frequency_at(t_s)) - 180.0) < 3.0);
		}
		CHECK(clip.transients.empty());
		CHECK(clip.amplitude.size() < 30); // of 432 half waves
	}
}

TEST_CASE("export, import and rendering keep the amplitude within 0.04") {
	const HapticClip clip = recorded_clip(preview_of(long_spring(), RATE_HZ), RATE_HZ);
	const HapticClip read = parse_haptic(format_haptic(clip), "a.haptic").value();
	const HapticClip again = recorded_clip(waveform_of(read, RATE_HZ), RATE_HZ);
	const Movement movement{ PREVIEW_MOVEMENT_S };
	// Two simplifications, 0.02 each.
	CHECK(worst_amplitude(again, PREVIEW_LENGTH_S - 0.01,
				  [&](double t_s) { return movement.at(t_s).position; }) < 0.041);
}

TEST_CASE("a recorded impulse is a transient at the contact, as strong as its first swing") {
	const Movement movement{ PREVIEW_MOVEMENT_S };
	const HapticClip clip = recorded_clip(preview_of(impulse_effect(), RATE_HZ), RATE_HZ);
	REQUIRE(clip.transients.size() == 1);
	CHECK(std::abs(clip.transients[0].time_s - movement.end_s()) < 1e-4);
	const double speed_m_s = PREVIEW_AMPLITUDE_M * movement.at(movement.end_s()).velocity;
	// exp(-N t) sin(2 pi f t) is greatest where tan(2 pi f t) = 2 pi f / N.
	const double w = 2.0 * std::numbers::pi * 300.0;
	const double peak_s = std::atan(w / 200.0) / w;
	const double peak = speed_m_s * std::exp(-200.0 * peak_s) * std::sin(w * peak_s);
	CHECK(clip.transients[0].amplitude == near(peak).epsilon(0.01));
	CHECK(clip.transients[0].frequency == 1.0); // 300 Hz: beyond the range
	CHECK(worst_amplitude(clip, PREVIEW_LENGTH_S, [](double) { return 0.0; }) == 0.0);
}

TEST_CASE("a recorded sweep has the frequency of each time") {
	std::vector<float> samples(48000);
	for (std::size_t i = 0; i < samples.size(); ++i) {
		const double t_s = static_cast<double>(i) / RATE_HZ;
		samples[i] =
				static_cast<float>(0.7 * std::sin(2.0 * std::numbers::pi * (60.0 * t_s + 60.0 * t_s * t_s)));
	}
	const HapticClip clip = recorded_clip(samples, RATE_HZ);
	for (double t_s = 0.05; t_s < 0.95; t_s += 0.05) {
		CHECK(std::abs(clip.playback.range.hz(clip.frequency_at(t_s)) - (60.0 + 120.0 * t_s)) < 4.0);
		CHECK(std::abs(clip.amplitude_at(t_s) - 0.7) < 0.021);
	}
}

TEST_CASE("silence, noise that is no vibration and samples that are no numbers make a silent clip") {
	const float none = std::numeric_limits<float>::quiet_NaN();
	const float infinite = std::numeric_limits<float>::infinity();
	for (const float value : { 0.0F, 5e-4F, 0.5F, none, infinite }) {
		const HapticClip clip = recorded_clip(std::vector<float>(48000, value), RATE_HZ);
		CHECK(clip.duration_s() == near(1.0));
		CHECK(clip.transients.empty());
		CHECK(worst_amplitude(clip, 1.0, [](double) { return 0.0; }) == 0.0);
	}
	CHECK(recorded_clip({}, RATE_HZ).duration_s() == 0.0);
	CHECK(recorded_clip(std::vector<float>(8000 * 61, 0.0F), 8000.0).duration_s() == near(60.0));
}
