#pragma once

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <type_traits>

namespace godot {

// T: a builtin type, a number type, or the class of the objects.
template <typename T> class TypedArray : public Array {
public:
	static constexpr GDExtensionVariantType element_type() {
		if constexpr (std::is_same_v<T, bool>) {
			return GDEXTENSION_VARIANT_TYPE_BOOL;
		} else if constexpr (std::is_integral_v<T>) {
			return GDEXTENSION_VARIANT_TYPE_INT;
		} else if constexpr (std::is_floating_point_v<T>) {
			return GDEXTENSION_VARIANT_TYPE_FLOAT;
		} else if constexpr (internal::Builtin<T>) {
			return internal::BUILTIN_TYPE<T>;
		} else {
			return GDEXTENSION_VARIANT_TYPE_OBJECT;
		}
	}
	static StringName element_class() {
		if constexpr (element_type() == GDEXTENSION_VARIANT_TYPE_OBJECT) {
			return T::get_class_static();
		} else {
			return StringName();
		}
	}

	TypedArray() { set_typed(element_type(), element_class(), Variant()); }
	// Shares an array of the same type, copies any other whose values convert.
	TypedArray(const Array &p_array) : TypedArray() {
		if (is_same_typed(p_array)) {
			Array::operator=(p_array);
		} else {
			assign(p_array);
		}
	}
	TypedArray(const Variant &p_array) : TypedArray(p_array.operator Array()) {}
	TypedArray(std::initializer_list<Variant> p_values) : TypedArray(Array(p_values)) {}
	TypedArray(const TypedArray &) = default;
	TypedArray &operator=(const TypedArray &) = default;
	void operator=(const Array &p_array) {
		ERR_FAIL_COND_MSG(!is_same_typed(p_array), "Cannot assign an array with a different element type.");
		Array::operator=(p_array);
	}
};

} // namespace godot
