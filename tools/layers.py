#!/usr/bin/env python3
"""The order of the core's layers, checked on every build: a folder includes only itself and lower ones."""

import re
import sys
from pathlib import Path

LAYERS = [
    "base",
    "signal",
    "hmm",
    "tracking",
    "devices",
    "gesture",
    "motion",
    "strokes",
    "recognition",
    "haptics",
    "metrics",
    "simulation",
]

# The core reads no file, knows no clock and no engine: those belong to the nodes.
FOREIGN = {"chrono", "ctime", "filesystem", "fstream", "iostream", "thread"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def violations(core: Path) -> list[str]:
    """One line for each include that breaks the order, with its file and the reason."""
    found = []
    for source in sorted([*core.rglob("*.h"), *core.rglob("*.cpp")]):
        place = source.relative_to(core)
        layer = place.parts[0]
        if layer not in LAYERS:
            found.append(f"{source}: '{layer}' is no layer of the core")
            continue
        for bracket, name in INCLUDE.findall(source.read_text()):
            target = name.split("/")[0]
            if bracket == "<":
                if name in FOREIGN or target == "godot_cpp":
                    found.append(f"{source}: <{name}> has no place in the core")
            elif target not in LAYERS or "/" not in name:
                found.append(f'{source}: "{name}" is not written from the core\'s root')
            elif LAYERS.index(target) > LAYERS.index(layer):
                found.append(f'{source}: layer {layer} may not include "{name}", {target} is above it')
    return found


if __name__ == "__main__":
    broken = violations(Path(sys.argv[1]))
    print("\n".join(broken))
    sys.exit(1 if broken else 0)
