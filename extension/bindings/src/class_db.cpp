#include <godot_cpp/core/class_db.hpp>

#include <godot_cpp/core/object_binding.hpp>

#include <vector>

namespace godot {

namespace gd = gdextension_interface;

namespace {

struct VirtualMethod {
	StringName name;
	uint32_t hash;
	GDExtensionClassCallVirtual call;
};

// Data that the engine refers to while the class is registered.
struct ClassRecord {
	StringName name;
	const ClassRecord *parent; // null if the parent is an engine class
	std::vector<std::unique_ptr<MethodBind>> methods;
	std::vector<VirtualMethod> virtuals;
};

// In order of registration. Only written while the library starts and ends.
std::vector<std::unique_ptr<ClassRecord>> classes;

ClassRecord *find_class(const StringName &p_name) {
	for (const std::unique_ptr<ClassRecord> &record : classes) {
		if (record->name == p_name) {
			return record.get();
		}
	}
	return nullptr;
}

void call_method(void *p_method, GDExtensionClassInstancePtr p_instance,
		const GDExtensionConstVariantPtr *p_arguments, GDExtensionInt p_count, GDExtensionVariantPtr r_return,
		GDExtensionCallError *r_error) {
	const MethodBind &method = *static_cast<const MethodBind *>(p_method);
	const size_t given = size_t(p_count);
	const size_t wanted = method.argument_count();
	const size_t defaults = method.default_arguments.size();
	if (given > wanted) {
		*r_error = { GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 0, int32_t(wanted) };
		return;
	}
	if (given + defaults < wanted) {
		*r_error = { GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0, int32_t(wanted - defaults) };
		return;
	}
	const Variant *arguments[MethodBind::MAX_ARGUMENTS] = {};
	for (size_t i = 0; i < wanted; i++) {
		arguments[i] = i < given ? static_cast<const Variant *>(p_arguments[i])
								 : &method.default_arguments[defaults - (wanted - i)];
	}
	*r_error = { GDEXTENSION_CALL_OK, 0, 0 };
	method.call(static_cast<Wrapped *>(p_instance), arguments, *static_cast<Variant *>(r_return), *r_error);
}

void ptrcall_method(void *p_method, GDExtensionClassInstancePtr p_instance,
		const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_return) {
	static_cast<const MethodBind *>(p_method)->ptrcall(
			static_cast<Wrapped *>(p_instance), p_arguments, r_return);
}

void register_method(const StringName &p_class, MethodBind &p_method) {
	const size_t count = p_method.argument_count();
	for (size_t i = 0; i < count; i++) {
		p_method.signature[i + 1].name = i < p_method.argument_names.size()
				? p_method.argument_names[i]
				: StringName("arg" + itos(int64_t(i)));
	}
	std::vector<GDExtensionPropertyInfo> signature;
	signature.reserve(p_method.signature.size());
	for (const PropertyInfo &info : p_method.signature) {
		signature.push_back(info._to_gdextension());
	}
	std::vector<GDExtensionVariantPtr> defaults;
	defaults.reserve(p_method.default_arguments.size());
	for (const Variant &value : p_method.default_arguments) {
		defaults.push_back(value._native_ptr());
	}
	const GDExtensionClassMethodInfo info = {
		.name = p_method.name._native_ptr(),
		.method_userdata = &p_method,
		.call_func = &call_method,
		.ptrcall_func = &ptrcall_method,
		.method_flags = p_method.flags,
		.has_return_value = p_method.has_return,
		.return_value_info = signature.data(),
		.return_value_metadata = p_method.metadata[0],
		.argument_count = uint32_t(count),
		.arguments_info = signature.data() + 1,
		.arguments_metadata = p_method.metadata.data() + 1,
		.default_argument_count = uint32_t(defaults.size()),
		.default_arguments = defaults.data(),
	};
	gd::classdb_register_extension_class_method(gd::library, p_class._native_ptr(), &info);
}

} // namespace

void ClassDB::register_record(const StringName &p_name, const StringName &p_parent, ClassKind p_kind,
		GDExtensionClassCreationInfo4 p_info) {
	if (classes.empty()) {
		internal::register_engine_classes();
	}
	classes.push_back(std::make_unique<ClassRecord>(ClassRecord{ p_name, find_class(p_parent), {}, {} }));
	internal::register_binding_callbacks(p_name, &internal::OWN_BINDING_CALLBACKS);
	p_info.is_abstract = p_kind.is_abstract;
	p_info.is_virtual = p_kind.is_virtual;
	p_info.is_exposed = p_kind.is_exposed;
	p_info.class_userdata = classes.back().get();
	gd::classdb_register_extension_class4(gd::library, p_name._native_ptr(), p_parent._native_ptr(), &p_info);
}

MethodBind *ClassDB::add_method(const StringName &p_class, const MethodDefinition &p_definition,
		std::unique_ptr<MethodBind> p_method, std::vector<Variant> p_defaults) {
	ClassRecord *const record = find_class(p_class);
	ERR_FAIL_NULL_V_MSG(record, nullptr, vformat("Class '%s' is not registered.", p_class));
	ERR_FAIL_COND_V_MSG(p_definition.arguments.size() > p_method->argument_count(), nullptr,
			vformat("%s.%s: more argument names than arguments.", p_class, p_definition.name));
	p_method->name = p_definition.name;
	p_method->argument_names = p_definition.arguments;
	p_method->default_arguments = std::move(p_defaults);
	register_method(p_class, *p_method);
	record->methods.push_back(std::move(p_method));
	return record->methods.back().get();
}

void ClassDB::bind_virtual_method(const StringName &p_class, const StringName &p_method,
		GDExtensionClassCallVirtual p_call, uint32_t p_hash) {
	find_class(p_class)->virtuals.push_back({ p_method, p_hash, p_call });
}

GDExtensionClassCallVirtual ClassDB::get_virtual(
		void *p_record, GDExtensionConstStringNamePtr p_name, uint32_t p_hash) {
	const StringName &name = *static_cast<const StringName *>(p_name);
	for (auto *record = static_cast<const ClassRecord *>(p_record); record != nullptr;
			record = record->parent) {
		for (const VirtualMethod &method : record->virtuals) {
			if (method.name == name && method.hash == p_hash) {
				return method.call;
			}
		}
	}
	return nullptr;
}

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter,
		const StringName &p_getter) {
	const GDExtensionPropertyInfo info = p_info._to_gdextension();
	gd::classdb_register_extension_class_property(
			gd::library, p_class._native_ptr(), &info, p_setter._native_ptr(), p_getter._native_ptr());
}

