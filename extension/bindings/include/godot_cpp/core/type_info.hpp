// Description of a C++ type in a signature for the engine: Variant type, width, class or enum.
#pragma once

#include <godot_cpp/core/enum_cast.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <type_traits>

namespace godot {

template <typename T> class Ref;

// A set of flags of the enum T.
template <typename T> class BitField {
	int64_t value_ = 0;

public:
	BitField() = default;
	BitField(int64_t p_value) : value_(p_value) {}
	BitField(T p_flag) : value_(int64_t(p_flag)) {}

	void set_flag(T p_flag) { value_ |= int64_t(p_flag); }
	bool has_flag(T p_flag) const { return (value_ & int64_t(p_flag)) != 0; }
	operator int64_t() const { return value_; }
};

namespace internal {

// Converts "a_namespace::Class::Enum" to the engine's name "Class.Enum".
String enum_class_name(const char *p_cpp_name);

template <typename T> inline constexpr bool IS_REF = false;
template <typename T> inline constexpr bool IS_REF<Ref<T>> = true;
template <typename T> inline constexpr bool IS_TYPED_ARRAY = false;
template <typename T> inline constexpr bool IS_TYPED_ARRAY<TypedArray<T>> = true;
template <typename T> inline constexpr bool IS_BIT_FIELD = false;
template <typename T> inline constexpr bool IS_BIT_FIELD<BitField<T>> = true;
template <typename T> struct ElementOf;
template <template <typename> typename C, typename T> struct ElementOf<C<T>> { using Type = T; };

template <typename T> constexpr GDExtensionClassMethodArgumentMetadata number_metadata() {
	if constexpr (std::is_floating_point_v<T>) {
		return sizeof(T) == 4 ? GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_FLOAT
							  : GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_DOUBLE;
	} else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
		// INT_IS_INT8 .. INT64, then UINT8 .. UINT64, each by growing width.
		constexpr int width = sizeof(T) == 1 ? 0 : (sizeof(T) == 2 ? 1 : (sizeof(T) == 4 ? 2 : 3));
		constexpr int first = std::is_signed_v<T> ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT8
												  : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT8;
		return GDExtensionClassMethodArgumentMetadata(first + width);
	} else {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	}
}

} // namespace internal

// T: a type in a signature, without const and reference.
template <typename T> struct GetTypeInfo {
	static constexpr GDExtensionClassMethodArgumentMetadata METADATA = internal::number_metadata<T>();

	static PropertyInfo get_class_info() {
		if constexpr (std::is_void_v<T>) {
			return PropertyInfo(Variant::NIL, "");
		} else if constexpr (std::is_same_v<T, bool>) {
			return PropertyInfo(Variant::BOOL, "");
		} else if constexpr (std::is_enum_v<T>) {
			return enum_info<T>(PROPERTY_USAGE_CLASS_IS_ENUM);
		} else if constexpr (internal::IS_BIT_FIELD<T>) {
			return enum_info<typename internal::ElementOf<T>::Type>(PROPERTY_USAGE_CLASS_IS_BITFIELD);
		} else if constexpr (std::is_integral_v<T>) {
			return PropertyInfo(Variant::INT, "");
		} else if constexpr (std::is_floating_point_v<T>) {
			return PropertyInfo(Variant::FLOAT, "");
		} else if constexpr (std::is_same_v<T, Variant>) {
			return PropertyInfo(Variant::NIL, "", PROPERTY_HINT_NONE, "",
					PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_NIL_IS_VARIANT);
		} else if constexpr (internal::IS_TYPED_ARRAY<T>) {
			return PropertyInfo(Variant::ARRAY, "", PROPERTY_HINT_ARRAY_TYPE, element_name());
		} else if constexpr (internal::IS_REF<T>) {
			return PropertyInfo(Variant::OBJECT, "", PROPERTY_HINT_RESOURCE_TYPE,
					internal::ElementOf<T>::Type::get_class_static());
		} else if constexpr (std::is_pointer_v<T>) {
			return PropertyInfo(Variant::OBJECT, "", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_DEFAULT,
					std::remove_pointer_t<T>::get_class_static());
		} else {
			return PropertyInfo(Variant::Type(internal::BUILTIN_TYPE<T>), "");
		}
	}

private:
	template <typename Enum> static PropertyInfo enum_info(uint32_t p_kind) {
		static_assert(internal::ENUM_NAME<Enum> != nullptr, "VARIANT_ENUM_CAST is missing for this enum");
		return PropertyInfo(Variant::INT, "", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_DEFAULT | p_kind,
				internal::enum_class_name(internal::ENUM_NAME<Enum>));
	}
	static String element_name() {
		if constexpr (T::element_type() == GDEXTENSION_VARIANT_TYPE_OBJECT) {
			return T::element_class();
		} else {
			return Variant::get_type_name(Variant::Type(T::element_type()));
		}
	}
};

} // namespace godot
