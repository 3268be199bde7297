#pragma once

#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/variant/builtin_types.hpp>

#include <cstddef>
#include <cstdint>

namespace godot {

class Object;

class Variant {
	alignas(8) std::byte storage_[internal::VARIANT_SIZE];

public:
	enum Type {
#include <godot_cpp/variant/variant_types.inc>
		VARIANT_MAX,
	};

	Variant();
	Variant(std::nullptr_t) : Variant() {}
	explicit Variant(GDExtensionConstVariantPtr p_native);
	Variant(const Variant &p_other) : Variant(GDExtensionConstVariantPtr(p_other.storage_)) {}
	Variant(Variant &&p_other) noexcept;
	~Variant();
	Variant &operator=(const Variant &p_other);
	Variant &operator=(Variant &&p_other) noexcept;

	Variant(bool p_value);
	Variant(int64_t p_value);
	Variant(int32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint64_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(double p_value);
	Variant(float p_value) : Variant(double(p_value)) {}
	Variant(const char *p_text) : Variant(String(p_text)) {}
	Variant(const Object *p_object);
	Variant(const ObjectID &p_id) : Variant(uint64_t(p_id)) {}

	operator bool() const;
	operator int64_t() const;
	operator int32_t() const {
		return int32_t(operator int64_t());
	}
	operator int16_t() const {
		return int16_t(operator int64_t());
	}
	operator int8_t() const {
		return int8_t(operator int64_t());
	}
	operator uint64_t() const {
		return uint64_t(operator int64_t());
	}
	operator uint32_t() const {
		return uint32_t(operator int64_t());
	}
	operator uint16_t() const {
		return uint16_t(operator int64_t());
	}
	operator uint8_t() const {
		return uint8_t(operator int64_t());
	}
	operator double() const;
	operator float() const {
		return float(operator double());
	}
	operator Object *() const;

#define GODOT_CPP_CONVERSIONS(m_type, m_name)                                                                \
	Variant(const m_type &p_value);                                                                          \
	operator m_type() const;
	GODOT_CPP_BUILTINS(GODOT_CPP_CONVERSIONS)
#undef GODOT_CPP_CONVERSIONS

	// By value, as `==` in GDScript.
	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const {
		return !(*this == p_other);
	}

	Type get_type() const;
	// Null if the object has been freed since.
	Object *get_validated_object() const;
	bool booleanize() const;
	String stringify() const;
	static String get_type_name(Type p_type);

	GDExtensionVariantPtr _native_ptr() const {
		return const_cast<std::byte *>(storage_);
	}
};

// `text % [values]` as in GDScript.
template <typename... Args> String vformat(const String &p_text, const Args &...p_values) {
	return p_text % Array::make(p_values...);
}

} // namespace godot
