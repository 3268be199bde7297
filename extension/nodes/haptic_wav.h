#pragma once

#include "haptics/spring.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// The vibration as a mono 16-bit WAV, sample by sample on the motion's clock, written as it goes.
class HapticWav {
public:
	HapticWav(int p_sample_rate_hz, double p_frequency_hz);
	/// Completes the header.
	~HapticWav();
	HapticWav(const HapticWav &) = delete;
	HapticWav &operator=(const HapticWav &) = delete;

	/// Reports in the log why it cannot write there.
	Error open(const String &p_path);
	void set_frequency(double p_frequency_hz) { waveform_.set_frequency(p_frequency_hz); }

	/// What follows continues where the file is, whatever its time.
	void start_anew() { connected_ = false; }
	/// The amplitude (0..1) from p_time_s on. Fills the file up to that time with what was known before.
	void advance(double p_time_s, double p_amplitude);

private:
	static constexpr int64_t BUFFER_BYTES = 1 << 16;

	Ref<FileAccess> file_;
	String path_;
	std::uint32_t sample_rate_hz_;
	steadyhand::SpringWaveform waveform_;
	std::vector<float> block_;
	PackedByteArray bytes_;
	int64_t used_bytes_ = 0;
	std::uint64_t frames_ = 0;
	double began_s_ = 0.0; ///< instant of the sample number 0
	bool connected_ = false;
	double amplitude_ = 0.0;
	bool complained_ = false;

	void write_header();
	void write_block(std::size_t p_frames);
	void flush();
};

} // namespace godot
