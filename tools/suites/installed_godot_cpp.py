"""`scons godot_cpp=PREFIX`: the nodes on an installed godot-cpp in place of the repo's own bindings.

$STEADYHAND_GODOT_CPP is the prefix of one, or a checkout that has been built (target=template_debug): the nodes are
built on it, and a scene test runs. Without it only the list of compiled files is checked.
"""

import os
import re
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites import scenes
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

GIVEN = "STEADYHAND_GODOT_CPP"
LIBRARY = "libgodot-cpp.linux.template_debug.x86_64.a"
SCENE = "gesture_hmm"


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_godot_cpp") as folder:
        yield from without_one(Path(folder))
    prefix = os.environ.get(GIVEN)
    if prefix:
        yield from with_one(Path(prefix).resolve())
    else:
        yield Outcome(f"command/scons godot_cpp=PREFIX: the nodes on it, ${GIVEN} is not set", skipped=1)


def without_one(prefix: Path) -> Iterator[Outcome]:
    status, output = run(["scons", "-Q", f"godot_cpp={prefix}"])
    good = status != 0 and f"no {LIBRARY} in {prefix}/lib or {prefix}/bin" in output
    yield Outcome.of("command/scons godot_cpp=PREFIX: a missing godot-cpp is an error", good, f"{status}\n{output}")
    (prefix / "lib").mkdir()
    (prefix / "lib" / LIBRARY).touch()
    status, output = run(["scons", "-Q", "-n", f"godot_cpp={prefix}"])
    compiled = re.findall(r"^  compile  (\S+)$", output, re.MULTILINE)
    joint = [ROOT / source for source in compiled if Path(source).name.startswith("unity_")]
    compiled += [
        source for path in joint for source in re.findall(r'^#include "(.+)"$', path.read_text(), re.MULTILINE)
    ]
    nodes = {str(path.relative_to(ROOT)) for path in (ROOT / "extension/nodes").glob("*.cpp")}
    own = [source for source in compiled if "bindings" in source]
    good = status == 0 and nodes <= set(compiled) and not own
    name = "command/scons godot_cpp=PREFIX: all nodes are compiled, but not the own bindings"
    yield Outcome.of(name, good, f"{status}, {own}\n{output}")


def with_one(prefix: Path) -> Iterator[Outcome]:
    status, output = scons(f"godot_cpp={prefix}")
    yield Outcome.of(f"command/scons godot_cpp=PREFIX: the nodes are built on it, {prefix}", status == 0, output)
    if status == 0:
        ran = scenes.run_script(os.environ["GODOT"], ROOT / f"tests/scenes/{SCENE}.gd")
        ran.name = f"command/scons godot_cpp=PREFIX: {ran.name}"
        yield ran
    status, output = scons()  # restores the add-on for the other tests
    yield Outcome.of("command/scons: on the own bindings again", status == 0, output)
