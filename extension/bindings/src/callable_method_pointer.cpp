#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace godot::internal {

namespace gd = gdextension_interface;

namespace {

struct BoundMethod {
	uint64_t object_id;
	std::unique_ptr<MethodBind> method;
	std::string identity;

	bool operator==(const BoundMethod &p_other) const {
		return object_id == p_other.object_id && identity == p_other.identity;
	}
};

void call(void *p_bound, const GDExtensionConstVariantPtr *p_arguments, GDExtensionInt p_count,
		GDExtensionVariantPtr r_return, GDExtensionCallError *r_error) {
	const BoundMethod &bound = *static_cast<const BoundMethod *>(p_bound);
	const size_t wanted = bound.method->argument_count();
	if (size_t(p_count) != wanted) {
		*r_error = { size_t(p_count) > wanted ? GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS
											  : GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS,
			0, int32_t(wanted) };
		return;
	}
	Object *const object = ObjectDB::get_instance(bound.object_id);
	if (object == nullptr) {
		*r_error = { GDEXTENSION_CALL_ERROR_INSTANCE_IS_NULL, 0, 0 };
		return;
	}
	*r_error = { GDEXTENSION_CALL_OK, 0, 0 };
	bound.method->call(object, reinterpret_cast<const Variant *const *>(p_arguments),
			*static_cast<Variant *>(r_return), *r_error);
}

GDExtensionBool is_valid(void *p_bound) {
	return gd::object_get_instance_from_id(static_cast<const BoundMethod *>(p_bound)->object_id) != nullptr;
}

void free_bound(void *p_bound) {
	delete static_cast<BoundMethod *>(p_bound);
}

uint32_t hash(void *p_bound) {
	const BoundMethod &bound = *static_cast<const BoundMethod *>(p_bound);
	return uint32_t(std::hash<std::string_view>()(bound.identity) ^ std::hash<uint64_t>()(bound.object_id));
}

GDExtensionBool equal(void *p_left, void *p_right) {
	return *static_cast<const BoundMethod *>(p_left) == *static_cast<const BoundMethod *>(p_right);
}

} // namespace

Callable make_callable(
		Object *p_object, std::unique_ptr<MethodBind> p_method, const void *p_identity, size_t p_size) {
	ERR_FAIL_NULL_V(p_object, Callable());
	const uint64_t object_id = gd::object_get_instance_id(p_object->_owner);
	GDExtensionCallableCustomInfo2 info = {};
	info.callable_userdata = new BoundMethod{ object_id, std::move(p_method),
		std::string(static_cast<const char *>(p_identity), p_size) };
	info.token = gd::library;
	info.object_id = object_id;
	info.call_func = &call;
	info.is_valid_func = &is_valid;
	info.free_func = &free_bound;
	info.hash_func = &hash;
	info.equal_func = &equal;
	return Callable(info);
}

} // namespace godot::internal
