#pragma once

#include "haptic_sink.h"
#include "written_file.h"

#include "haptics/vibration.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace godot {

/// The vibration as a mono 16-bit WAV, sample by sample on the motion's clock, written as it goes.
class HapticWav : public HapticSink {
public:
	explicit HapticWav(int p_sample_rate_hz);
	/// Completes the file.
	~HapticWav() override;
	HapticWav(const HapticWav &) = delete;
	HapticWav &operator=(const HapticWav &) = delete;

	/// Reports in the log why it cannot write there. p_owner outlives it.
	Error open(const Node &p_owner, const String &p_path);

	void set_effects(const steadyhand::EffectSet &p_effects) override;
	std::uint64_t oldest_generation() const override { return vibration_.oldest_generation(); }
	/// What follows continues where the file is, whatever its time.
	void start_anew() override;
	/// The file is made up to this instant at the latest when the next one of many is known.
	void advance(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion, double p_amplitude_m,
			const steadyhand::Arrival &p_arrival, const steadyhand::Arrival &p_onset) override;

private:
	static constexpr int64_t BUFFER_BYTES = 1 << 16;

	Ref<FileAccess> file_;
	String path_;
	std::optional<WrittenFile> written_;
	std::uint32_t sample_rate_hz_;
	steadyhand::Vibration vibration_;
	steadyhand::MotionSnapshot known_; ///< from what is not written yet up to the last instant
	bool is_connected_ = false;
	std::vector<float> block_;
	PackedByteArray bytes_;
	int64_t used_bytes_ = 0;
	std::uint64_t frames_ = 0;
	std::uint64_t connected_frames_ = 0; ///< those since began_s_
	double began_s_ = 0.0;

	void connect_at(double p_time_s);
	void append(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion);
	void write_known(bool p_to_the_end);
	void write_block(std::size_t p_frames);
	void write_header();
	void flush();
	void cut_off();
};

} // namespace godot
