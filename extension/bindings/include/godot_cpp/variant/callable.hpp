#pragma once

#include <godot_cpp/variant/opaque.hpp>
#include <godot_cpp/variant/variant_size.hpp>

#include <cstdint>

namespace godot {

class Array;
class Object;
class StringName;
class Variant;

class Callable : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_CALLABLE, internal::CALLABLE_SIZE> {
public:
	Callable() = default;
	Callable(Object *p_object, const StringName &p_method);
	explicit Callable(const GDExtensionCallableCustomInfo2 &p_custom);

	bool operator==(const Callable &p_other) const;
	bool operator!=(const Callable &p_other) const { return !(*this == p_other); }

#include <godot_cpp/variant/callable_methods.inc>
};

} // namespace godot
