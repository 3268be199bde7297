#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/core/object.hpp>

#include <array>
#include <new>

namespace godot {

namespace gd = gdextension_interface;

namespace {

template <GDExtensionVariantType TYPE> void box(void *r_variant, const void *p_value) {
	static const GDExtensionVariantFromTypeConstructorFunc constructor =
			gd::get_variant_from_type_constructor(TYPE);
	constructor(r_variant, const_cast<void *>(p_value));
}

template <GDExtensionVariantType TYPE> void unbox(const Variant &p_variant, void *r_value) {
	static const GDExtensionTypeFromVariantConstructorFunc constructor =
			gd::get_variant_to_type_constructor(TYPE);
	constructor(r_value, p_variant._native_ptr());
}

// The engine constructs the value in raw memory, so T's own constructor must not run before.
template <GDExtensionVariantType TYPE, typename T> T unboxed(const Variant &p_variant) {
	union Slot {
		T value;
		Slot() {}
		~Slot() { value.~T(); }
	} slot;
	unbox<TYPE>(p_variant, &slot.value);
	return std::move(slot.value);
}

} // namespace

Variant::Variant() {
	gd::variant_new_nil(storage_);
}
Variant::Variant(GDExtensionConstVariantPtr p_native) {
	gd::variant_new_copy(storage_, p_native);
}
Variant::Variant(Variant &&p_other) noexcept : Variant() {
	std::swap(storage_, p_other.storage_);
}
Variant::~Variant() {
	gd::variant_destroy(storage_);
}

Variant &Variant::operator=(const Variant &p_other) {
	if (this != &p_other) {
		gd::variant_destroy(storage_);
		gd::variant_new_copy(storage_, p_other.storage_);
	}
	return *this;
}

Variant &Variant::operator=(Variant &&p_other) noexcept {
	std::swap(storage_, p_other.storage_);
	return *this;
}

Variant::Variant(bool p_value) {
	const GDExtensionBool value = p_value;
	box<GDEXTENSION_VARIANT_TYPE_BOOL>(storage_, &value);
}
Variant::Variant(int64_t p_value) {
	box<GDEXTENSION_VARIANT_TYPE_INT>(storage_, &p_value);
}
Variant::Variant(double p_value) {
	box<GDEXTENSION_VARIANT_TYPE_FLOAT>(storage_, &p_value);
}
Variant::Variant(const Object *p_object) {
	GodotObject *const owner = p_object ? p_object->_owner : nullptr;
	box<GDEXTENSION_VARIANT_TYPE_OBJECT>(storage_, &owner);
}

Variant::operator bool() const {
	return booleanize();
}
Variant::operator int64_t() const {
	return unboxed<GDEXTENSION_VARIANT_TYPE_INT, int64_t>(*this);
}
Variant::operator double() const {
	return unboxed<GDEXTENSION_VARIANT_TYPE_FLOAT, double>(*this);
}
Variant::operator Object *() const {
	GodotObject *owner = nullptr;
	unbox<GDEXTENSION_VARIANT_TYPE_OBJECT>(*this, &owner);
	return static_cast<Object *>(internal::get_instance_binding(owner));
}

#define GODOT_CPP_CONVERSIONS(m_type, m_name)                                                                \
	Variant::Variant(const m_type &p_value) {                                                                \
		static_assert(sizeof(m_type) == internal::m_name##_SIZE, "not the engine's layout");                 \
		box<GDEXTENSION_VARIANT_TYPE_##m_name>(storage_, &p_value);                                          \
	}                                                                                                        \
	Variant::operator m_type() const {                                                                       \
		return unboxed<GDEXTENSION_VARIANT_TYPE_##m_name, m_type>(*this);                                    \
	}
GODOT_CPP_BUILTINS(GODOT_CPP_CONVERSIONS)
#undef GODOT_CPP_CONVERSIONS

bool Variant::operator==(const Variant &p_other) const {
	Variant result;
	GDExtensionBool valid = false;
	gd::variant_evaluate(GDEXTENSION_VARIANT_OP_EQUAL, storage_, p_other.storage_, result.storage_, &valid);
	return valid && result.booleanize();
}

Variant::Type Variant::get_type() const {
	return Type(gd::variant_get_type(storage_));
}

Object *Variant::get_validated_object() const {
	return get_type() == OBJECT ? ObjectDB::get_instance(gd::variant_get_object_instance_id(storage_))
								: nullptr;
}

bool Variant::booleanize() const {
	return gd::variant_booleanize(storage_);
}

String Variant::stringify() const {
	String text;
	gd::variant_stringify(storage_, text._native_ptr());
	return text;
}

String Variant::get_type_name(Type p_type) {
	String name;
	gd::variant_get_type_name(GDExtensionVariantType(p_type), name._native_ptr());
	return name;
}

} // namespace godot
