#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = String(), uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = StringName()) :
			type(p_type),
			name(p_name), class_name(p_class_name), hint(p_hint), hint_string(p_hint_string), usage(p_usage) {
		if (hint == PROPERTY_HINT_RESOURCE_TYPE) {
			class_name = hint_string;
		}
	}
	explicit PropertyInfo(const GDExtensionPropertyInfo &p_info) :
			PropertyInfo(Variant::Type(p_info.type), *static_cast<const StringName *>(p_info.name),
					PropertyHint(p_info.hint), *static_cast<const String *>(p_info.hint_string), p_info.usage,
					*static_cast<const StringName *>(p_info.class_name)) {}

	// Points into this object, which must outlive the result.
	GDExtensionPropertyInfo _to_gdextension() const {
		return { GDExtensionVariantType(type), name._native_ptr(), class_name._native_ptr(), hint,
			hint_string._native_ptr(), usage };
	}

	void _update(GDExtensionPropertyInfo &r_info) const {
		r_info.type = GDExtensionVariantType(type);
		*static_cast<StringName *>(r_info.name) = name;
		*static_cast<StringName *>(r_info.class_name) = class_name;
		r_info.hint = hint;
		*static_cast<String *>(r_info.hint_string) = hint_string;
		r_info.usage = usage;
	}
};

} // namespace godot
