"""One header for each engine class, and one source with the bodies of all of them."""

from api import cpp_class, header_of

# ClassDB's header needs these two classes complete, so they are in one header that it includes. The headers
# with their names include that header and ClassDB. The headers of all other classes include ClassDB.
FOUNDATION = ("Object", "RefCounted")

CASTS = """	template <typename T> static T *cast_to(Object *p_object);
	template <typename T> static const T *cast_to(const Object *p_object);
"""


def emit_enum(enum):
    values = "".join(f"\t{value['name']} = {value['value']},\n" for value in enum["values"])
    return f"enum {enum['name']} {{\n{values}}};\n"


def indented(text):
    return "".join(f"\t{line}\n" for line in text.splitlines())


def spaced(cpp_type):
    return cpp_type if cpp_type.endswith("*") else cpp_type + " "


class Method:
    """The C++ of one row of a class's methods."""

    def __init__(self, api, class_name, row):
        self.api, self.class_name, self.row = api, class_name, row
        self.name = row["name"]
        self.arguments = row.get("arguments", [])
        self.result = api.cpp_type(row["return_value"]) if "return_value" in row else "void"
        self.const = " const" if row["is_const"] else ""

    def parameters(self, defaults=False):
        return ", ".join(
            f"{self.api.cpp_argument(row)}p_{row['name']}{self.api.default(row) if defaults else ''}"
            for row in self.arguments
        )

    def declaration(self):
        if self.row["is_vararg"]:
            return self._vararg_declaration()
        prefix = "virtual " if self.row["is_virtual"] else "static " if self.row["is_static"] else ""
        return f"\t{prefix}{spaced(self.result)}{self.name}({self.parameters(defaults=True)}){self.const};\n"

    def _vararg_declaration(self):
        own = "".join(f"Variant(p_{row['name']}), " for row in self.arguments)
        result = spaced(self.result)
        return (
            f"\ttemplate <typename... Args> {result}{self.name}({self.parameters()}, const Args &...p_arguments) {{\n"
            f"\t\tconst Variant arguments[] = {{ {own}Variant(p_arguments)... }};\n"
            f"\t\treturn _vararg_{self.name}(arguments, sizeof(arguments) / sizeof(Variant));\n\t}}\n"
            f"\t{result}_vararg_{self.name}(const Variant *p_arguments, size_t p_count);\n"
        )

    def definition(self):
        owner_class = cpp_class(self.class_name)
        if self.row["is_virtual"]:
            unnamed = ", ".join(self.api.cpp_argument(row).rstrip() for row in self.arguments)
            body = "" if self.result == "void" else f"\treturn {self.result}();\n"
            if self.result.endswith("*"):
                body = "\treturn nullptr;\n"
            return f"{spaced(self.result)}{owner_class}::{self.name}({unnamed}){self.const} {{\n{body}}}\n"
        lookup = (
            "\tstatic const GDExtensionMethodBindPtr method =\n"
            f'\t\t\tinternal::find_method("{self.class_name}", "{self.name}", {self.row["hash"]});\n'
        )
        if self.row["is_vararg"]:
            call = "internal::call_vararg(method, _owner, p_arguments, p_count)"
            call = call if self.result == "void" else f"return internal::from_variant<{self.result}>({call})"
            head = (
                f"{spaced(self.result)}{owner_class}::_vararg_{self.name}(const Variant *p_arguments, size_t p_count)"
            )
            return f"{head} {{\n{lookup}\t{call};\n}}\n"
        types = ", ".join([self.result] + [self.api.cpp_type(row) for row in self.arguments])
        owner = "nullptr" if self.row["is_static"] else "_owner"
        values = ", ".join(["method", owner] + [f"p_{row['name']}" for row in self.arguments])
        return (
            f"{spaced(self.result)}{owner_class}::{self.name}({self.parameters()}){self.const} {{\n"
            f"{lookup}\treturn internal::call_method<{types}>({values});\n}}\n"
        )

    def registration(self):
        return (
            f"\t\tif constexpr (!std::is_same_v<decltype(&B::{self.name}), decltype(&T::{self.name})>) {{\n"
            f'\t\t\tClassDB::bind_virtual_method(T::get_class_static(), "{self.name}",\n'
            f"\t\t\t\t\t&_call_virtual<&T::{self.name}>, {self.row['hash']});\n\t\t}}\n"
        )


