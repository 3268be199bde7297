"""compatibility_minimum: the compiled-in API is the same in each Godot from that version to the newest.

The library is built for one of these versions and loaded in another: methods have a hash, builtin types a size, enums
values. The crate gdextension-api has the engine's own description of each version.
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

BINDINGS = ROOT / "extension/bindings"
CALLED = BINDINGS / "include/godot_cpp/core/gdextension_interface_loader.hpp"
ADDON = ROOT / "demo_project/addons/steadyhand/steadyhand.gdextension"
SET_UP_S = 600

sys.path.insert(0, str(BINDINGS))
from api import by_name  # noqa: E402
from generate import read_manifest  # noqa: E402


def outcomes() -> Iterator[Outcome]:
    status, output = run([ROOT / "tools/setup_engine_api.sh"], kill_s=SET_UP_S)
    if status != 0:
        yield Outcome(f"dist: {output.strip().splitlines()[-1]}", skipped=1)
        return
    folder = Path(output.splitlines()[-1])
    minimum = number(re.search(r'compatibility_minimum = "([^"]+)"', ADDON.read_text())[1])
    manifest = read_manifest(BINDINGS / "manifest.txt")
    found = {number(path.parent.name): path for path in folder.glob("4.*/extension_api.json")}
    versions = sorted(version for version in found if version >= minimum)
    if minimum not in versions or len(versions) < 2:
        yield Outcome.of("dist/the minimum's API and a newer one are there", False, str(sorted(found)))
        return
    used = {version: Used(manifest, json.loads(found[version].read_text())) for version in versions}
    for version in versions:
        faults = [fault for built in versions for fault in used[version].differences(used[built], named(built))]
        yield Outcome.of(f"dist/Godot {named(version)} has all that the library uses", not faults, "\n".join(faults))
    interface = json.loads((folder / "gdextension_interface.json").read_text())["interface"]
    since = {row["name"]: number(row["since"]) for row in interface}
    functions = re.findall(r"X\((\w+), \w+\)", CALLED.read_text())
    newer = [name for name in functions if since.get(name, (99, 0)) > minimum]
    good = bool(functions) and not newer
    yield Outcome.of(f"dist/Godot {named(minimum)} has the C functions that are called", good, "\n".join(newer))


def number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def named(version: tuple[int, ...]) -> str:
    return ".".join(str(part) for part in version)


class Used:
    """The parts of one version's API that the bindings compile in."""

    def __init__(self, manifest: dict, data: dict) -> None:
        self.facts: dict[str, object] = {}
        self.names: dict[str, int] = {}  # constants and values of enums: new ones come with each version
        self.older: dict[str, list[int]] = {}  # hashes that this version still serves
        singletons = {row["name"] for row in data["singletons"]}
        classes = by_name(data["classes"])
        for name, wanted in manifest["class"].items():
            self.add_class(name, wanted, classes.get(name), name in singletons)
        builtins = by_name(data["builtin_classes"])
        for name, wanted in manifest["builtin"].items():
            methods = by_name(builtins[name].get("methods", []))
            for method in wanted:
                self.facts[f"{name}.{method}"] = methods.get(method, {}).get("hash")
            for row in builtins[name]["constructors"]:
                types = tuple(argument["type"] for argument in row.get("arguments", []))
                self.facts[f"constructor {row['index']} of {name}"] = types
        functions, structs = by_name(data["utility_functions"]), by_name(data["native_structures"])
        self.facts |= {name: functions.get(name, {}).get("hash") for name in manifest["utilities"]}
        self.facts |= {name: structs.get(name, {}).get("format") for name in manifest["structs"]}
        self.add_enums("", [row for row in data["global_enums"] if row["name"] in manifest["enums"]])
        sizes = next(
            table["sizes"] for table in data["builtin_class_sizes"] if table["build_configuration"] == "float_64"
        )
        self.facts |= {f"size of {row['name']}": row["size"] for row in sizes}

    def add_class(self, name: str, wanted: list[str], row: dict | None, is_singleton: bool) -> None:
        row = row or {}
        self.facts[name] = (row.get("inherits"), row.get("is_refcounted"), is_singleton)
        methods = by_name(row.get("methods", []))
        for method in wanted:
            found = methods.get(method, {})
            key = f"{name}.{method}"
            self.facts[key] = found.get("hash")
            self.facts[f"kind of {key}"] = (found.get("is_vararg"), found.get("is_static"), found.get("is_virtual"))
            self.older[key] = found.get("hash_compatibility", [])
        self.add_enums(f"{name}.", row.get("enums", []))
        self.names |= {f"{name}.{constant['name']}": constant["value"] for constant in row.get("constants", [])}

    def add_enums(self, prefix: str, enums: list[dict]) -> None:
        for enum in enums:
            self.names |= {f"{prefix}{value['name']}": value["value"] for value in enum["values"]}

    def differences(self, built: "Used", version: str) -> Iterator[str]:
        """Differences for a library that was built for another version."""
        for key, value in built.facts.items():
            here = self.facts.get(key)
            if value is None or (value != here and value not in self.older.get(key, [])):
                yield f"{key}: {here} here, {value} in {version}, for which the library may be built"
        for key, value in built.names.items():
            counts = key.endswith("_MAX")  # the number of values
            if not counts and self.names.get(key, value) != value:
                yield f"{key}: {self.names[key]} here, {value} in {version}"
