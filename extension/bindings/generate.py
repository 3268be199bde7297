#!/usr/bin/env python3
"""Writes the generated part of the bindings: python3 generate.py --api extension_api.json --out build/bindings

Makes OUT/include/godot_cpp/** and OUT/src/*.cpp of what manifest.txt lists. A name that the API lacks is an error.
"""

import argparse
import json
import re
from pathlib import Path

from api import Api, header_of, lookup
from emit_builtin import emit_builtins
from emit_class import emit_classes, emit_enum

HEADER = "#pragma once\n\n"


def read_manifest(path):
    """{"class": {name: [methods]}, "builtin": {...}, "enums": [...], "utilities": [...], "structs": [...]}"""
    manifest = {"class": {}, "builtin": {}, "enums": [], "utilities": [], "structs": []}
    rows = re.sub(r"\n[ \t]+", " ", path.read_text(encoding="utf-8")).splitlines()
    for text in (row for row in rows if row and not row.startswith("#")):
        row = re.fullmatch(r"(\w+)(?: (\w+))?:(.*)", text)
        if not row or row[1] not in manifest:
            raise SystemExit(f"{path}: not a row of the manifest: {text}")
        kind, name, words = row[1], row[2], row[3].split()
        if name:
            manifest[kind][name] = words
        else:
            manifest[kind] = words
    return manifest


def global_constants(api, names):
    enums = "\n".join(emit_enum(lookup(api.enums, name, "the list of global enums")) for name in names)
    casts = "".join(f"VARIANT_ENUM_CAST({name})\n" for name in names)
    include = "#include <godot_cpp/core/enum_cast.hpp>\n\n"
    return f"{HEADER}{include}namespace godot {{\n\n{enums}\n}} // namespace godot\n\n{casts}"


def native_struct(struct):
    fields = "".join(f"\t{field.strip()};\n" for field in struct["format"].split(";"))
    return HEADER + f"namespace godot {{\n\nstruct {struct['name']} {{\n{fields}}};\n\n}} // namespace godot\n"


UTILITY = """
	template <typename... Args> static void {name}(const Args &...p_arguments) {{
		static const GDExtensionPtrUtilityFunction function = internal::find_utility("{name}", {hash});
		const Variant arguments[] = {{ Variant(p_arguments)... }};
		internal::call_vararg_utility(function, arguments, sizeof...(Args));
	}}
"""


def utilities(api, names):
    """Global functions that take any number of arguments and return nothing."""
    rows = [lookup(api.utilities, name, "the list of functions") for name in names]
    functions = "".join(UTILITY.format(name=row["name"], hash=row["hash"]) for row in rows)
    include = "#include <godot_cpp/core/engine_call.hpp>\n\n"
    body = f"class UtilityFunctions {{\npublic:{functions}}};\n"
    return f"{HEADER}{include}namespace godot {{\n\n{body}\n}} // namespace godot\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--api", type=Path, required=True, help="the engine's extension_api.json")
    parser.add_argument("--out", type=Path, required=True, help="folder to write into")
    arguments = parser.parse_args()

    manifest = read_manifest(Path(__file__).with_name("manifest.txt"))
    api = Api(json.loads(arguments.api.read_text(encoding="utf-8")), manifest)

    files = {
        "include/godot_cpp/classes/global_constants.hpp": global_constants(api, manifest["enums"]),
        "include/godot_cpp/variant/utility_functions.hpp": utilities(api, manifest["utilities"]),
    }
    for name in manifest["structs"]:
        files[f"include/godot_cpp/{header_of(name)}"] = native_struct(
            lookup(api.structs, name, "the list of structures")
        )
    files.update(emit_builtins(api, manifest["builtin"]))
    files.update(emit_classes(api))

    for name, text in files.items():
        path = arguments.out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        # Not written if unchanged, so that a build by time stamps does not restart.
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
