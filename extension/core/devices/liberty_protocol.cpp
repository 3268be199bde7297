#include "devices/liberty_protocol.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace steadyhand {

namespace {

// Offsets in the header.
constexpr std::size_t STATION = 2;
constexpr std::size_t COMMAND = 3;
constexpr std::size_t FAULT = 4;
constexpr std::size_t BODY_SIZE = 6;

constexpr std::uint8_t NO_FAULT = 0x00;
constexpr std::uint8_t NO_FAULT_ASCII = 0x20;      // no error, in ASCII mode
constexpr std::uint8_t CODE_MAX = 24;              // the manual lists codes 1 to 24
constexpr std::uint8_t STATION_MAP_COMMAND = 0x15; // ^U
constexpr std::size_t STATION_MAP_SIZE = 4;

constexpr double M_PER_CM = 0.01; // the start-up sequence switches the tracker to centimetres

/// m. The largest source reaches 4.6 m; a position beyond this is a damaged record.
constexpr double REACH_M = 20.0;

/// The tracker rounds quaternions to five digits; a length that differs from 1 by more is a damaged record.
constexpr double QUATERNION_TOLERANCE = 0.01;

/// Shorter runs of printable characters occur in damaged data by chance.
constexpr std::size_t TEXT_SIZE_MIN = 6;

/// Bytes of a header that cannot be the end of a pose by chance: the tag and the station.
constexpr std::size_t SURE_PREFIX = 3;

bool is_printable(std::uint8_t byte) {
	return byte >= 0x20 && byte < 0x7F;
}

bool is_line_end(std::uint8_t byte) {
	return byte == '\r' || byte == '\n';
}

bool is_record_command(std::uint8_t command) {
	return command == 'C' || command == 'P';
}

bool is_fault_byte(std::uint8_t byte) {
	return byte <= CODE_MAX || byte == NO_FAULT_ASCII || is_liberty_record_fault(byte);
}

/// Liberty, Patriot and Latus. The Liberty's manual also prints the Patriot's tag.
bool is_tag(std::uint8_t first, std::uint8_t second) {
	return (first == 'L' && (second == 'Y' || second == 'U')) || (first == 'P' && second == 'A');
}

std::uint32_t read_u32(const std::uint8_t *bytes) {
	return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U |
			static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
}

std::size_t read_u16(const std::uint8_t *bytes) {
	return static_cast<std::size_t>(bytes[0]) | static_cast<std::size_t>(bytes[1]) << 8U;
}

double read_float(const std::uint8_t *bytes) {
	return std::bit_cast<float>(read_u32(bytes));
}

/// A body of the output list. Returns false if the quaternion's length is not 1: the bytes are damaged.
bool read_pose(const std::uint8_t *body, LibertyRecord &r_record) {
	r_record.device_time_ms = read_u32(body);
	r_record.frame_count = read_u32(body + 4);
	r_record.distortion = std::bit_cast<std::int32_t>(read_u32(body + 8));
	const Eigen::Vector3d cm(read_float(body + 12), read_float(body + 16), read_float(body + 20));
	const double w = read_float(body + 24), x = read_float(body + 28), y = read_float(body + 32),
				 z = read_float(body + 36);
	const double length = std::sqrt(w * w + x * x + y * y + z * z);
	const bool is_unit_length = std::abs(length - 1.0) <= QUATERNION_TOLERANCE; // false for NaN

	// A sensor cannot be inside the source: all zeros mean no measurement.
	r_record.is_tracked =
			is_unit_length && cm.allFinite() && cm.norm() * M_PER_CM <= REACH_M && !cm.isZero(0.0);
	if (r_record.is_tracked) {
		r_record.source_position_m = cm * M_PER_CM;
		r_record.position_m = Eigen::Vector3d(cm.y(), -cm.z(), -cm.x()) * M_PER_CM;
		r_record.rotation = Eigen::Quaterniond(w, y, -z, -x).normalized();
	}
	return is_unit_length;
}

} // namespace

