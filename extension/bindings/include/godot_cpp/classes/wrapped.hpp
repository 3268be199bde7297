// The C++ half of an engine object, and what GDCLASS adds to a class of our own: its name, its registration,
// and the calls that the engine makes on objects of every class. Of those, `_notification` and
// `_validate_property` are dispatched; declaring another one (see GODOT_CPP_REFUSE) fails to compile.
#pragma once

#include <godot_cpp/core/cached_name.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/godot.hpp>

#include <type_traits>

namespace godot {

class ClassDB;
using GodotObject = void;

class Wrapped {
	friend class ClassDB;
	friend void internal::post_initialize(Wrapped *);

protected:
	// Class of the object that is being made. The base constructor below runs first and cannot know it
	// otherwise.
	struct Construction {
		const StringName *extension_class = nullptr; // null for engine classes
		const GDExtensionInstanceBindingCallbacks *callbacks = nullptr;
	};
	static Construction &_construction();

	// Also makes the engine's object.
	explicit Wrapped(const StringName &p_engine_class);
	// Wraps an object that the engine has made.
	explicit Wrapped(GodotObject *p_owner) : _owner(p_owner) {}
	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;
	virtual ~Wrapped() = default;

	static void _bind_methods() {}
	void _notification(int) {}
	void _validate_property(PropertyInfo &) const {}

	static constexpr auto _bind_methods_ptr() { return &Wrapped::_bind_methods; }
	static auto _notification_ptr() { return &Wrapped::_notification; }
	static auto _validate_property_ptr() { return &Wrapped::_validate_property; }
	static void _dispatch_notification(Wrapped *, int, bool) {}
	static bool _dispatch_validate_property(Wrapped *, PropertyInfo &) { return false; }

	template <typename T, typename B> static void register_virtuals() {}

public:
	GodotObject *_owner;
};

namespace internal {

// The C++ half of an engine object, which is made if there is none yet. It has the object's class, or the
// nearest ancestor that the bindings have. Null for null.
Wrapped *get_instance_binding(GodotObject *p_object);
Wrapped *get_singleton(const StringName &p_name);

// An object of our own class is its own C++ half. ClassDB::free_instance, which the engine calls, deletes it.
inline constexpr GDExtensionInstanceBindingCallbacks OWN_BINDING_CALLBACKS = {
	[](void *, void *) -> void * { return nullptr; },
	[](void *, void *, void *) {},
	[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },
};

} // namespace internal

} // namespace godot

