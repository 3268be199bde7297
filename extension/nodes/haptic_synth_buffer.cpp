// Outputs of HapticSynth that are no device: the WAV file, and the buffer for a script.

#include "haptic_synth.h"

#include "node_label.h"
#include "sample_rates.h"

#include <godot_cpp/classes/engine.hpp>

#include <vector>

namespace godot {

namespace {

constexpr int MOST_BUFFER_FRAMES = 1 << 20;

} // namespace

void HapticSynth::set_wav_path(const String &p_path) {
	// A mistyped path must not overwrite another file.
	ERR_FAIL_COND_MSG(!p_path.is_empty() && p_path.get_extension().to_lower() != String("wav"),
			refusal(*this, "wav_path must end with .wav", p_path));
	stop_wav();
	wav_path_ = p_path;
	is_wav_pending_ = !p_path.is_empty() && !Engine::get_singleton()->is_editor_hint();
}

void HapticSynth::open_wav() {
	is_wav_pending_ = false;
	if (WrittenFile::check_free(*this, wav_path_) != OK) {
		return;
	}
	wav_ = std::make_unique<HapticWav>(wav_sample_rate_hz_);
	if (wav_->open(*this, wav_path_) == OK) {
		add_sink(*wav_);
	} else {
		wav_.reset();
	}
}

void HapticSynth::set_wav_sample_rate(int p_rate_hz) {
	ERR_FAIL_COND_MSG(
			!is_sample_rate(p_rate_hz), sample_rate_fault(node_label(*this), "wav_sample_rate", p_rate_hz));
	wav_sample_rate_hz_ = p_rate_hz;
}

void HapticSynth::stop_wav() {
	wav_.reset();
	is_wav_pending_ = false;
}

void HapticSynth::set_buffer_sample_rate(int p_rate_hz) {
	ERR_FAIL_COND_MSG(!is_sample_rate(p_rate_hz),
			sample_rate_fault(node_label(*this), "buffer_sample_rate", p_rate_hz));
	buffer_sample_rate_hz_ = p_rate_hz;
	buffer_.reset();
}

PackedVector2Array HapticSynth::get_buffer(int p_frames) {
	ERR_FAIL_COND_V_MSG(p_frames < 0 || p_frames > MOST_BUFFER_FRAMES, PackedVector2Array(),
			refusal(*this, String("get_buffer: frames must be 0..") + itos(MOST_BUFFER_FRAMES), p_frames));
	is_read_ = true;
	buffer_kept_s_ = NOT_SET;
	if (!buffer_) {
		buffer_ = std::make_unique<BufferSink>(buffer_sample_rate_hz_);
		add_sink(*buffer_);
	}
	std::vector<float> samples(2 * static_cast<std::size_t>(p_frames));
	buffer_->vibration.render(samples);
	PackedVector2Array frames;
	frames.resize(p_frames);
	Vector2 *const out = frames.ptrw();
	for (std::size_t i = 0; i < static_cast<std::size_t>(p_frames); ++i) {
		out[i] = Vector2(samples[2 * i], samples[2 * i + 1]);
	}
	return frames;
}

} // namespace godot
