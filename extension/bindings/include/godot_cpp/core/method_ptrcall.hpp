// Values in the engine's untyped calls are pointers to the engine's form of the value. Each kind of type
// defines:
//   Argument  provides a value to the engine during a call: ptr();
//   Result    memory for the engine's result: ptr(), then take();
//   convert   reads a value from a pointer of the engine;
//   encode    writes a value to a pointer of the engine.
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/type_info.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <type_traits>

namespace godot {

namespace internal {

// Numbers: the engine passes every integer and enumerator as 64 bits and every real number as a double.
template <typename T, typename Raw> struct NumberPtrcall {
	struct Argument {
		Raw raw;
		explicit Argument(T p_value) : raw(static_cast<Raw>(p_value)) {}
		const void *ptr() const { return &raw; }
	};
	struct Result {
		Raw raw = {};
		void *ptr() { return &raw; }
		T take() { return static_cast<T>(raw); }
	};
	static T convert(const void *p_ptr) { return static_cast<T>(*static_cast<const Raw *>(p_ptr)); }
	static void encode(T p_value, void *r_ptr) { *static_cast<Raw *>(r_ptr) = static_cast<Raw>(p_value); }
};

// Builtin types and Variant, which already have the engine's form. Raw: the builtin under a TypedArray.
template <typename T, typename Raw = T> struct BuiltinPtrcall {
	struct Argument {
		const T &value;
		explicit Argument(const T &p_value) : value(p_value) {}
		const void *ptr() const { return &value; }
	};
	struct Result {
		Raw value;
		void *ptr() { return &value; }
		T take() { return std::move(value); }
	};
	static T convert(const void *p_ptr) { return *static_cast<const Raw *>(p_ptr); }
	static void encode(const T &p_value, void *r_ptr) { *static_cast<Raw *>(r_ptr) = p_value; }
};

struct ObjectArgument {
	GodotObject *owner;
	explicit ObjectArgument(const Wrapped *p_object) : owner(p_object ? p_object->_owner : nullptr) {}
	const void *ptr() const { return &owner; }
};

struct ObjectResult {
	GodotObject *owner = nullptr;
	void *ptr() { return &owner; }
};

template <typename T> struct ObjectPtrcall {
	using Argument = ObjectArgument;
	struct Result : ObjectResult {
		T *take() { return Object::cast_to<T>(static_cast<Object *>(get_instance_binding(owner))); }
	};
	static T *convert(const void *p_ptr) {
		GodotObject *const owner = p_ptr ? *static_cast<GodotObject *const *>(p_ptr) : nullptr;
		return Object::cast_to<std::remove_const_t<T>>(static_cast<Object *>(get_instance_binding(owner)));
	}
	static void encode(const T *p_value, void *r_ptr) {
		*static_cast<GodotObject **>(r_ptr) = ObjectArgument(p_value).owner;
	}
};

template <typename T> struct PointerPtrcall {
	struct Argument {
		T *pointer;
		explicit Argument(T *p_pointer) : pointer(p_pointer) {}
		const void *ptr() const { return &pointer; }
	};
	static T *convert(const void *p_ptr) { return *static_cast<T *const *>(p_ptr); }
};

template <typename T> auto ptrcall_of() {
	if constexpr (std::is_same_v<T, bool>) {
		return NumberPtrcall<T, GDExtensionBool>();
	} else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
		return NumberPtrcall<T, int64_t>();
	} else if constexpr (std::is_floating_point_v<T>) {
		return NumberPtrcall<T, double>();
	} else if constexpr (!std::is_pointer_v<T>) {
		return BuiltinPtrcall<T>();
	} else if constexpr (std::is_base_of_v<Object, std::remove_cv_t<std::remove_pointer_t<T>>>) {
		return ObjectPtrcall<std::remove_pointer_t<T>>();
	} else {
		return PointerPtrcall<std::remove_pointer_t<T>>();
	}
}

} // namespace internal

template <typename T> struct PtrToArg : decltype(internal::ptrcall_of<T>()) {};

template <typename T> struct PtrToArg<BitField<T>> : internal::NumberPtrcall<BitField<T>, int64_t> {};

template <typename T> struct PtrToArg<TypedArray<T>> : internal::BuiltinPtrcall<TypedArray<T>, Array> {};

template <typename T> struct PtrToArg<Ref<T>> {
	struct Argument : internal::ObjectArgument {
		explicit Argument(const Ref<T> &p_ref) : ObjectArgument(p_ref.ptr()) {}
	};
	struct Result : internal::ObjectResult {
		Ref<T> take() { return Ref<T>::_adopt(static_cast<T *>(internal::get_instance_binding(owner))); }
	};
	static Ref<T> convert(const void *p_ptr) {
		GodotObject *const owner = p_ptr ? gdextension_interface::ref_get_object(p_ptr) : nullptr;
		T *const object = Object::cast_to<T>(static_cast<Object *>(internal::get_instance_binding(owner)));
		return Ref<T>(object);
	}
	// The engine's memory has no reference yet.
	static void encode(const Ref<T> &p_ref, void *r_ptr) {
		if (p_ref.is_valid()) {
			gdextension_interface::ref_set_object(r_ptr, p_ref->_owner);
		}
	}
};

} // namespace godot
