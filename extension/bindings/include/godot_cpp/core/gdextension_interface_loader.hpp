// The engine's C functions that the bindings call, one row each: the name to ask the engine for and the end
// of its type in gdextension_interface.h. All of them exist in Godot 4.4, the oldest engine that the add-on
// loads in; a function newer than that needs a fallback and does not belong in this list.
#pragma once

#include <gdextension_interface.h>

#define GODOT_CPP_INTERFACE(X)                                                                               \
	X(print_error, PrintError)                                                                               \
	X(print_error_with_message, PrintErrorWithMessage)                                                       \
	X(print_warning, PrintWarning)                                                                           \
	X(variant_new_copy, VariantNewCopy)                                                                      \
	X(variant_new_nil, VariantNewNil)                                                                        \
	X(variant_destroy, VariantDestroy)                                                                       \
	X(variant_evaluate, VariantEvaluate)                                                                     \
	X(variant_booleanize, VariantBooleanize)                                                                 \
	X(variant_stringify, VariantStringify)                                                                   \
	X(variant_get_type, VariantGetType)                                                                      \
	X(variant_get_type_name, VariantGetTypeName)                                                             \
	X(variant_get_object_instance_id, VariantGetObjectInstanceId)                                            \
	X(variant_can_convert_strict, VariantCanConvertStrict)                                                   \
	X(variant_get_ptr_constructor, VariantGetPtrConstructor)                                                 \
	X(variant_get_ptr_destructor, VariantGetPtrDestructor)                                                   \
	X(variant_get_ptr_builtin_method, VariantGetPtrBuiltinMethod)                                            \
	X(variant_get_ptr_operator_evaluator, VariantGetPtrOperatorEvaluator)                                    \
	X(variant_get_ptr_utility_function, VariantGetPtrUtilityFunction)                                        \
	X(get_variant_from_type_constructor, GetVariantFromTypeConstructor)                                      \
	X(get_variant_to_type_constructor, GetVariantToTypeConstructor)                                          \
	X(string_new_with_latin1_chars, StringNewWithLatin1Chars)                                                \
	X(string_new_with_utf8_chars_and_len, StringNewWithUtf8CharsAndLen)                                      \
	X(string_to_utf8_chars, StringToUtf8Chars)                                                               \
	X(string_operator_index_const, StringOperatorIndexConst)                                                 \
	X(string_operator_plus_eq_string, StringOperatorPlusEqString)                                            \
	X(string_name_new_with_latin1_chars, StringNameNewWithLatin1Chars)                                       \
	X(array_operator_index, ArrayOperatorIndex)                                                              \
	X(array_operator_index_const, ArrayOperatorIndexConst)                                                   \
	X(array_set_typed, ArraySetTyped)                                                                        \
	X(dictionary_operator_index, DictionaryOperatorIndex)                                                    \
	X(dictionary_operator_index_const, DictionaryOperatorIndexConst)                                         \
	X(packed_byte_array_operator_index, PackedByteArrayOperatorIndex)                                        \
	X(packed_byte_array_operator_index_const, PackedByteArrayOperatorIndexConst)                             \
	X(packed_int32_array_operator_index, PackedInt32ArrayOperatorIndex)                                      \
	X(packed_int32_array_operator_index_const, PackedInt32ArrayOperatorIndexConst)                           \
	X(packed_int64_array_operator_index, PackedInt64ArrayOperatorIndex)                                      \
	X(packed_int64_array_operator_index_const, PackedInt64ArrayOperatorIndexConst)                           \
	X(packed_float32_array_operator_index, PackedFloat32ArrayOperatorIndex)                                  \
	X(packed_float32_array_operator_index_const, PackedFloat32ArrayOperatorIndexConst)                       \
	X(packed_float64_array_operator_index, PackedFloat64ArrayOperatorIndex)                                  \
	X(packed_float64_array_operator_index_const, PackedFloat64ArrayOperatorIndexConst)                       \
	X(packed_string_array_operator_index, PackedStringArrayOperatorIndex)                                    \
	X(packed_string_array_operator_index_const, PackedStringArrayOperatorIndexConst)                         \
	X(packed_vector2_array_operator_index, PackedVector2ArrayOperatorIndex)                                  \
	X(packed_vector2_array_operator_index_const, PackedVector2ArrayOperatorIndexConst)                       \
	X(packed_vector3_array_operator_index, PackedVector3ArrayOperatorIndex)                                  \
	X(packed_vector3_array_operator_index_const, PackedVector3ArrayOperatorIndexConst)                       \
	X(object_method_bind_call, ObjectMethodBindCall)                                                         \
	X(object_method_bind_ptrcall, ObjectMethodBindPtrcall)                                                   \
	X(object_destroy, ObjectDestroy)                                                                         \
	X(global_get_singleton, GlobalGetSingleton)                                                              \
	X(object_get_instance_binding, ObjectGetInstanceBinding)                                                 \
	X(object_set_instance_binding, ObjectSetInstanceBinding)                                                 \
	X(object_free_instance_binding, ObjectFreeInstanceBinding)                                               \
	X(object_set_instance, ObjectSetInstance)                                                                \
	X(object_get_class_name, ObjectGetClassName)                                                             \
	X(object_get_instance_from_id, ObjectGetInstanceFromId)                                                  \
	X(object_get_instance_id, ObjectGetInstanceId)                                                           \
	X(ref_get_object, RefGetObject)                                                                          \
	X(ref_set_object, RefSetObject)                                                                          \
	X(object_has_script_method, ObjectHasScriptMethod)                                                       \
	X(object_call_script_method, ObjectCallScriptMethod)                                                     \
	X(callable_custom_create2, CallableCustomCreate2)                                                        \
	X(classdb_construct_object2, ClassdbConstructObject2)                                                    \
	X(classdb_get_method_bind, ClassdbGetMethodBind)                                                         \
	X(classdb_register_extension_class4, ClassdbRegisterExtensionClass4)                                     \
	X(classdb_register_extension_class_method, ClassdbRegisterExtensionClassMethod)                          \
	X(classdb_register_extension_class_virtual_method, ClassdbRegisterExtensionClassVirtualMethod)           \
	X(classdb_register_extension_class_integer_constant, ClassdbRegisterExtensionClassIntegerConstant)       \
	X(classdb_register_extension_class_property, ClassdbRegisterExtensionClassProperty)                      \
	X(classdb_register_extension_class_property_group, ClassdbRegisterExtensionClassPropertyGroup)           \
	X(classdb_register_extension_class_property_subgroup, ClassdbRegisterExtensionClassPropertySubgroup)     \
	X(classdb_register_extension_class_signal, ClassdbRegisterExtensionClassSignal)                          \
	X(classdb_unregister_extension_class, ClassdbUnregisterExtensionClass)                                   \
	X(editor_help_load_xml_from_utf8_chars_and_len, EditorHelpLoadXml)

// In the headers of 4.4 to 4.6 the name of this type does not follow the rule.
using GDExtensionInterfaceEditorHelpLoadXml = void (*)(const char *p_text, GDExtensionInt p_size);

namespace godot::gdextension_interface {

#define GODOT_CPP_DECLARE(m_name, m_type) extern GDExtensionInterface##m_type m_name;
GODOT_CPP_INTERFACE(GODOT_CPP_DECLARE)
#undef GODOT_CPP_DECLARE

// Identifies this library in every registration and instance binding.
extern GDExtensionClassLibraryPtr library;

} // namespace godot::gdextension_interface
