// memnew and memdelete. An engine class is made in two halves, the engine's object and ours; memnew tells the
// constructor of Wrapped which class is being made before the object is allocated, and announces the finished
// object to the engine afterwards. Other types use plain new and delete.
#pragma once

#include <type_traits>
#include <utility>

namespace godot {

class Wrapped;

namespace internal {

void post_initialize(Wrapped *p_object);
void destroy_object(Wrapped *p_object);

template <typename T> void pre_new() {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		T::_announce_construction();
	}
}

template <typename T> T *post_new(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		post_initialize(p_object);
	}
	return p_object;
}

} // namespace internal

template <typename T> void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		internal::destroy_object(p_object);
	} else {
		delete p_object;
	}
}

} // namespace godot

#define memnew(m_class)                                                                                      \
	(::godot::internal::pre_new<std::remove_pointer_t<decltype(new m_class)>>(),                             \
			::godot::internal::post_new(new m_class))
