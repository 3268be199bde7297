#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace steadyhand {

/// The binary protocol of the Polhemus Liberty (manual URM03PH156 Rev. H). Bytes in, messages out: no I/O.

/// The tracker has 16 stations at most; each is a socket for one sensor, counted from 1.
inline constexpr int LIBERTY_STATION_COUNT = 16;

/// Fields of a record, in this order: time stamp, frame count, distortion level, position and quaternion.
inline constexpr std::string_view LIBERTY_OUTPUT_LIST = "O*,8,9,11,3,7";
/// Its size in bytes: 4 + 4 + 4 + 12 + 16.
inline constexpr std::size_t LIBERTY_RECORD_SIZE = 40;

/// One pose of one sensor.
struct LibertyRecord {
	int station = 0;                  ///< 1..16
	char command = 'C';               ///< 'C': streamed; 'P': requested
	std::uint32_t frame_count = 0;    ///< of the measuring cycle; all stations of a cycle have the same
	std::uint32_t device_time_ms = 0; ///< time of the cycle on the tracker's own clock
	std::int32_t distortion = 0;      ///< 0 none, 1 some, 2 strong: metal is near
	char fault = '\0';                ///< a letter of liberty_error_text(); 0: none
	bool is_tracked = false;          ///< the pose is finite, within reach and not all zeros
	Eigen::Vector3d source_position_m = Eigen::Vector3d::Zero(); ///< source frame: x forward, y right, z down
	Eigen::Vector3d position_m = Eigen::Vector3d::Zero();        ///< Godot's axes: x right, y up, -z forward
	Eigen::Quaterniond rotation =
			Eigen::Quaterniond::Identity(); ///< of the sensor, in Godot's axes; of unit length if tracked
};

/// One answer of the tracker.
struct LibertyMessage {
	enum class Kind : std::uint8_t {
		RECORD,       ///< `record`
		WRONG_RECORD, ///< a record of `body_size` bytes, which is not LIBERTY_RECORD_SIZE
		REFUSAL,      ///< the tracker refused `command` with `code`; `text` is its own message
		STATION_MAP,  ///< `stations`, the answer to ^U0
		TEXT          ///< `text` without a header; sent in ASCII mode
	};
	Kind kind = Kind::TEXT;
	LibertyRecord record;
	char command = '\0';
	std::uint8_t code = 0;
	std::size_t body_size = 0;
	std::uint32_t stations = 0; ///< bit i set: a sensor is plugged into station i + 1, and it is switched on
	std::string_view text;      ///< valid until the next LibertyParser::feed()
};

/// What error byte `code` means: 1 to 24, or a letter that comes with a record.
[[nodiscard]] std::string_view liberty_error_text(std::uint8_t code);

/// Whether a record with error byte `code` has a pose: letters 'a' to 'g', 'A' to 'G', 'I' and 'u'.
[[nodiscard]] bool is_liberty_record_fault(std::uint8_t code);

/// A refusal, a wrong record or a text as one sentence for the user, with what to do. Empty for other kinds.
[[nodiscard]] std::string liberty_message_text(const LibertyMessage &message);

/// Reads messages from the bytes of USB transfers, which may be cut anywhere. Skips bytes that belong to no
/// message, until the next header. Does not allocate.
class LibertyParser {
public:
	/// Adds received bytes. Call next() until it returns false before the next feed(): of more than CAPACITY
	/// unread bytes, the oldest are skipped.
	void feed(std::span<const std::uint8_t> bytes);

	/// Gets the next complete message. False if more bytes are needed.
	bool next(LibertyMessage &r_message);

	/// Drops all unread bytes. Call it after a reconnection.
	void clear() { begin_ = end_ = 0; }

	/// Bytes that belonged to no message, since construction.
	[[nodiscard]] std::uint64_t skipped_bytes() const { return skipped_bytes_; }
	/// Bytes of an incomplete message.
	[[nodiscard]] std::size_t waiting_bytes() const { return end_ - begin_; }

	/// Eight times the longest message, so that whole transfers fit after an incomplete message.
	static constexpr std::size_t CAPACITY = 8192;
	static constexpr std::size_t HEADER_SIZE = 8;
	/// The manual's limit for one record. A header with more is no header.
	static constexpr std::size_t BODY_SIZE_MAX = 1000;

private:
	enum class Verdict : std::uint8_t { HEADER, NEEDS_MORE, NO_HEADER };

	[[nodiscard]] Verdict header_at(std::size_t offset, std::size_t end) const;
	[[nodiscard]] Verdict record_header_at(std::size_t offset, std::size_t end) const;
	[[nodiscard]] std::size_t next_record(std::size_t from, std::size_t end, std::size_t prefix) const;
	[[nodiscard]] std::string_view text_of(std::size_t from, std::size_t size) const;
	bool read_frame(LibertyMessage &r_message, std::size_t body_size);
	bool read_text(LibertyMessage &r_message, bool &r_needs_more);
	void skip(std::size_t count);

	std::array<std::uint8_t, CAPACITY> buffer_{};
	std::size_t begin_ = 0;
	std::size_t end_ = 0;
	std::uint64_t skipped_bytes_ = 0;
};

} // namespace steadyhand
