// A C++ function that the engine can call: with Variants (from scripts; checks arguments and adds defaults)
// or with typed pointers (from typed scripts and other extensions).
#pragma once

#include <godot_cpp/core/method_ptrcall.hpp>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace godot {

// D_METHOD("name", "first_argument", ...): the names that scripts and the class reference show.
struct MethodDefinition {
	StringName name;
	std::vector<StringName> arguments;
};

template <typename... Args> MethodDefinition D_METHOD(const StringName &p_name, const Args &...p_arguments) {
	return { p_name, { StringName(p_arguments)... } };
}

class MethodBind {
public:
	static constexpr size_t MAX_ARGUMENTS = 16;

	StringName name;
	std::vector<StringName> argument_names;
	std::vector<Variant> default_arguments; // of the last arguments
	uint32_t flags = GDEXTENSION_METHOD_FLAGS_DEFAULT;
	bool has_return = false;
	// For the result, then for the arguments.
	std::vector<PropertyInfo> signature;
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata;

	virtual ~MethodBind() = default;
	size_t argument_count() const { return signature.size() - 1; }

	// p_arguments: one for each argument of the method.
	virtual void call(Wrapped *p_instance, const Variant *const *p_arguments, Variant &r_ret,
			GDExtensionCallError &r_error) const = 0;
	virtual void ptrcall(Wrapped *p_instance, const GDExtensionConstTypePtr *p_arguments,
			GDExtensionTypePtr r_ret) const = 0;
};

