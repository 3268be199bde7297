// Registration of our classes with the engine, with godot-cpp's names.
#pragma once

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/method_bind.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <memory>

namespace godot {

#define DEFVAL(m_value) (m_value)

class ClassDB {
	// Properties of one class that the engine's registration needs.
	struct ClassKind {
		bool is_abstract = false;
		bool is_virtual = false; // can only be extended by scripts, not instantiated
		bool is_exposed = true;
	};
	static void register_record(const StringName &p_name, const StringName &p_parent, ClassKind p_kind,
			GDExtensionClassCreationInfo4 p_info);
	static MethodBind *add_method(const StringName &p_class, const MethodDefinition &p_definition,
			std::unique_ptr<MethodBind> p_method, std::vector<Variant> p_defaults);
	static GDExtensionClassCallVirtual get_virtual(
			void *p_record, GDExtensionConstStringNamePtr p_name, uint32_t p_hash);

	template <typename T>
	static GDExtensionObjectPtr create_instance(void *, GDExtensionBool p_notify_postinitialize) {
		T::_announce_construction();
		T *const object = new T;
		if (p_notify_postinitialize) {
			internal::post_initialize(object);
		}
		return object->_owner;
	}
	template <typename T> static void free_instance(void *, GDExtensionClassInstancePtr p_instance) {
		delete static_cast<T *>(static_cast<Wrapped *>(p_instance));
	}
	template <typename T>
	static void notification(
			GDExtensionClassInstancePtr p_instance, int32_t p_what, GDExtensionBool p_reversed) {
		T::_dispatch_notification(static_cast<Wrapped *>(p_instance), p_what, p_reversed);
	}
	template <typename T>
	static GDExtensionBool validate_property(
			GDExtensionClassInstancePtr p_instance, GDExtensionPropertyInfo *r_property) {
		PropertyInfo info(*r_property);
		const bool handled = T::_dispatch_validate_property(static_cast<Wrapped *>(p_instance), info);
		if (handled) {
			info._update(*r_property);
		}
		return handled;
	}

	template <typename T> static void register_kind(ClassKind p_kind) {
		static_assert(std::is_same_v<typename T::self_type, T>, "GDCLASS is missing");
		static_assert(&T::_bind_methods != T::parent_type::_bind_methods_ptr(), "_bind_methods() is missing");
		T::template _refuse_unsupported<T>();
		GDExtensionClassCreationInfo4 info = {};
		info.validate_property_func = &validate_property<T>;
		info.notification_func = &notification<T>;
		info.free_instance_func = &free_instance<T>;
		if constexpr (!std::is_abstract_v<T>) {
			info.create_instance_func = &create_instance<T>;
		}
		info.get_virtual_func = &get_virtual;
		register_record(T::get_class_static(), T::parent_type::get_class_static(), p_kind, info);
		T::_bind_methods();
		T::parent_type::template register_virtuals<T, typename T::parent_type>();
	}

public:
	template <typename T> static void register_class() { register_kind<T>({}); }
	template <typename T> static void register_internal_class() { register_kind<T>({ .is_exposed = false }); }
	template <typename T> static void register_class(bool p_virtual) {
		register_kind<T>({ .is_virtual = p_virtual });
	}
	template <typename T> static void register_abstract_class() { register_kind<T>({ .is_abstract = true }); }

	template <typename F, typename... Defaults>
	static MethodBind *bind_method(
			const MethodDefinition &p_definition, F p_function, const Defaults &...p_defaults) {
		return add_method(internal::FunctionOf<F>::Instance::get_class_static(), p_definition,
				std::make_unique<internal::FunctionBind<F>>(p_function), { Variant(p_defaults)... });
	}
	template <typename F, typename... Defaults>
	static MethodBind *bind_static_method(const StringName &p_class, const MethodDefinition &p_definition,
			F p_function, const Defaults &...p_defaults) {
		return add_method(p_class, p_definition, std::make_unique<internal::FunctionBind<F>>(p_function),
				{ Variant(p_defaults)... });
	}
	// p_hash: hash of the signature, which must be the engine's.
	static void bind_virtual_method(const StringName &p_class, const StringName &p_method,
			GDExtensionClassCallVirtual p_call, uint32_t p_hash);

	static void add_property(const StringName &p_class, const PropertyInfo &p_info,
			const StringName &p_setter, const StringName &p_getter);
	static void add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_property_subgroup(
			const StringName &p_class, const String &p_name, const String &p_prefix);
	static void add_signal(const StringName &p_class, const MethodInfo &p_signal);
	static void bind_integer_constant(const StringName &p_class, const StringName &p_enum,
			const StringName &p_constant, int64_t p_value, bool p_is_bitfield = false);

	// Unregisters all classes, the last registered one first.
	static void _unregister_all();
};

template <auto FUNCTION>
void _call_virtual(GDExtensionClassInstancePtr p_instance, const GDExtensionConstTypePtr *p_arguments,
		GDExtensionTypePtr r_ret) {
	internal::call_with_pointers(FUNCTION, static_cast<Wrapped *>(p_instance), p_arguments, r_ret);
}

} // namespace godot

#define GDREGISTER_CLASS(m_class) ::godot::ClassDB::register_class<m_class>();
#define GDREGISTER_VIRTUAL_CLASS(m_class) ::godot::ClassDB::register_class<m_class>(true);
#define GDREGISTER_INTERNAL_CLASS(m_class) ::godot::ClassDB::register_internal_class<m_class>();
#define GDREGISTER_ABSTRACT_CLASS(m_class) ::godot::ClassDB::register_abstract_class<m_class>();

#define ADD_SIGNAL(m_signal) ::godot::ClassDB::add_signal(get_class_static(), m_signal)
#define ADD_GROUP(m_name, m_prefix) ::godot::ClassDB::add_property_group(get_class_static(), m_name, m_prefix)
#define ADD_SUBGROUP(m_name, m_prefix)                                                                       \
	::godot::ClassDB::add_property_subgroup(get_class_static(), m_name, m_prefix)
#define ADD_PROPERTY(m_property, m_setter, m_getter)                                                         \
	::godot::ClassDB::add_property(get_class_static(), m_property, m_setter, m_getter)

#define BIND_CONSTANT(m_constant)                                                                            \
	::godot::ClassDB::bind_integer_constant(get_class_static(), "", #m_constant, m_constant);
#define BIND_ENUM_CONSTANT(m_constant)                                                                       \
	::godot::ClassDB::bind_integer_constant(get_class_static(),                                              \
			::godot::GetTypeInfo<decltype(m_constant)>::get_class_info().class_name, #m_constant,            \
			int64_t(m_constant));