void LibertyParser::feed(std::span<const std::uint8_t> bytes) {
	if (bytes.size() > CAPACITY) {
		skipped_bytes_ += bytes.size() - CAPACITY;
		bytes = bytes.last(CAPACITY);
	}
	const std::size_t waiting = end_ - begin_;
	if (waiting + bytes.size() > CAPACITY) {
		skip(waiting + bytes.size() - CAPACITY);
	}
	std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
	end_ -= begin_;
	begin_ = 0;
	std::copy(bytes.begin(), bytes.end(), buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
	end_ += bytes.size();
}

bool LibertyParser::next(LibertyMessage &r_message) {
	while (begin_ < end_) {
		const Verdict verdict = header_at(begin_, end_);
		if (verdict == Verdict::NEEDS_MORE) {
			return false;
		}
		if (verdict == Verdict::HEADER) {
			const std::size_t body_size = read_u16(&buffer_[begin_ + BODY_SIZE]);
			if (end_ - begin_ < HEADER_SIZE + body_size) {
				const std::size_t record = next_record(begin_ + 1, end_, HEADER_SIZE);
				if (record == end_) {
					return false;
				}
				skip(record - begin_); // the incomplete record was cut off
				continue;
			}
			if (read_frame(r_message, body_size)) {
				return true;
			}
			continue;
		}
		bool needs_more = false;
		if (read_text(r_message, needs_more)) {
			return true;
		}
		if (needs_more) {
			return false;
		}
	}
	return false;
}

/// Whether a header starts at `offset`. NEEDS_MORE if the bytes before `end` are the begin of a header.
LibertyParser::Verdict LibertyParser::header_at(std::size_t offset, std::size_t end) const {
	const std::uint8_t *const bytes = &buffer_[offset];
	const std::size_t size = std::min(end - offset, HEADER_SIZE);
	const bool fits = (bytes[0] == 'L' || bytes[0] == 'P') && (size < 2 || is_tag(bytes[0], bytes[1])) &&
			(size <= STATION || bytes[STATION] <= LIBERTY_STATION_COUNT) &&
			(size <= FAULT || is_fault_byte(bytes[FAULT])) &&
			(size < HEADER_SIZE || read_u16(bytes + BODY_SIZE) <= BODY_SIZE_MAX);
	if (!fits) {
		return Verdict::NO_HEADER;
	}
	return size < HEADER_SIZE ? Verdict::NEEDS_MORE : Verdict::HEADER;
}

/// As header_at(), but only for a record of the right size, which does not occur inside a body by chance.
LibertyParser::Verdict LibertyParser::record_header_at(std::size_t offset, std::size_t end) const {
	const std::uint8_t *const bytes = &buffer_[offset];
	const std::size_t size = std::min(end - offset, HEADER_SIZE);
	const bool fits = (size <= STATION || bytes[STATION] != 0) &&
			(size <= COMMAND || is_record_command(bytes[COMMAND])) &&
			(size < HEADER_SIZE || read_u16(bytes + BODY_SIZE) == LIBERTY_RECORD_SIZE);
	return fits ? header_at(offset, end) : Verdict::NO_HEADER;
}

/// Offset of the first record header of which at least `prefix` bytes are received; `end` if there is none.
std::size_t LibertyParser::next_record(std::size_t from, std::size_t end, std::size_t prefix) const {
	for (std::size_t i = from; i + prefix <= end; ++i) {
		if (record_header_at(i, end) != Verdict::NO_HEADER) {
			return i;
		}
	}
	return end;
}

/// Reads the complete frame at `begin_`. False if it is no message. Its bytes are removed in both cases.
bool LibertyParser::read_frame(LibertyMessage &r_message, std::size_t body_size) {
	const std::uint8_t *const header = &buffer_[begin_];
	const std::size_t body = begin_ + HEADER_SIZE, end = body + body_size;
	const std::uint8_t command = header[COMMAND], fault = header[FAULT];
	const bool is_answered = fault == NO_FAULT || fault == NO_FAULT_ASCII;
	const bool has_pose = is_record_command(command) && (is_answered || is_liberty_record_fault(fault)) &&
			header[STATION] != 0;

	r_message = LibertyMessage();
	r_message.command = static_cast<char>(command);
	r_message.code = is_answered ? NO_FAULT : fault;
	r_message.body_size = body_size;
	bool is_damaged = false;
	if (has_pose && body_size == LIBERTY_RECORD_SIZE) {
		r_message.kind = LibertyMessage::Kind::RECORD;
		r_message.record.station = header[STATION];
		r_message.record.command = static_cast<char>(command);
		r_message.record.fault = static_cast<char>(r_message.code);
		is_damaged = !read_pose(&buffer_[body], r_message.record);
	}
	// A lost transfer cuts a record short; the next one then starts inside it.
	const std::size_t next = next_record(begin_ + 1, end, is_damaged ? 1 : SURE_PREFIX);
	if (has_pose && next < end) {
		skip(next - begin_);
		return false;
	}
	begin_ = end;
	if (has_pose) {
		if (body_size != LIBERTY_RECORD_SIZE) {
			r_message.kind = LibertyMessage::Kind::WRONG_RECORD;
			r_message.record.station = header[STATION];
		}
		return true;
	}
	if (!is_answered) {
		r_message.kind = LibertyMessage::Kind::REFUSAL;
		r_message.text = text_of(body, body_size);
		return true;
	}
	if (command == STATION_MAP_COMMAND && body_size == STATION_MAP_SIZE) {
		// One half has the detected stations, the other the active ones. Their order differs between sources.
		r_message.kind = LibertyMessage::Kind::STATION_MAP;
		const std::uint32_t halves = read_u32(&buffer_[body]);
		r_message.stations = (halves >> 16U) & halves & 0xFFFFU;
		return true;
	}
	return false; // an answer to a command that this program does not send
}

/// Reads a line of text at `begin_`, which is no header, or skips other bytes.
bool LibertyParser::read_text(LibertyMessage &r_message, bool &r_needs_more) {
	std::size_t stop = begin_;
	Verdict verdict = Verdict::NO_HEADER;
	while (stop < end_ && stop - begin_ < BODY_SIZE_MAX && is_printable(buffer_[stop])) {
		verdict = stop == begin_ ? Verdict::NO_HEADER : header_at(stop, end_);
		if (verdict != Verdict::NO_HEADER) {
			break;
		}
		++stop;
	}
	const std::size_t size = stop - begin_;
	if (verdict == Verdict::NEEDS_MORE || (stop == end_ && size < BODY_SIZE_MAX)) {
		r_needs_more = true;
		return false;
	}
	const bool is_whole = verdict == Verdict::HEADER || is_line_end(buffer_[stop]);
	if (size < TEXT_SIZE_MIN || size >= BODY_SIZE_MAX || !is_whole) {
		skip(std::max<std::size_t>(size, 1));
		return false;
	}
	r_message = LibertyMessage();
	r_message.kind = LibertyMessage::Kind::TEXT;
	r_message.text = text_of(begin_, size);
	begin_ = stop;
	return true;
}

/// The printable bytes that a body begins with.
std::string_view LibertyParser::text_of(std::size_t from, std::size_t size) const {
	const auto first = buffer_.begin() + static_cast<std::ptrdiff_t>(from);
	const auto last = std::find_if_not(first, first + static_cast<std::ptrdiff_t>(size), is_printable);
	return { reinterpret_cast<const char *>(buffer_.data()) + from, static_cast<std::size_t>(last - first) };
}

void LibertyParser::skip(std::size_t count) {
	begin_ += count;
	skipped_bytes_ += count;
}

} // namespace steadyhand
