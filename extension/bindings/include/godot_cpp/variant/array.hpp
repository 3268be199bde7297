#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_size.hpp>

#include <cstdint>
#include <initializer_list>

namespace godot {

class Callable;
class StringName;
class Variant;

// Copies share one list, as in GDScript; duplicate() makes another.
class Array : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_ARRAY, internal::ARRAY_SIZE> {
public:
	Array() = default;
	Array(std::initializer_list<Variant> p_values);
	template <typename... Args> static Array make(const Args &...p_values) {
		return Array{ Variant(p_values)... };
	}

	Variant &operator[](int64_t p_index);
	const Variant &operator[](int64_t p_index) const;
	Variant *begin();
	Variant *end();
	const Variant *begin() const;
	const Variant *end() const;

	// The array must be empty. p_class_name: the objects' class, if p_type is OBJECT.
	void set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script);

#include <godot_cpp/variant/array_methods.inc>
};

} // namespace godot
