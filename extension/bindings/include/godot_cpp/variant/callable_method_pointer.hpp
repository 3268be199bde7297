// callable_mp(object, &Class::method): a Callable of a method that scripts do not see.
#pragma once

#include <godot_cpp/core/method_bind.hpp>

#include <memory>

namespace godot {

namespace internal {

// p_identity, p_size: the bytes of the method's pointer; Callables of the same method of one object are
// equal.
Callable make_callable(
		Object *p_object, std::unique_ptr<MethodBind> p_method, const void *p_identity, size_t p_size);

} // namespace internal

template <typename T, typename F> Callable callable_mp(T *p_object, F p_function) {
	return internal::make_callable(p_object, std::make_unique<internal::FunctionBind<F>>(p_function),
			&p_function, sizeof(p_function));
}

} // namespace godot
