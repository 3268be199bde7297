#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_size.hpp>

#include <cstdint>

namespace godot {

class Array;
class Variant;

// Copies share one table, as in GDScript; duplicate() makes another.
class Dictionary : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_DICTIONARY, internal::DICTIONARY_SIZE> {
public:
	// For a missing key, the first adds an entry, and the second returns nil.
	Variant &operator[](const Variant &p_key);
	const Variant &operator[](const Variant &p_key) const;

#include <godot_cpp/variant/dictionary_methods.inc>
};

} // namespace godot
