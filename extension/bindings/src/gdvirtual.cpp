#include <godot_cpp/core/gdvirtual.gen.inc>

namespace godot::internal {

namespace gd = gdextension_interface;

bool has_script_method(GodotObject *p_owner, const StringName &p_name) {
	return gd::object_has_script_method(p_owner, p_name._native_ptr()) != 0;
}

bool call_script_method(GodotObject *p_owner, const StringName &p_name, const Variant *p_arguments,
		size_t p_count, Variant &r_result) {
	std::vector<GDExtensionConstVariantPtr> pointers(p_count);
	for (size_t i = 0; i < p_count; i++) {
		pointers[i] = p_arguments[i]._native_ptr();
	}
	GDExtensionCallError error = {};
	r_result = Variant();
	gd::object_call_script_method(p_owner, p_name._native_ptr(), pointers.data(), GDExtensionInt(p_count),
			r_result._native_ptr(), &error);
	return error.error == GDEXTENSION_CALL_OK;
}

void bind_script_method(const StringName &p_class, const StringName &p_name,
		const std::vector<PropertyInfo> &p_signature, const std::vector<StringName> &p_argument_names,
		bool p_has_result) {
	std::vector<PropertyInfo> signature = p_signature;
	std::vector<GDExtensionPropertyInfo> infos;
	for (size_t i = 0; i < signature.size(); i++) {
		if (i > 0) {
			signature[i].name = p_argument_names[i - 1];
		}
		infos.push_back(signature[i]._to_gdextension());
	}
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata(
			signature.size(), GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE);
	GDExtensionClassVirtualMethodInfo info = {};
	info.name = p_name._native_ptr();
	info.method_flags = GDEXTENSION_METHOD_FLAG_NORMAL | GDEXTENSION_METHOD_FLAG_VIRTUAL;
	if (p_has_result) {
		info.return_value = infos[0];
	} else {
		static const PropertyInfo nothing;
		info.return_value = nothing._to_gdextension();
	}
	info.return_value_metadata = metadata[0];
	info.argument_count = uint32_t(infos.size() - 1);
	info.arguments = infos.data() + 1;
	info.arguments_metadata = metadata.data() + 1;
	gd::classdb_register_extension_class_virtual_method(gd::library, p_class._native_ptr(), &info);
}

} // namespace godot::internal
