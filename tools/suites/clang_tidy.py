"""clang-tidy, a folder at a time: most of what it does is to read headers, and the sources of a folder read the same.

What ships is looked at; tests are compiled with all warnings as errors, and their runs show the rest. A folder's
sources are included by one that is made here. The sources of a folder that is not clean, or in which two define the
same name, are looked at one by one.
"""

import hashlib
import json
import os
import shlex
import sys
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from suites.check import check
from suites.outcome import Outcome
from suites.process import ROOT, scons

PROGRAM = Path(sys.executable).parent / "clang-tidy"
TOGETHER = ROOT / "build/clang_tidy"
NAME = "UnifiedSource.cpp"  # by which the static analyzer knows that what is included is not a header


def outcomes(sources: list[Path], headers: list[Path], settings: list[Path]) -> Iterator[Outcome]:
    """One a folder, or a source of it. A folder is looked at again only when it, a header or a setting has changed."""
    status, output = scons("compiledb")
    if status != 0:
        yield Outcome.of("lint/clang-tidy", False, output)
        return
    commands = {entry["file"]: entry for entry in json.loads((ROOT / "compile_commands.json").read_text())}
    common = hashlib.sha256(b"".join(path.read_bytes() for path in [*headers, *settings]))
    for path in settings:  # what holds in a folder holds for the source that is made of it
        if path.parent != ROOT:
            write(TOGETHER / path.relative_to(ROOT), path.read_text())
    folders = defaultdict(list)
    for source in sources:
        folders[source.parent.relative_to(ROOT)].append(source)
    made = {folder: write(TOGETHER / folder / NAME, together(inside)) for folder, inside in folders.items()}
    entries = [as_compiled(made[folder], inside[0], commands) for folder, inside in folders.items()]
    write(TOGETHER / "compile_commands.json", json.dumps(entries))

    def look(folder: Path) -> list[Outcome]:
        key = common.copy()
        for source in folders[folder]:
            key.update(source.read_bytes())
        stamp = TOGETHER / f"{key.hexdigest()[:32]}.clean"
        if stamp.exists():
            return [Outcome.of(f"lint/clang-tidy {folder}", True)]
        found = [clang_tidy(folder, made[folder], TOGETHER)]
        if found[0].failed:
            found = [clang_tidy(source.relative_to(ROOT), source, ROOT) for source in folders[folder]]
        if not any(outcome.failed for outcome in found):
            stamp.touch()
        return found

    largest_first = sorted(folders, key=lambda folder: -len(folders[folder]))
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for found in pool.map(look, largest_first):
            yield from found


def together(sources: list[Path]) -> str:
    """The text of a source that includes these."""
    return "".join(f'#include "{source}"\n' for source in sources)


def as_compiled(made: Path, source: Path, commands: dict[str, dict]) -> dict:
    """The entry of compile_commands.json for what was made of a folder with this source."""
    name = str(source.relative_to(ROOT))
    command = commands[name]["command"].removesuffix(name) + shlex.quote(str(made))
    return {"directory": str(ROOT), "file": str(made), "command": command}


def clang_tidy(name: Path, source: Path, database: Path) -> Outcome:
    return check(f"clang-tidy {name}", [PROGRAM, "--quiet", "-p", database, source])


def write(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path
