#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_size.hpp>

#include <cstring>

namespace godot {

class String;

class StringName : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_STRING_NAME, internal::STRING_NAME_SIZE> {
public:
	StringName() = default;
	// Latin-1. The engine copies it, because static text does not outlive the library.
	StringName(const char *p_text);
	StringName(const String &p_text);

	// Equal names share one record in the engine. A StringName only has the record's address.
	const void *_identity() const {
		const void *identity = nullptr;
		std::memcpy(&identity, _native_ptr(), sizeof(identity));
		return identity;
	}
	bool operator==(const StringName &p_other) const { return _identity() == p_other._identity(); }
	bool operator!=(const StringName &p_other) const { return !(*this == p_other); }
	bool operator<(const StringName &p_other) const { return _identity() < p_other._identity(); }
	bool is_empty() const { return _identity() == nullptr; }
};

inline bool operator==(const StringName &p_left, const char *p_right) {
	return p_left == StringName(p_right);
}
inline bool operator!=(const StringName &p_left, const char *p_right) {
	return !(p_left == p_right);
}

} // namespace godot
