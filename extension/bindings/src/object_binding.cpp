#include <godot_cpp/core/object_binding.hpp>

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/core/engine_call.hpp>

#include <algorithm>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace godot {

namespace internal {

namespace {

// Guards the variables below: objects are wrapped from any thread.
std::mutex mutex;
std::unordered_map<const void *, const GDExtensionInstanceBindingCallbacks *> callbacks_by_class;
std::vector<StringName> known_classes; // owns the names whose addresses are the keys above
std::vector<GodotObject *> wrapped_singletons;

const GDExtensionInstanceBindingCallbacks *callbacks_of(StringName p_class) {
	while (!p_class.is_empty()) {
		{
			const std::lock_guard lock(mutex);
			const auto found = callbacks_by_class.find(p_class._identity());
			if (found != callbacks_by_class.end()) {
				return found->second;
			}
		}
		p_class = parent_class(p_class);
	}
	return nullptr;
}

} // namespace

void register_binding_callbacks(
		const StringName &p_class, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
	const std::lock_guard lock(mutex);
	if (callbacks_by_class.insert_or_assign(p_class._identity(), p_callbacks).second) {
		known_classes.push_back(p_class);
	}
}

Wrapped *get_instance_binding(GodotObject *p_object) {
	namespace gd = gdextension_interface;
	if (p_object == nullptr) {
		return nullptr;
	}
	if (void *const existing = gd::object_get_instance_binding(p_object, gd::library, nullptr)) {
		return static_cast<Wrapped *>(existing);
	}
	StringName name;
	const bool has_name = gd::object_get_class_name(p_object, gd::library, name._native_ptr());
	const GDExtensionInstanceBindingCallbacks *callbacks = has_name ? callbacks_of(name) : nullptr;
	if (callbacks == nullptr) {
		callbacks = &Object::_binding_callbacks;
	}
	return static_cast<Wrapped *>(gd::object_get_instance_binding(p_object, gd::library, callbacks));
}

Wrapped *get_singleton(const StringName &p_name) {
	GodotObject *const object = gdextension_interface::global_get_singleton(p_name._native_ptr());
	ERR_FAIL_NULL_V(object, nullptr);
	{
		const std::lock_guard lock(mutex);
		if (std::find(wrapped_singletons.begin(), wrapped_singletons.end(), object) ==
				wrapped_singletons.end()) {
			wrapped_singletons.push_back(object);
		}
	}
	return get_instance_binding(object);
}

StringName parent_class(const StringName &p_class) {
	return ClassDBSingleton::get_singleton()->get_parent_class(p_class);
}

void release_bindings() {
	for (GodotObject *const object : wrapped_singletons) {
		gdextension_interface::object_free_instance_binding(object, gdextension_interface::library);
	}
	wrapped_singletons.clear();
	callbacks_by_class.clear();
	known_classes.clear();
}

void post_initialize(Wrapped *p_object) {
	static_cast<Object *>(p_object)->notification(Object::NOTIFICATION_POSTINITIALIZE);
}

void destroy_object(Wrapped *p_object) {
	if (p_object != nullptr) {
		gdextension_interface::object_destroy(p_object->_owner);
	}
}

} // namespace internal

Wrapped::Construction &Wrapped::_construction() {
	static thread_local Construction construction;
	return construction;
}

Wrapped::Wrapped(const StringName &p_engine_class) {
	namespace gd = gdextension_interface;
	// Reset, so that objects made by members of this object do not use it.
	const Construction construction = std::exchange(_construction(), Construction());
	_owner = gd::classdb_construct_object2(p_engine_class._native_ptr());
	if (construction.extension_class != nullptr) {
		gd::object_set_instance(_owner, construction.extension_class->_native_ptr(), this);
	}
	ERR_FAIL_NULL_MSG(construction.callbacks, "An engine object has to be made with memnew().");
	gd::object_set_instance_binding(_owner, gd::library, this, construction.callbacks);
}

} // namespace godot
