#include "haptic_wav.h"

#include "node_label.h"
#include "text_file.h"

#include "haptics/wav.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr std::size_t BLOCK = 1024;
/// Relative tolerance of the period between instants.
constexpr double SAME_PERIOD = 1e-3;

} // namespace

HapticWav::HapticWav(int p_sample_rate_hz) :
		sample_rate_hz_(static_cast<std::uint32_t>(p_sample_rate_hz)), vibration_(p_sample_rate_hz, 1),
		block_(BLOCK) {
	bytes_.resize(BUFFER_BYTES);
}

HapticWav::~HapticWav() {
	if (file_.is_valid()) {
		write_pending(true);
		flush();
	}
}

Error HapticWav::open(const Node &p_owner, const String &p_path) {
	path_ = p_path;
	file_ = FileAccess::open(p_path, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(file_.is_null(), FileAccess::get_open_error(),
			node_label(p_owner) + String(": cannot write to ") +
					cannot_open(p_path, FileAccess::get_open_error()));
	written_.emplace(p_owner, p_path);
	write_header();
	return OK;
}

void HapticWav::write_header() {
	const auto header = steadyhand::wav_header({ .sample_rate_hz = sample_rate_hz_ }, frames_);
	for (const std::byte byte : header) {
		file_->store_8(static_cast<std::uint8_t>(byte));
	}
}

void HapticWav::set_effects(const steadyhand::EffectSet &p_effects) {
	write_pending(false);
	vibration_.set_effects(p_effects);
}

void HapticWav::restart() {
	write_pending(true);
	is_connected_ = false;
}

void HapticWav::connect_at(double p_time_s) {
	is_connected_ = true;
	pending_.count = 0;
	began_s_ = p_time_s;
	connected_frames_ = 0;
	// Samples that are already rendered come first.
	vibration_.seek(p_time_s + static_cast<double>(vibration_.ahead()) / vibration_.sample_rate_hz());
}

void HapticWav::advance(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion,
		double p_amplitude_m, const steadyhand::Arrival &p_arrival, const steadyhand::Arrival &p_onset) {
	if (!is_connected_) {
		connect_at(p_time_s);
	} else if (!(p_time_s > pending_.end_s())) {
		return;
	}
	const bool has_changed = p_arrival.number != pending_.arrival.number ||
			p_onset.number != pending_.onset.number || p_amplitude_m != pending_.amplitude_m;
	if (pending_.count == steadyhand::MotionSnapshot::MOST_KNOTS || has_changed) {
		write_pending(false);
	}
	append(p_time_s, p_motion);
	pending_.amplitude_m = p_amplitude_m;
	pending_.arrival = p_arrival;
	pending_.onset = p_onset;
}

void HapticWav::append(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion) {
	if (pending_.count > 1 &&
			std::abs(p_time_s - pending_.end_s() - pending_.period_s) > SAME_PERIOD * pending_.period_s) {
		write_pending(true);
		const double last_s = pending_.end_s();
		pending_.knots[0] = pending_.knots[pending_.count - 1];
		pending_.time_s = last_s;
		pending_.count = 1;
	}
	if (pending_.count == 0) {
		pending_.time_s = p_time_s;
	} else if (pending_.count == 1) {
		pending_.period_s = p_time_s - pending_.time_s;
	}
	pending_.knots[pending_.count++] = p_motion;
}

/// Writes whole runs up to the last instant, or with p_to_the_end all samples.
void HapticWav::write_pending(bool p_to_the_end) {
	if (!is_connected_ || pending_.count < 2) {
		return;
	}
	vibration_.set_motion(pending_);
	const double rate_hz = vibration_.sample_rate_hz();
	const auto due =
			static_cast<std::uint64_t>(std::max(0.0, std::round((pending_.end_s() - began_s_) * rate_hz)));
	const std::uint64_t made = connected_frames_ + vibration_.ahead();
	const std::uint64_t runs = due > made ? (due - made) / steadyhand::RUN : 0;
	const std::uint64_t until = p_to_the_end ? due : made + runs * steadyhand::RUN;
	while (connected_frames_ < until) {
		write_block(std::min(static_cast<std::size_t>(until - connected_frames_), BLOCK));
	}
	const double passed = std::floor((vibration_.time_s() - pending_.time_s) / pending_.period_s);
	const auto dropped = std::min(static_cast<std::size_t>(std::max(passed, 0.0)), pending_.count - 2);
	std::copy(pending_.knots.begin() + static_cast<std::ptrdiff_t>(dropped),
			pending_.knots.begin() + static_cast<std::ptrdiff_t>(pending_.count), pending_.knots.begin());
	pending_.time_s += pending_.period_s * static_cast<double>(dropped);
	pending_.count -= dropped;
}

void HapticWav::write_block(std::size_t p_frames) {
	const std::span<float> samples = std::span(block_).first(p_frames);
	vibration_.render(samples);
	const auto size = static_cast<int64_t>(2 * p_frames);
	if (used_bytes_ + size > BUFFER_BYTES) {
		flush();
	}
	const std::span<std::uint8_t> free(bytes_.ptrw() + used_bytes_, 2 * p_frames);
	steadyhand::wav_encode(samples, std::as_writable_bytes(free));
	used_bytes_ += size;
	frames_ += p_frames;
	connected_frames_ += p_frames;
}

/// Ends the file if the disk is full, with a header of the right length. Later samples would be at a wrong
/// time.
void HapticWav::cut_off() {
	file_.unref(); // this drops the engine's buffer
	file_ = FileAccess::open(path_, FileAccess::READ_WRITE);
	if (file_.is_valid()) {
		const uint64_t bytes = file_->get_length();
		frames_ = bytes > steadyhand::WAV_HEADER_BYTES ? (bytes - steadyhand::WAV_HEADER_BYTES) / 2 : 0;
		write_header();
		file_.unref();
	}
	ERR_PRINT(path_ + String(": the vibration cannot be written, and the file ends here. Is the disk full?"));
}

void HapticWav::flush() {
	if (file_.is_null()) {
		used_bytes_ = 0;
		return;
	}
	file_->store_buffer(bytes_.slice(0, used_bytes_));
	used_bytes_ = 0;
	if (!is_written(file_)) {
		cut_off();
		return;
	}
	// The header is always current, in case the program is killed.
	file_->seek(0);
	write_header();
	file_->seek_end();
	file_->flush();
}

} // namespace godot