void ClassDB::add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix) {
	gd::classdb_register_extension_class_property_group(
			gd::library, p_class._native_ptr(), p_name._native_ptr(), p_prefix._native_ptr());
}

void ClassDB::add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix) {
	gd::classdb_register_extension_class_property_subgroup(
			gd::library, p_class._native_ptr(), p_name._native_ptr(), p_prefix._native_ptr());
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	std::vector<GDExtensionPropertyInfo> arguments;
	arguments.reserve(p_signal.arguments.size());
	for (const PropertyInfo &argument : p_signal.arguments) {
		arguments.push_back(argument._to_gdextension());
	}
	gd::classdb_register_extension_class_signal(gd::library, p_class._native_ptr(),
			p_signal.name._native_ptr(), arguments.data(), GDExtensionInt(arguments.size()));
}

void ClassDB::bind_integer_constant(const StringName &p_class, const StringName &p_enum,
		const StringName &p_constant, int64_t p_value, bool p_is_bitfield) {
	gd::classdb_register_extension_class_integer_constant(gd::library, p_class._native_ptr(),
			p_enum._native_ptr(), p_constant._native_ptr(), p_value, p_is_bitfield);
}

void ClassDB::_unregister_all() {
	while (!classes.empty()) {
		gd::classdb_unregister_extension_class(gd::library, classes.back()->name._native_ptr());
		classes.pop_back();
	}
}

} // namespace godot
