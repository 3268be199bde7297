#pragma once

#include <godot_cpp/variant/char_string.hpp>
#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_size.hpp>

#include <cstdint>

namespace godot {

class Array;
class Dictionary;
class NodePath;
class PackedByteArray;
class PackedFloat64Array;
class PackedStringArray;
class StringName;
class Variant;

class String : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_STRING, internal::STRING_SIZE> {
public:
	String() = default;
	// Latin-1, as in Godot: other text goes through String::utf8().
	String(const char *p_text);
	String(const StringName &p_name);
	String(const NodePath &p_path);

	static String utf8(const char *p_text, int64_t p_length = -1);
	CharString utf8() const;

	String &operator+=(const String &p_other);
	String operator+(const String &p_other) const;
	// Godot's own formatting, as `"%s" % array` in GDScript.
	String operator%(const Array &p_values) const;
	char32_t operator[](int64_t p_index) const;

	bool operator==(const String &p_other) const;
	bool operator!=(const String &p_other) const { return !(*this == p_other); }
	bool operator<(const String &p_other) const;

#include <godot_cpp/variant/string_methods.inc>
};

inline String operator+(const char *p_left, const String &p_right) {
	return String(p_left) + p_right;
}
inline bool operator==(const String &p_left, const char *p_right) {
	return p_left == String(p_right);
}
inline bool operator!=(const String &p_left, const char *p_right) {
	return !(p_left == p_right);
}

String itos(int64_t p_value);

} // namespace godot
