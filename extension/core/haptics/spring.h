#pragma once

#include <cstdint>
#include <span>

namespace steadyhand {

/// The paper's concurrent vibration, equation (2): s(t) = M sin(2 pi f t), M the normalised motion element.
///
/// Made in blocks on the audio thread: no allocation, no lock, no system call. Phase is a 64-bit count of
/// 2^-64 turns: after a week at 180 Hz it is off by less than 1e-6 rad at any sample rate. Largest error of
/// the sine: 4e-7.
class SpringWaveform {
public:
	static constexpr double DEFAULT_FREQUENCY_HZ = 180.0;

	explicit SpringWaveform(double sample_rate_hz, double frequency_hz = DEFAULT_FREQUENCY_HZ);

	/// Both take effect from the next sample on and leave the phase where it is, so neither makes a step.
	/// What is not above 0 and finite is ignored. A frequency above half the sample rate is lowered to that.
	void set_sample_rate(double sample_rate_hz);
	void set_frequency(double frequency_hz);

	/// The next out.size() samples. The amplitude goes in a straight line from where the last block left it
	/// (0 at first) to `amplitude`, which the next block's first sample has. Held to -1..1, full scale; NaN
	/// leaves it as it is.
	void render(std::span<float> out, double amplitude);

	[[nodiscard]] double sample_rate_hz() const { return sample_rate_hz_; }
	[[nodiscard]] double frequency_hz() const { return frequency_hz_; }
	[[nodiscard]] double amplitude() const { return amplitude_; }
	[[nodiscard]] std::uint64_t phase() const { return phase_; } ///< of the next sample, in 2^-64 turns
	[[nodiscard]] std::uint64_t phase_step() const { return phase_step_; } ///< a sample, in 2^-64 turns

private:
	void update_phase_step();

	double sample_rate_hz_ = 48000.0;
	double frequency_hz_ = DEFAULT_FREQUENCY_HZ;
	double amplitude_ = 0.0;
	std::uint64_t phase_ = 0;
	std::uint64_t phase_step_ = 0;
};

} // namespace steadyhand
