#pragma once

#include <godot_cpp/core/foundation.hpp>

#include <vector>

namespace godot {

// A method's or a signal's signature.
struct MethodInfo {
	StringName name;
	std::vector<PropertyInfo> arguments;

	template <typename... Args>
	MethodInfo(const StringName &p_name, const Args &...p_arguments) :
			name(p_name), arguments{ p_arguments... } {}
};

class ObjectDB {
public:
	static Object *get_instance(uint64_t p_id) {
		return static_cast<Object *>(
				internal::get_instance_binding(gdextension_interface::object_get_instance_from_id(p_id)));
	}
};

template <typename T> T *Object::cast_to(Object *p_object) {
	return dynamic_cast<T *>(p_object);
}
template <typename T> const T *Object::cast_to(const Object *p_object) {
	return dynamic_cast<const T *>(p_object);
}

} // namespace godot