#define GODOT_CPP_REFUSE(m_hook)                                                                             \
	static_assert(                                                                                           \
			!requires { &T_Self::m_hook; }, #m_hook " is not dispatched by these bindings")

// The type of a member function pointer shows whether the class itself declares the function.
#define GODOT_CPP_OVERRIDES(m_class, m_inherits, m_hook)                                                     \
	(!std::is_same_v<decltype(&m_class::m_hook), decltype(m_inherits::m_hook##_ptr())>)

#define GDCLASS(m_class, m_inherits)                                                                         \
	friend class ::godot::ClassDB;                                                                           \
	template <typename T_New> friend void ::godot::internal::pre_new();                                      \
                                                                                                             \
	static void _announce_construction() {                                                                   \
		m_class::_construction() = { &get_class_static(), &::godot::internal::OWN_BINDING_CALLBACKS };       \
	}                                                                                                        \
                                                                                                             \
protected:                                                                                                   \
	static constexpr auto _bind_methods_ptr() {                                                              \
		return &m_class::_bind_methods;                                                                      \
	}                                                                                                        \
	static auto _notification_ptr() {                                                                        \
		return &m_class::_notification;                                                                      \
	}                                                                                                        \
	static auto _validate_property_ptr() {                                                                   \
		return &m_class::_validate_property;                                                                 \
	}                                                                                                        \
                                                                                                             \
	static void _dispatch_notification(::godot::Wrapped *p_self, int p_what, bool p_reversed) {              \
		if (!p_reversed) {                                                                                   \
			m_inherits::_dispatch_notification(p_self, p_what, p_reversed);                                  \
		}                                                                                                    \
		if constexpr (GODOT_CPP_OVERRIDES(m_class, m_inherits, _notification)) {                             \
			static_cast<m_class *>(p_self)->_notification(p_what);                                           \
		}                                                                                                    \
		if (p_reversed) {                                                                                    \
			m_inherits::_dispatch_notification(p_self, p_what, p_reversed);                                  \
		}                                                                                                    \
	}                                                                                                        \
	static bool _dispatch_validate_property(::godot::Wrapped *p_self, ::godot::PropertyInfo &r_info) {       \
		const bool inherited = m_inherits::_dispatch_validate_property(p_self, r_info);                      \
		if constexpr (GODOT_CPP_OVERRIDES(m_class, m_inherits, _validate_property)) {                        \
			static_cast<m_class *>(p_self)->_validate_property(r_info);                                      \
			return true;                                                                                     \
		}                                                                                                    \
		return inherited;                                                                                    \
	}                                                                                                        \
	template <typename T_Self> static void _refuse_unsupported() {                                           \
		GODOT_CPP_REFUSE(_set);                                                                              \
		GODOT_CPP_REFUSE(_get);                                                                              \
		GODOT_CPP_REFUSE(_get_property_list);                                                                \
		GODOT_CPP_REFUSE(_property_can_revert);                                                              \
		GODOT_CPP_REFUSE(_property_get_revert);                                                              \
		GODOT_CPP_REFUSE(_to_string);                                                                        \
	}                                                                                                        \
                                                                                                             \
public:                                                                                                      \
	using self_type = m_class;                                                                               \
	using parent_type = m_inherits;                                                                          \
                                                                                                             \
	static const ::godot::StringName &get_class_static() {                                                   \
		static constinit ::godot::internal::CachedName name(#m_class);                                       \
		return name.get();                                                                                   \
	}                                                                                                        \
                                                                                                             \
private:

// For the classes of the engine, which the generator writes. m_name: the engine's name of the class.
#define GDEXTENSION_CLASS(m_class, m_name, m_inherits)                                                       \
	friend class ::godot::ClassDB;                                                                           \
	template <typename T_New> friend void ::godot::internal::pre_new();                                      \
                                                                                                             \
	static void _announce_construction() {                                                                   \
		_construction() = { nullptr, &_binding_callbacks };                                                  \
	}                                                                                                        \
                                                                                                             \
protected:                                                                                                   \
	explicit m_class(const StringName &p_engine_class) : m_inherits(p_engine_class) {}                       \
	explicit m_class(GodotObject *p_owner) : m_inherits(p_owner) {}                                          \
                                                                                                             \
public:                                                                                                      \
	using self_type = m_class;                                                                               \
	using parent_type = m_inherits;                                                                          \
                                                                                                             \
	m_class() : m_class(get_class_static()) {}                                                               \
                                                                                                             \
	static const StringName &get_class_static() {                                                            \
		static constinit internal::CachedName name(#m_name);                                                 \
		return name.get();                                                                                   \
	}                                                                                                        \
	static void *_create_binding(void *, void *p_owner) {                                                    \
		return static_cast<Wrapped *>(new m_class(static_cast<GodotObject *>(p_owner)));                     \
	}                                                                                                        \
	static void _free_binding(void *, void *, void *p_binding) {                                             \
		delete static_cast<m_class *>(static_cast<Wrapped *>(p_binding));                                    \
	}                                                                                                        \
	static constexpr GDExtensionInstanceBindingCallbacks _binding_callbacks = {                              \
		&_create_binding,                                                                                    \
		&_free_binding,                                                                                      \
		[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },                             \
	};                                                                                                       \
                                                                                                             \
private:
