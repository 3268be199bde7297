#include "haptics/haptic_clip.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

HapticClip ramp_clip() {
	HapticClip clip;
	clip.amplitude = { { 0.0, 0.0 }, { 0.2, 1.0 }, { 0.4, 0.0 } };
	clip.frequency = { { 0.0, 0.0 }, { 0.4, 1.0 } };
	return clip;
}

} // namespace

TEST_CASE("a clip's samples are its amplitude times a sine that sweeps from 55 to 200 Hz") {
	const HapticClip clip = ramp_clip();
	for (const double rate_hz : { 8000.0, 48000.0 }) {
		const std::vector<float> samples = waveform_of(clip, rate_hz);
		REQUIRE(samples.size() == static_cast<std::size_t>(0.4 * rate_hz) + 1);
		// The phase is the integral of 55 + 145 t / 0.4 Hz; a sum over the samples lags by half a step.
		const auto truth = [&](double t_s) {
			const double turns = 55.0 * t_s + 0.5 * (145.0 / 0.4) * t_s * (t_s - 1.0 / rate_hz);
			const double amplitude = t_s < 0.2 ? t_s / 0.2 : 2.0 - t_s / 0.2;
			const double fade = std::min((0.4 - t_s) / 0.002, 1.0);
			return fade * amplitude * std::sin(2.0 * std::numbers::pi * turns);
		};
		CHECK(largest_error(samples, rate_hz, truth) < 1e-6);
	}
}

TEST_CASE("a transient is two periods of 55 Hz dull and 165 Hz sharp, over half of what goes on") {
	HapticClip clip;
	clip.amplitude = { { 0.0, 0.4 }, { 0.5, 0.4 } };
	for (const auto &[sharpness, frequency_hz] : { std::pair{ 0.0, 55.0 }, { 0.5, 110.0 }, { 1.0, 165.0 } }) {
		CAPTURE(sharpness);
		clip.transients = { { 0.1, 0.6, sharpness } };
		const std::vector<float> samples = waveform_of(clip, RATE_HZ);
		const double end_s = 0.1 + 2.0 / frequency_hz;
		const auto truth = [&, f = frequency_hz](double t_s) {
			const double on = 0.4 * sine_at(127.5, t_s);
			const double fade = std::min((0.5 - t_s) / 0.002, 1.0);
			return t_s < 0.1 - 1e-9 || t_s >= end_s - 1e-9 ? fade * on
														   : 0.5 * on + 0.6 * sine_at(f, t_s - 0.1);
		};
		CHECK(largest_error(samples, RATE_HZ, truth) < 1e-5);
	}
}

TEST_CASE("a clip without frequencies is at the middle of the range, one of clicks ends with the last") {
	HapticClip clip;
	CHECK(clip.duration_s() == 0.0);
	CHECK(clip.frequency_at(0.3) == 0.5);
	CHECK(main_frequency_hz(clip) == near(127.5));
	clip.transients = { { 0.3, 1.0, 1.0 } };
	CHECK(clip.duration_s() == near(0.3 + 2.0 / 165.0));
	CHECK(main_frequency_hz(clip) == near(165.0));
	CHECK(waveform_of(clip, RATE_HZ).back() == doctest::Approx(0.0).epsilon(1e-3));
}

TEST_CASE("no clip leaves full scale, or makes a step that its sines do not make") {
	HapticClip clip;
	clip.amplitude = { { 0.0, 1.0 }, { 0.1, 1.0 } };
	clip.frequency = { { 0.0, 1.0 } };
	clip.transients = { { 0.02, 1.0, 1.0 }, { 0.025, 1.0, 0.0 }, { 0.09, 1.0, 1.0 } };
	const std::vector<float> samples = waveform_of(clip, RATE_HZ);
	for (const float sample : samples) {
		CHECK(std::abs(sample) <= 1.0F);
	}
	CHECK(std::abs(samples.back()) < 0.05F);
}

TEST_CASE("the vibration plays a clip from the sample of the arrival on, without allocating") {
	const HapticClip clip = ramp_clip();
	const std::vector<float> waveform = waveform_of(clip, RATE_HZ);
	Effect effect;
	effect.shape = Shape::SAMPLES;
	effect.trigger = Trigger::ARRIVAL;
	effect.drive = Drive::CONSTANT;
	effect.gain = 0.5;
	effect.fades = false;
	effect.table = { waveform.data(), static_cast<std::uint32_t>(waveform.size()) };
	Vibration vibration(RATE_HZ, 1);
	vibration.set_effects(set_of(effect));
	vibration.seek(0.0);
	MotionSnapshot snapshot = still(0.0, 0.5);
	snapshot.arrival = at(1, 1001.0 / RATE_HZ);
	vibration.set_motion(snapshot);
	const std::vector<float> out = render(vibration, 30000);
	double worst = 0.0;
	for (std::size_t i = 0; i < out.size(); ++i) {
		const bool plays = i >= 1001 && i - 1001 < waveform.size();
		const double expected = plays ? 0.5 * static_cast<double>(waveform[i - 1001]) : 0.0;
		worst = std::max(worst, std::abs(static_cast<double>(out[i]) - expected));
	}
	CHECK(worst < SAMPLE_ERROR);
}

TEST_CASE("a clip that the position drives has the amplitude and frequency of that place") {
	const float amplitudes[] = { 0.0F, 1.0F }, frequencies[] = { 60.0F, 160.0F };
	Effect effect;
	effect.shape = Shape::CURVE;
	effect.trigger = Trigger::ALWAYS;
	effect.drive = Drive::POSITION;
	effect.table = { amplitudes, 2 };
	effect.frequency_table = { frequencies, 2 };
	for (const double place : { 0.25, 0.8 }) {
		Vibration vibration(RATE_HZ, 1);
		vibration.set_effects(set_of(effect));
		vibration.seek(0.0);
		vibration.set_motion(still(0.0, place));
		const std::vector<float> out = render(vibration, 96000);
		const double frequency_hz = 60.0 + 100.0 * place;
		double sine = 0.0, cosine = 0.0;
		for (std::size_t i = 48000; i < 96000; ++i) {
			const double t_s = static_cast<double>(i) / RATE_HZ;
			sine += static_cast<double>(out[i]) * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s);
			cosine += static_cast<double>(out[i]) * std::cos(2.0 * std::numbers::pi * frequency_hz * t_s);
		}
		CHECK(std::hypot(sine, cosine) / 24000.0 == near(place).epsilon(1e-4));
		const MotionPoint motion{ place, 0.0, 0.0, 0.0 };
		CHECK(strength_of(set_of(effect), 0.0, motion, true, AMPLITUDE_M, {}).frequency_hz ==
				near(frequency_hz).epsilon(1e-6));
	}
}
