#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace godot {

// The bytes of a String in another encoding, as String::utf8() returns them.
class CharString {
	std::string bytes_;

public:
	CharString() = default;
	explicit CharString(std::string p_bytes) : bytes_(std::move(p_bytes)) {}

	const char *get_data() const { return bytes_.c_str(); }
	const char *ptr() const { return bytes_.c_str(); }
	int64_t length() const { return int64_t(bytes_.size()); }
	// Counts the terminating zero, as in Godot.
	int64_t size() const { return bytes_.empty() ? 0 : length() + 1; }
};

} // namespace godot
