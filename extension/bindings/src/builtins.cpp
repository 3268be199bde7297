#include <godot_cpp/core/engine_call.hpp>

#include <string>

namespace godot {

namespace gd = gdextension_interface;

String::String(const char *p_text) : Opaque(Uninitialized()) {
	gd::string_new_with_latin1_chars(_native_ptr(), p_text);
}
String::String(const StringName &p_name) : Opaque(Uninitialized()) {
	const GDExtensionConstTypePtr arguments[] = { p_name._native_ptr() };
	construct<2>(arguments);
}
String::String(const NodePath &p_path) : Opaque(Uninitialized()) {
	const GDExtensionConstTypePtr arguments[] = { p_path._native_ptr() };
	construct<3>(arguments);
}

String String::utf8(const char *p_text, int64_t p_length) {
	String text;
	text.destroy();
	gd::string_new_with_utf8_chars_and_len(text._native_ptr(), p_text, p_length);
	return text;
}

CharString String::utf8() const {
	const GDExtensionInt size = gd::string_to_utf8_chars(_native_ptr(), nullptr, 0);
	std::string bytes(size_t(size), '\0');
	gd::string_to_utf8_chars(_native_ptr(), bytes.data(), size);
	return CharString(std::move(bytes));
}

String &String::operator+=(const String &p_other) {
	gd::string_operator_plus_eq_string(_native_ptr(), p_other._native_ptr());
	return *this;
}

String String::operator+(const String &p_other) const {
	String sum = *this;
	sum += p_other;
	return sum;
}

String String::operator%(const Array &p_values) const {
	static const GDExtensionPtrOperatorEvaluator format = gd::variant_get_ptr_operator_evaluator(
			GDEXTENSION_VARIANT_OP_MODULE, GDEXTENSION_VARIANT_TYPE_STRING, GDEXTENSION_VARIANT_TYPE_ARRAY);
	String text;
	format(_native_ptr(), p_values._native_ptr(), text._native_ptr());
	return text;
}

char32_t String::operator[](int64_t p_index) const {
	return *gd::string_operator_index_const(_native_ptr(), p_index);
}

bool String::operator==(const String &p_other) const {
	static const GDExtensionPtrOperatorEvaluator equal = gd::variant_get_ptr_operator_evaluator(
			GDEXTENSION_VARIANT_OP_EQUAL, GDEXTENSION_VARIANT_TYPE_STRING, GDEXTENSION_VARIANT_TYPE_STRING);
	GDExtensionBool result = false;
	equal(_native_ptr(), p_other._native_ptr(), &result);
	return result;
}

bool String::operator<(const String &p_other) const {
	static const GDExtensionPtrOperatorEvaluator less = gd::variant_get_ptr_operator_evaluator(
			GDEXTENSION_VARIANT_OP_LESS, GDEXTENSION_VARIANT_TYPE_STRING, GDEXTENSION_VARIANT_TYPE_STRING);
	GDExtensionBool result = false;
	less(_native_ptr(), p_other._native_ptr(), &result);
	return result;
}

String itos(int64_t p_value) {
	return String(std::to_string(p_value).c_str());
}

StringName::StringName(const char *p_text) : Opaque(Uninitialized()) {
	constexpr GDExtensionBool IS_STATIC = false;
	gd::string_name_new_with_latin1_chars(_native_ptr(), p_text, IS_STATIC);
}
StringName::StringName(const String &p_text) : Opaque(Uninitialized()) {
	const GDExtensionConstTypePtr arguments[] = { p_text._native_ptr() };
	construct<2>(arguments);
}

NodePath::NodePath(const String &p_text) : Opaque(Uninitialized()) {
	const GDExtensionConstTypePtr arguments[] = { p_text._native_ptr() };
	construct<2>(arguments);
}

Array::Array(std::initializer_list<Variant> p_values) {
	for (const Variant &value : p_values) {
		push_back(value);
	}
}

Variant &Array::operator[](int64_t p_index) {
	return *static_cast<Variant *>(gd::array_operator_index(_native_ptr(), p_index));
}
const Variant &Array::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(gd::array_operator_index_const(_native_ptr(), p_index));
}
Variant *Array::begin() {
	return is_empty() ? nullptr : &(*this)[0];
}
Variant *Array::end() {
	return begin() + size();
}
const Variant *Array::begin() const {
	return is_empty() ? nullptr : &(*this)[0];
}
const Variant *Array::end() const {
	return begin() + size();
}

void Array::set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script) {
	gd::array_set_typed(_native_ptr(), GDExtensionVariantType(p_type), p_class_name._native_ptr(),
			p_script._native_ptr());
}

Variant &Dictionary::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(gd::dictionary_operator_index(_native_ptr(), p_key._native_ptr()));
}
const Variant &Dictionary::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(
			gd::dictionary_operator_index_const(_native_ptr(), p_key._native_ptr()));
}

Callable::Callable(Object *p_object, const StringName &p_method) : Opaque(Uninitialized()) {
	const PtrToArg<Object *>::Argument object(p_object);
	const GDExtensionConstTypePtr arguments[] = { object.ptr(), p_method._native_ptr() };
	construct<2>(arguments);
}
Callable::Callable(const GDExtensionCallableCustomInfo2 &p_custom) : Opaque(Uninitialized()) {
	GDExtensionCallableCustomInfo2 custom = p_custom;
	gd::callable_custom_create2(_native_ptr(), &custom);
}
bool Callable::operator==(const Callable &p_other) const {
	return Variant(*this) == Variant(p_other);
}

} // namespace godot
