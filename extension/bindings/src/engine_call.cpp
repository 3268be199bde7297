#include <godot_cpp/core/engine_call.hpp>

#include <algorithm>
#include <vector>

namespace godot::internal {

namespace gd = gdextension_interface;

namespace {

template <typename Function> Function found(Function p_function, const String &p_what) {
	if (p_function == nullptr) {
		ERR_PRINT(p_what + ": this engine does not have it in the form that the library was built for.");
	}
	return p_function;
}

std::vector<GDExtensionConstVariantPtr> pointers_to(const Variant *p_arguments, size_t p_count) {
	std::vector<GDExtensionConstVariantPtr> pointers(p_count);
	std::transform(p_arguments, p_arguments + p_count, pointers.begin(),
			[](const Variant &p_argument) { return p_argument._native_ptr(); });
	return pointers;
}

} // namespace

GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash) {
	return found(gd::classdb_get_method_bind(
						 StringName(p_class)._native_ptr(), StringName(p_method)._native_ptr(), p_hash),
			String(p_class) + "." + p_method);
}

GDExtensionPtrBuiltInMethod find_builtin_method(
		GDExtensionVariantType p_type, const char *p_method, int64_t p_hash) {
	return found(gd::variant_get_ptr_builtin_method(p_type, StringName(p_method)._native_ptr(), p_hash),
			Variant::get_type_name(Variant::Type(p_type)) + "." + p_method);
}

GDExtensionPtrUtilityFunction find_utility(const char *p_function, int64_t p_hash) {
	return found(
			gd::variant_get_ptr_utility_function(StringName(p_function)._native_ptr(), p_hash), p_function);
}

Variant call_vararg(
		GDExtensionMethodBindPtr p_method, GodotObject *p_owner, const Variant *p_arguments, size_t p_count) {
	Variant result;
	if (p_method != nullptr) {
		GDExtensionCallError error = {};
		gd::object_method_bind_call(p_method, p_owner, pointers_to(p_arguments, p_count).data(),
				GDExtensionInt(p_count), result._native_ptr(), &error);
	}
	return result;
}

void call_vararg_utility(
		GDExtensionPtrUtilityFunction p_function, const Variant *p_arguments, size_t p_count) {
	if (p_function != nullptr) {
		p_function(nullptr, pointers_to(p_arguments, p_count).data(), int32_t(p_count));
	}
}

String enum_class_name(const char *p_cpp_name) {
	const PackedStringArray parts = String(p_cpp_name).split("::");
	const int64_t last = parts.size() - 1;
	return last == 0 ? parts[0] : parts[last - 1] + "." + parts[last];
}

} // namespace godot::internal
