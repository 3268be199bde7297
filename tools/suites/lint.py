"""Format, lint and layout checks. Each check is one test."""

import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from conditions import TITLES
from gesture_end import END_LEVEL
from suites import clang_tidy, clean
from suites.check import check
from suites.outcome import Outcome
from suites.process import ROOT, run

PRODUCTS = {".git", "build", ".godot", "bin", "__pycache__"}
SHIPS = ROOT / "extension"
VENV = Path(sys.executable).parent


def outcomes() -> Iterator[Outcome]:
    cpp, headers, gd, python = files(".cpp"), files(".h", ".hpp"), files(".gd"), files(".py")
    shell = [ROOT / "steadyhand", ROOT / ".ci/run", *files(".sh")]
    yield one_version()
    yield one_end()
    yield same_conditions()
    yield tests_of_page("docs/numerics.md")
    yield check("layer order", [sys.executable, "tools/layers.py", "extension/core"])
    yield check("clang-format", ["clang-format", "--dry-run", "-Werror", *cpp, *headers])
    yield of_changed("gdformat", gd, "--check")
    yield of_changed("gdlint", gd)
    yield check("shellcheck", ["shellcheck", "-x", *shell])
    yield check("ruff check", [VENV / "ruff", "check", "--no-cache", *python, "SConstruct"])
    yield check("ruff format", [VENV / "ruff", "format", "--check", "--no-cache", *python, "SConstruct"])
    yield from clang_tidy.outcomes([source for source in cpp if SHIPS in source.parents], files(".clang-tidy"))


def of_changed(tool: str, sources: list[Path], *options: str) -> Outcome:
    """Checks the sources that have changed since the tool last found them clean."""
    version = run([VENV / tool, "--version"])[1]
    key = {source: clean.key_of(tool, version, source.read_bytes()) for source in sources}
    changed = [source for source in sources if not clean.is_clean(key[source])]
    found = check(tool, [VENV / tool, *options, *changed]) if changed else Outcome.of(f"lint/{tool}", True)
    if found.passed:
        clean.keep(key.values())
    return found


def one_version() -> Outcome:
    """plugin.cfg has a copy of the version."""
    wanted = re.search(r'VERSION = "([^"]+)"', (ROOT / "extension/core/base/version.h").read_text())
    found = re.search(r'^version="([^"]+)"', (ROOT / "demo_project/addons/steadyhand/plugin.cfg").read_text(), re.M)
    good = wanted is not None and found is not None and wanted[1] == found[1]
    return Outcome.of("lint/plugin.cfg has the version of version.h", good, f"{wanted} {found}")


def same_conditions() -> Outcome:
    """The demo has a copy of the names."""
    text = (ROOT / "demo_project/scripts/conditions.gd").read_text()
    names, titles = (
        re.findall(r'"([^"]+)"', found[1]) if (found := re.search(rf"const {name}.*?= \[(.*?)\]", text, re.S)) else []
        for name in ("NAMES", "TITLES")
    )
    good = dict(zip(names, titles, strict=False)) == TITLES
    return Outcome.of("lint/conditions.gd has the names of conditions.py", good, f"{names} {titles}")


def one_end() -> Outcome:
    """Tools that evaluate curves have a copy of the level."""
    wanted = re.search(r"END_LEVEL = ([\d.]+);", (ROOT / "extension/core/gesture/task.h").read_text())
    good = wanted is not None and float(wanted[1]) == END_LEVEL
    return Outcome.of("lint/gesture_end.py has the level of task.h", good, f"{wanted} {END_LEVEL}")


def tests_of_page(page: str) -> Outcome:
    """Each row of the table ends with `file`: and the begin of a test's name."""
    rows = [line for line in (ROOT / page).read_text().splitlines() if line.startswith("| ")]
    gone = []
    for row in rows:
        if row in ("| what holds | test |", "| --- | --- |"):
            continue
        named = re.search(r"\| `(\S+\.(?:cpp|gd))`: (.+?) \|$", row)
        path = ROOT / "tests" / named[1] if named else None
        text = re.sub(r'"\s*"', "", path.read_text()) if path and path.exists() else ""  # long literals are in parts
        wanted = [f"func {named[2]}(", f'"{named[2]}'] if named else []
        gone += [] if any(one in text for one in wanted) else [row]
    return Outcome.of(f"lint/each test that {page} names exists", len(rows) > 0 and not gone, "\n".join(gone))


def files(*endings: str) -> list[Path]:
    """The repo's own files with these endings; build products and generated code are left out."""
    found = []
    for folder, subfolders, names in os.walk(ROOT):
        subfolders[:] = sorted(set(subfolders) - PRODUCTS)
        found += [Path(folder, name) for name in sorted(names) if name.endswith(endings)]
    return found
