// Calls into the engine, for the code that the generator writes.
#pragma once

#include <godot_cpp/core/method_ptrcall.hpp>

#include <array>

namespace godot::internal {

// Each returns null, with an error in the log, if this engine does not have the function with this signature.
GDExtensionMethodBindPtr find_method(const char *p_class, const char *p_method, int64_t p_hash);
GDExtensionPtrBuiltInMethod find_builtin_method(
		GDExtensionVariantType p_type, const char *p_method, int64_t p_hash);
GDExtensionPtrUtilityFunction find_utility(const char *p_function, int64_t p_hash);

// The argument list of one call; the values exist until the end of the full expression that makes it.
template <typename... Args> struct Arguments {
	std::array<GDExtensionConstTypePtr, sizeof...(Args) + 1> pointers; // + 1: never of size zero

	explicit Arguments(const typename PtrToArg<Args>::Argument &...p_arguments) :
			pointers{ p_arguments.ptr()..., nullptr } {}
};

// Args: the method's own, in order. p_owner is null for a static method.
template <typename R, typename... Args>
R call_method(GDExtensionMethodBindPtr p_method, GodotObject *p_owner, const Args &...p_arguments) {
	const auto call = [p_method, p_owner](void *r_ret, const Arguments<Args...> &p_list) {
		if (p_method != nullptr) {
			gdextension_interface::object_method_bind_ptrcall(
					p_method, p_owner, p_list.pointers.data(), r_ret);
		}
	};
	if constexpr (std::is_void_v<R>) {
		call(nullptr, Arguments<Args...>(typename PtrToArg<Args>::Argument(p_arguments)...));
	} else {
		typename PtrToArg<R>::Result result;
		call(result.ptr(), Arguments<Args...>(typename PtrToArg<Args>::Argument(p_arguments)...));
		return result.take();
	}
}

template <typename R, typename... Args>
R call_builtin(GDExtensionPtrBuiltInMethod p_method, GDExtensionTypePtr p_base, const Args &...p_arguments) {
	const auto call = [p_method, p_base](void *r_ret, const Arguments<Args...> &p_list) {
		if (p_method != nullptr) {
			p_method(p_base, p_list.pointers.data(), r_ret, int32_t(sizeof...(Args)));
		}
	};
	if constexpr (std::is_void_v<R>) {
		call(nullptr, Arguments<Args...>(typename PtrToArg<Args>::Argument(p_arguments)...));
	} else {
		typename PtrToArg<R>::Result result;
		call(result.ptr(), Arguments<Args...>(typename PtrToArg<Args>::Argument(p_arguments)...));
		return result.take();
	}
}

// A call with any number of arguments.
Variant call_vararg(
		GDExtensionMethodBindPtr p_method, GodotObject *p_owner, const Variant *p_arguments, size_t p_count);
void call_vararg_utility(
		GDExtensionPtrUtilityFunction p_function, const Variant *p_arguments, size_t p_count);

} // namespace godot::internal
