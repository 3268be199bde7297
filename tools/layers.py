#!/usr/bin/env python3
"""Checks the layers of the core, at every build: a folder includes only itself and lower ones."""

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
    "recognition",
    "haptics",
    "metrics",
    "simulation",
]

# Headers for files, clocks and threads. Only the nodes use them, not the core.
FOREIGN = {"chrono", "ctime", "filesystem", "fstream", "iostream", "thread"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def violations(core: Path) -> list[str]:
    """A line for each include that breaks the order, with its file and the reason."""
    found = []
    for source in sorted([*core.rglob("*.h"), *core.rglob("*.cpp")]):
        place = source.relative_to(core)
        layer = place.parts[0]
        if layer not in LAYERS:
            found.append(f"{source}: '{layer}' is not a layer of the core; add it to LAYERS in tools/layers.py")
            continue
        for bracket, name in INCLUDE.findall(source.read_text()):
            target = name.split("/")[0]
            if bracket == "<":
                if name in FOREIGN or target == "godot_cpp":
                    found.append(f"{source}: the core must not include <{name}>; use it in extension/nodes/")
            elif target not in LAYERS or "/" not in name:
                found.append(f'{source}: "{name}" must be relative to extension/core')
            elif LAYERS.index(target) > LAYERS.index(layer):
                found.append(f'{source}: layer {layer} must not include "{name}": {target} is a higher layer')
    return found


if __name__ == "__main__":
    broken = violations(Path(sys.argv[1]))
    print("\n".join(broken))
    sys.exit(1 if broken else 0)
