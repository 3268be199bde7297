"""The engine's API JSON, looked up by name, and its types in C++."""

import re

NUMBERS = {"bool": "bool", "int": "int64_t", "float": "double"}

# godot-cpp renames these classes, because it uses their names itself.
RENAMED = {"ClassDB": "ClassDBSingleton"}


def cpp_class(name):
    return RENAMED.get(name, name)


def snake_case(name):
    """The file name of a class: AudioStreamWAV -> audio_stream_wav, Node3D -> node3d."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    return name.replace("2_D", "2D").replace("3_D", "3D").lower()


def header_of(name):
    """The header of a class or plain structure, below godot_cpp/."""
    return f"classes/{snake_case(cpp_class(name))}.hpp"


def by_name(rows):
    return {row["name"]: row for row in rows}


def lookup(table, name, where):
    if name not in table:
        raise SystemExit(f"manifest.txt: {where} has no {name} in this engine's API")
    return table[name]


class Api:
    def __init__(self, json_data, manifest):
        self.all_classes = by_name(json_data["classes"])
        self.builtins = by_name(json_data["builtin_classes"])
        self.enums = by_name(json_data["global_enums"])
        self.utilities = by_name(json_data["utility_functions"])
        self.structs = by_name(json_data["native_structures"])
        self.singletons = {row["name"] for row in json_data["singletons"]}
        sizes = by_name_of_configuration(json_data["builtin_class_sizes"])
        self.sizes = {row["name"]: row["size"] for row in sizes}
        self.classes = self._wanted_classes(manifest["class"])

    def _wanted_classes(self, rows):
        """{class: [method rows]} with the parents and the classes of signatures added; parents come first."""
        wanted = {}
        queue = list(rows)
        while queue:
            name = queue.pop()
            if name in wanted:
                continue
            row = lookup(self.all_classes, name, "the list of classes")
            methods = by_name(row.get("methods", []))
            wanted[name] = [lookup(methods, method, name) for method in rows.get(name, [])]
            queue += [row["inherits"]] if "inherits" in row else []
            queue += [type_ for method in wanted[name] for type_ in self.classes_of(method)]
        return dict(sorted(wanted.items(), key=lambda item: (self._depth(item[0]), item[0])))

    def _depth(self, name):
        parent = self.all_classes[name].get("inherits")
        return 1 + self._depth(parent) if parent else 0

    def classes_of(self, method):
        """The engine classes that a method's signature names."""
        types = [argument["type"] for argument in method.get("arguments", [])]
        types += [method["return_value"]["type"]] if "return_value" in method else []
        names = {re.split(r"::|\.", type_)[1] if "::" in type_ else type_ for type_ in types}
        return sorted(names & self.all_classes.keys())

    def cpp_type(self, row):
        """The C++ type of an argument or result, as it is returned or stored."""
        type_ = row["type"]
        meta = row.get("meta")
        if type_ in ("int", "float") and meta and meta != "required":
            return meta if type_ == "float" else f"{meta}_t"
        if type_ in NUMBERS:
            return NUMBERS[type_]
        kind, _, name = type_.partition("::")
        if kind == "enum":
            return name.replace(".", "::")
        if kind == "bitfield":
            return f"BitField<{name.replace('.', '::')}>"
        if kind == "typedarray":
            return f"TypedArray<{NUMBERS.get(name, name)}>"
        if type_ in self.all_classes:
            name = cpp_class(type_)
            return f"Ref<{name}>" if self.all_classes[type_]["is_refcounted"] else f"{name} *"
        return type_.replace("*", " *")

    def cpp_argument(self, row):
        """The C++ type of a parameter."""
        cpp = self.cpp_type(row)
        scalar = row["type"] in NUMBERS or row["type"].startswith(("enum::", "bitfield::")) or cpp.endswith("*")
        return f"{cpp} " if scalar and not cpp.endswith("*") else cpp if scalar else f"const {cpp} &"

    def default(self, row):
        """The C++ form of a default value; "" if there is none."""
        if "default_value" not in row:
            return ""
        text = row["default_value"]
        cpp = self.cpp_type(row)
        if row["type"].startswith(("enum::", "bitfield::")):
            text = f"{cpp}({text})"
        elif text in ("[]", "{}") or text.startswith("Array["):
            text = f"{cpp}()"
        elif text == "null":
            text = "Variant()" if cpp == "Variant" else "nullptr"
        return " = " + text.lstrip("&")


def by_name_of_configuration(tables):
    """Single precision, 64 bits, as the official builds."""
    return next(table["sizes"] for table in tables if table["build_configuration"] == "float_64")
