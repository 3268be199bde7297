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

/// Writes the vibration to a mono 16-bit WAV while it is made, on the motion's clock.
class HapticWav : public HapticSink {
public:
	explicit HapticWav(int p_sample_rate_hz);
	/// Completes the file.
	~HapticWav() override;
	HapticWav(const HapticWav &) = delete;
	HapticWav &operator=(const HapticWav &) = delete;

	/// If the file cannot be opened, the log gets an error. p_owner must outlive this object.
	Error open(const Node &p_owner, const String &p_path);

	void set_effects(const steadyhand::EffectSet &p_effects) override;
	std::uint64_t oldest_generation() const override { return vibration_.oldest_generation(); }
	/// The next motion continues at the end of the file, whatever its time.
	void restart() override;
	/// Samples up to this instant may be written later, with further instants.
	void advance(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion, double p_amplitude_m,
			const steadyhand::Arrival &p_arrival, const steadyhand::Arrival &p_onset) override;

private:
	static constexpr int64_t BUFFER_BYTES = 1 << 16;

	Ref<FileAccess> file_;
	String path_;
	std::optional<WrittenFile> written_;
	std::uint32_t sample_rate_hz_;
	steadyhand::Vibration vibration_;
	steadyhand::MotionSnapshot pending_; ///< motion from the last written sample to the last instant
	bool is_connected_ = false;
	std::vector<float> block_;
	PackedByteArray bytes_;
	int64_t used_bytes_ = 0;
	std::uint64_t frames_ = 0;
	std::uint64_t connected_frames_ = 0; ///< since began_s_
	double began_s_ = 0.0;

	void connect_at(double p_time_s);
	void append(double p_time_s, const steadyhand::MotionSnapshot::Knot &p_motion);
	void write_pending(bool p_to_the_end);
	void write_block(std::size_t p_frames);
	void write_header();
	void flush();
	void cut_off();
};

} // namespace godot