def register_virtuals(parent, methods):
    rows = "".join(method.registration() for method in methods if method.row["is_virtual"])
    return (
        rows
        and "\nprotected:\n\ttemplate <typename T, typename B> static void register_virtuals() {\n"
        + f"\t\t{parent}::register_virtuals<T, B>();\n{rows}\t}}\n"
    )


def includes_of(api, name, parent, methods):
    """(headers, classes to declare)"""
    used = {class_ for method in methods for class_ in api.classes_of(method.row)} - {name, parent}
    rows = [row for method in methods for row in [*method.arguments, method.row.get("return_value")] if row]
    types = {row["type"] for row in rows}
    nested = {type_.split("::")[1].split(".")[0] for type_ in types if type_.startswith(("enum::", "bitfield::"))}
    complete = sorted(used & nested) + sorted({type_.rstrip("*") for type_ in types} & api.structs.keys())
    headers = [header_of(class_) for class_ in [parent] + complete]
    return headers + ["classes/ref.hpp", "core/class_db.hpp"], sorted(used - nested)


def class_text(api, name, methods):
    row = api.all_classes[name]
    cpp_name = cpp_class(name)
    parent = row.get("inherits", "Wrapped")
    public = "".join(indented(emit_enum(enum)) for enum in row.get("enums", []))
    public += "".join(f"\tstatic constexpr int {c['name']} = {c['value']};\n" for c in row.get("constants", []))
    public += f"\tstatic {cpp_name} *get_singleton();\n" if name in api.singletons else ""
    public += CASTS if name == "Object" else ""
    public += "".join(method.declaration() for method in methods)
    casts = "".join(f"VARIANT_ENUM_CAST({cpp_name}::{enum['name']})\n" for enum in row.get("enums", []))
    return (
        f"namespace godot {{\n\nclass {cpp_name} : public {parent} {{\n"
        f"\tGDEXTENSION_CLASS({cpp_name}, {name}, {parent})\n\npublic:\n{public}"
        f"{register_virtuals(parent, methods)}}};\n\n}} // namespace godot\n\n{casts}"
    )


def class_header(api, name):
    if name in FOUNDATION:
        return "#pragma once\n\n#include <godot_cpp/core/foundation.hpp>\n\n#include <godot_cpp/core/class_db.hpp>\n"
    methods = [Method(api, name, method) for method in api.classes[name]]
    headers, declared = includes_of(api, name, api.all_classes[name]["inherits"], methods)
    text = "#pragma once\n\n" + "".join(f"#include <godot_cpp/{header}>\n" for header in headers)
    if declared:
        text += (
            "\nnamespace godot {\n" + "".join(f"class {cpp_class(c)};\n" for c in declared) + "} // namespace godot\n"
        )
    return text + "\n" + class_text(api, name, methods)


def foundation(api):
    text = "#pragma once\n\n#include <godot_cpp/classes/wrapped.hpp>\n"
    for name in FOUNDATION:
        text += "\n" + class_text(api, name, [Method(api, name, method) for method in api.classes[name]])
    return text


def bodies(api):
    text = "".join(f"#include <godot_cpp/{header_of(name)}>\n" for name in api.classes)
    text += "#include <godot_cpp/core/engine_call.hpp>\n#include <godot_cpp/core/object_binding.hpp>\n"
    text += "\nnamespace godot {\n\n"
    for name, methods in api.classes.items():
        cpp_name = cpp_class(name)
        if name in api.singletons:
            text += f"{cpp_name} *{cpp_name}::get_singleton() {{\n"
            text += f"\treturn static_cast<{cpp_name} *>(internal::get_singleton(get_class_static()));\n}}\n"
        text += "".join(Method(api, name, method).definition() for method in methods)
    text += "\nvoid internal::register_engine_classes() {\n"
    for name in api.classes:
        cpp_name = cpp_class(name)
        text += f"\tregister_binding_callbacks({cpp_name}::get_class_static(), &{cpp_name}::_binding_callbacks);\n"
    return text + "}\n\n} // namespace godot\n"


def emit_classes(api):
    files = {f"include/godot_cpp/{header_of(name)}": class_header(api, name) for name in api.classes}
    files["include/godot_cpp/core/foundation.hpp"] = foundation(api)
    files["src/engine_classes.cpp"] = bodies(api)
    return files
