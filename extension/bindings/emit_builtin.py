"""Builtin types: the methods of the hand-written classes, the packed arrays, sizes and the list of types."""

import re

from api import lookup, snake_case

# The element of each packed array, and the type that the engine's methods take for it.
ELEMENTS = {
    "PackedByteArray": "uint8_t",
    "PackedInt32Array": "int32_t",
    "PackedInt64Array": "int64_t",
    "PackedFloat32Array": "float",
    "PackedFloat64Array": "double",
    "PackedStringArray": "String",
    "PackedVector2Array": "Vector2",
    "PackedVector3Array": "Vector3",
}

PACKED_ARRAY = """#pragma once

#include <godot_cpp/variant/packed_array.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/variant_size.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {{

class {name}
	: public internal::PackedArray<{name}, {element}, GDEXTENSION_VARIANT_TYPE_{upper}, internal::{upper}_SIZE,
			gdextension_interface::{lower}_operator_index, gdextension_interface::{lower}_operator_index_const> {{
public:
	using PackedArray::PackedArray;

{methods}}};

}} // namespace godot
"""


def upper_name(name):
    """PackedFloat32Array -> PACKED_FLOAT32_ARRAY, Transform3D -> TRANSFORM3D, as the C interface spells them."""
    return snake_case(name).upper()


def result_type(api, method):
    return api.cpp_type({"type": method["return_type"]}) if "return_type" in method else "void"


def qualifiers(method):
    return ("static " if method["is_static"] else ""), (" const" if method["is_const"] else "")


# Variant is incomplete at these declarations, so the caller must pass a default of that type.
def parameters(api, method, defaults):
    return ", ".join(
        f"{api.cpp_argument(row)}p_{row['name']}{api.default(row) if defaults and row['type'] != 'Variant' else ''}"
        for row in method.get("arguments", [])
    )


def declaration(api, method):
    static, const = qualifiers(method)
    result = result_type(api, method)
    space = "" if result.endswith("*") else " "
    return f"\t{static}{result}{space}{method['name']}({parameters(api, method, True)}){const};\n"


def definition(api, builtin, method):
    _, const = qualifiers(method)
    result = result_type(api, method)
    space = "" if result.endswith("*") else " "
    types = ", ".join([result] + [api.cpp_type(row) for row in method.get("arguments", [])])
    base = "nullptr" if method["is_static"] else "_native_ptr()"
    values = ", ".join(["method", base] + [f"p_{row['name']}" for row in method.get("arguments", [])])
    return (
        f"{result}{space}{builtin}::{method['name']}({parameters(api, method, False)}){const} {{\n"
        "\tstatic const GDExtensionPtrBuiltInMethod method = internal::find_builtin_method(\n"
        f'\t\t\tGDEXTENSION_VARIANT_TYPE_{upper_name(builtin)}, "{method["name"]}", {method["hash"]});\n'
        f"\treturn internal::call_builtin<{types}>({values});\n}}\n"
    )


def emit_builtins(api, manifest):
    files = {}
    source = "#include <godot_cpp/core/engine_call.hpp>\n\nnamespace godot {\n\n"
    for name, wanted in manifest.items():
        table = {row["name"]: row for row in lookup(api.builtins, name, "the list of builtin types")["methods"]}
        methods = [lookup(table, method, name) for method in wanted]
        declarations = "".join(declaration(api, method) for method in methods)
        source += "".join(definition(api, name, method) for method in methods)
        lower = snake_case(name)
        if name in ELEMENTS:
            files[f"include/godot_cpp/variant/{lower}.hpp"] = PACKED_ARRAY.format(
                name=name, element=ELEMENTS[name], upper=upper_name(name), lower=lower, methods=declarations
            )
        else:
            files[f"include/godot_cpp/variant/{lower}_methods.inc"] = declarations
    sizes = "".join(
        f"inline constexpr size_t {upper_name(name)}_SIZE = {size};\n"
        for name, size in api.sizes.items()
        if size and re.match("[A-Z]", name)
    )
    files["include/godot_cpp/variant/variant_size.hpp"] = (
        "#pragma once\n\n#include <cstddef>\n\n"
        f"namespace godot::internal {{\n\n{sizes}\n}} // namespace godot::internal\n"
    )
    types = [(row["name"].removeprefix("TYPE_"), row["value"]) for row in api.enums["Variant.Type"]["values"]]
    files["include/godot_cpp/variant/variant_types.inc"] = "".join(
        f"\t\t{name} = {value},\n" for name, value in types if name != "MAX"
    )
    files["src/builtin_methods.cpp"] = source + "\n} // namespace godot\n"
    return files
