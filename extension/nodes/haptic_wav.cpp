#include "haptic_wav.h"

#include "text_file.h"

#include "haptics/wav.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr std::size_t BLOCK = 1024;

} // namespace

HapticWav::HapticWav(int p_sample_rate_hz, double p_frequency_hz) :
		sample_rate_hz_(static_cast<std::uint32_t>(p_sample_rate_hz)),
		waveform_(p_sample_rate_hz, p_frequency_hz), block_(BLOCK) {
	bytes_.resize(BUFFER_BYTES);
}

HapticWav::~HapticWav() {
	if (file_.is_valid()) {
		flush();
		file_->seek(0);
		write_header();
	}
}

Error HapticWav::open(const String &p_path) {
	path_ = p_path;
	file_ = FileAccess::open(p_path, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(file_.is_null(), FileAccess::get_open_error(),
			String("HapticSynth cannot write to ") + cannot_open(p_path, FileAccess::get_open_error()));
	write_header();
	return OK;
}

void HapticWav::write_header() {
	const auto header = steadyhand::wav_header({ .sample_rate_hz = sample_rate_hz_ }, frames_);
	for (const std::byte byte : header) {
		file_->store_8(static_cast<std::uint8_t>(byte));
	}
}

void HapticWav::advance(double p_time_s, double p_amplitude) {
	const double rate = static_cast<double>(sample_rate_hz_);
	if (!connected_) {
		began_s_ = p_time_s - static_cast<double>(frames_) / rate;
		connected_ = true;
	}
	const auto due = static_cast<std::uint64_t>(std::max(0.0, std::round((p_time_s - began_s_) * rate)));
	while (frames_ < due) {
		write_block(std::min(static_cast<std::size_t>(due - frames_), BLOCK));
	}
	amplitude_ = p_amplitude;
}

void HapticWav::write_block(std::size_t p_frames) {
	const std::span<float> samples = std::span(block_).first(p_frames);
	waveform_.render(samples, amplitude_);
	const auto size = static_cast<int64_t>(2 * p_frames);
	if (used_bytes_ + size > BUFFER_BYTES) {
		flush();
	}
	const std::span<std::uint8_t> free(bytes_.ptrw() + used_bytes_, 2 * p_frames);
	steadyhand::wav_encode(samples, steadyhand::WavSample::PCM16, std::as_writable_bytes(free));
	used_bytes_ += size;
	frames_ += p_frames;
}

void HapticWav::flush() {
	file_->store_buffer(bytes_.slice(0, used_bytes_));
	file_->flush();
	used_bytes_ = 0;
	if (file_->get_error() != OK && !complained_) {
		complained_ = true;
		ERR_PRINT(path_ + String(": writing the vibration fails; is the disk full?"));
	}
}

} // namespace godot