namespace internal {

template <typename T> T from_variant(const Variant &p_value) {
	if constexpr (std::is_enum_v<T> || IS_BIT_FIELD<T>) {
		return static_cast<T>(p_value.operator int64_t());
	} else if constexpr (std::is_pointer_v<T>) {
		return Object::cast_to<std::remove_pointer_t<T>>(p_value.get_validated_object());
	} else if constexpr (IS_REF<T> || IS_TYPED_ARRAY<T>) {
		return T(p_value);
	} else {
		return p_value;
	}
}

template <typename T> Variant to_variant(const T &p_value) {
	if constexpr (std::is_enum_v<T> || IS_BIT_FIELD<T>) {
		return Variant(static_cast<int64_t>(p_value));
	} else if constexpr (IS_TYPED_ARRAY<T>) {
		return Variant(static_cast<const Array &>(p_value));
	} else {
		return Variant(p_value);
	}
}

// The class behind an object pointer or a Ref.
template <typename T> struct ClassBehind;
template <typename T> struct ClassBehind<T *> { using Type = std::remove_const_t<T>; };
template <typename T> struct ClassBehind<Ref<T>> { using Type = T; };
template <typename T> using ClassOf = typename ClassBehind<T>::Type;

// Whether the engine lets a script pass p_value for a T. An object must be null or a T.
template <typename T> bool accepts(const Variant &p_value) {
	if constexpr (std::is_same_v<T, Variant>) {
		return true;
	} else if constexpr (std::is_pointer_v<T> || IS_REF<T>) {
		Object *const object = p_value.get_validated_object();
		const bool is_object = p_value.get_type() == Variant::OBJECT || p_value.get_type() == Variant::NIL;
		return is_object && (object == nullptr || Object::cast_to<ClassOf<T>>(object) != nullptr);
	} else {
		static const GDExtensionVariantType wanted =
				GDExtensionVariantType(GetTypeInfo<T>::get_class_info().type);
		return gdextension_interface::variant_can_convert_strict(
				GDExtensionVariantType(p_value.get_type()), wanted);
	}
}

// F: the function's pointer type. The specialisations below split it.
template <typename F> struct FunctionOf;
template <typename T, typename R, typename... P> struct FunctionOf<R (T::*)(P...)> {
	using Instance = T;
	using Result = R;
	using Arguments = std::tuple<std::remove_cvref_t<P>...>;
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAGS_DEFAULT;
};
template <typename T, typename R, typename... P>
struct FunctionOf<R (T::*)(P...) const> : FunctionOf<R (T::*)(P...)> {
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAGS_DEFAULT | GDEXTENSION_METHOD_FLAG_CONST;
};
template <typename R, typename... P> struct FunctionOf<R (*)(P...)> {
	using Instance = void;
	using Result = R;
	using Arguments = std::tuple<std::remove_cvref_t<P>...>;
	static constexpr uint32_t FLAGS = GDEXTENSION_METHOD_FLAGS_DEFAULT | GDEXTENSION_METHOD_FLAG_STATIC;
};

// Calls F on an instance, or without one if it is static.
template <typename F, typename... Values>
decltype(auto) invoke(F p_function, Wrapped *p_instance, Values &&...p_values) {
	using Instance = typename FunctionOf<F>::Instance;
	if constexpr (std::is_void_v<Instance>) {
		return p_function(std::forward<Values>(p_values)...);
	} else {
		return (static_cast<Instance *>(p_instance)->*p_function)(std::forward<Values>(p_values)...);
	}
}

template <typename F>
void call_with_pointers(F p_function, Wrapped *p_instance,
		[[maybe_unused]] const GDExtensionConstTypePtr *p_arguments, [[maybe_unused]] void *r_ret) {
	using Result = std::remove_cvref_t<typename FunctionOf<F>::Result>;
	using Arguments = typename FunctionOf<F>::Arguments;
	[&]<size_t... I>(std::index_sequence<I...>) {
		if constexpr (std::is_void_v<Result>) {
			invoke(p_function, p_instance,
					PtrToArg<std::tuple_element_t<I, Arguments>>::convert(p_arguments[I])...);
		} else {
			PtrToArg<Result>::encode(
					invoke(p_function, p_instance,
							PtrToArg<std::tuple_element_t<I, Arguments>>::convert(p_arguments[I])...),
					r_ret);
		}
	}
	(std::make_index_sequence<std::tuple_size_v<Arguments>>());
}

template <typename F, typename Arguments = typename FunctionOf<F>::Arguments> class FunctionBind;

template <typename F, typename... Args> class FunctionBind<F, std::tuple<Args...>> final : public MethodBind {
	using Result = std::remove_cvref_t<typename FunctionOf<F>::Result>;
	static_assert(sizeof...(Args) <= MAX_ARGUMENTS);
	F function_;

	template <size_t... I>
	void call_with(Wrapped *p_instance, const Variant *const *p_arguments, Variant &r_ret,
			GDExtensionCallError &r_error, std::index_sequence<I...>) const {
		const std::array<bool, sizeof...(Args) + 1> accepted = { accepts<Args>(*p_arguments[I])..., true };
		for (size_t i = 0; i < sizeof...(Args); i++) {
			if (!accepted[i]) {
				r_error = { GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, int32_t(i),
					int32_t(signature[i + 1].type) };
				return;
			}
		}
		if constexpr (std::is_void_v<Result>) {
			invoke(function_, p_instance, from_variant<Args>(*p_arguments[I])...);
		} else {
			r_ret = to_variant<Result>(invoke(function_, p_instance, from_variant<Args>(*p_arguments[I])...));
		}
	}

public:
	explicit FunctionBind(F p_function) : function_(p_function) {
		flags = FunctionOf<F>::FLAGS;
		has_return = !std::is_void_v<Result>;
		signature = { GetTypeInfo<Result>::get_class_info(), GetTypeInfo<Args>::get_class_info()... };
		metadata = { GetTypeInfo<Result>::METADATA, GetTypeInfo<Args>::METADATA... };
	}
	void call(Wrapped *p_instance, const Variant *const *p_arguments, Variant &r_ret,
			GDExtensionCallError &r_error) const override {
		call_with(p_instance, p_arguments, r_ret, r_error, std::index_sequence_for<Args...>());
	}
	void ptrcall(Wrapped *p_instance, const GDExtensionConstTypePtr *p_arguments,
			GDExtensionTypePtr r_ret) const override {
		call_with_pointers(function_, p_instance, p_arguments, r_ret);
	}
};

} // namespace internal

} // namespace godot
