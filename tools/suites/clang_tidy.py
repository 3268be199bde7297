"""clang-tidy on the shipped sources that have changed since they were last found clean.

Tests are not checked: they are compiled with all warnings as errors. Most of the time goes into headers, which the
sources of a folder share, so one generated source includes all sources of a folder to check. The sources of a folder
must not define the same name, even in an anonymous namespace.
"""

import itertools
import json
import os
import re
import shlex
import sys
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from suites import clean
from suites.check import check
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

PROGRAM = Path(sys.executable).parent / "clang-tidy"
TOGETHER = ROOT / "build/clang_tidy"
NAME = "UnifiedSource.cpp"  # the static analyzer expects this name of a source that includes sources
INCLUDE = re.compile(rb'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)


def outcomes(sources: list[Path], settings: list[Path]) -> Iterator[Outcome]:
    """One outcome for each folder."""
    status, output = scons("compiledb")
    if status != 0:
        yield Outcome.of("lint/clang-tidy", False, output)
        return
    commands = {entry["file"]: entry["command"] for entry in json.loads((ROOT / "compile_commands.json").read_text())}
    for path in settings:  # the settings of a folder apply to its generated source
        if path.parent != ROOT:
            write(TOGETHER / path.relative_to(ROOT), path.read_text())
    keys = Keys(settings)
    key = {source: keys.of(source, commands[str(source.relative_to(ROOT))]) for source in sources}
    folders = defaultdict(list)
    for source in sources:
        folders[source.parent.relative_to(ROOT)].append(source)
    changed = {folder: [one for one in inside if not clean.is_clean(key[one])] for folder, inside in folders.items()}
    entries = [as_compiled(TOGETHER / folder / NAME, inside[0], commands) for folder, inside in folders.items()]
    write(TOGETHER / "compile_commands.json", json.dumps(entries))

    def look(folder: Path) -> Outcome:
        if not changed[folder]:
            return Outcome.of(f"lint/clang-tidy {folder}", True)
        made = write(TOGETHER / folder / NAME, together(changed[folder]))
        found = check(f"clang-tidy {folder}", [PROGRAM, "--quiet", "-p", TOGETHER, made])
        if found.passed:
            clean.keep(key[source] for source in changed[folder])
        return found

    largest_first = sorted(folders, key=lambda folder: -len(changed[folder]))
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        yield from pool.map(look, largest_first)
    clean.keep(key[source] for source in sources if clean.is_clean(key[source]))


class Keys:
    """Hash of all that clang-tidy reads for a source, without the headers of other packages."""

    def __init__(self, settings: list[Path]) -> None:
        self.common = [run([PROGRAM, "--version"])[1], *(path.read_bytes() for path in [Path(__file__), *settings])]
        self.texts: dict[Path, bytes] = {}
        self.included: dict[tuple[Path, tuple[Path, ...]], list[Path]] = {}

    def of(self, source: Path, command: str) -> str:
        words = shlex.split(command)
        folders = [ROOT / word for flag, word in itertools.pairwise(words) if flag in ("-I", "-isystem")]
        folders += [ROOT / word[2:] for word in words if word.startswith("-I") and len(word) > 2]
        folders = tuple(folder for folder in dict.fromkeys(folders) if folder.is_relative_to(ROOT))
        read, waiting = {source}, [source]
        while waiting:
            for path in self.includes(waiting.pop(), folders):
                if path not in read:
                    read.add(path)
                    waiting.append(path)
        parts = [word for word in words if word.startswith(("-D", "-std", "-f"))]
        for path in sorted(read):
            parts += [str(path.relative_to(ROOT)), self.text(path)]
        return clean.key_of(*self.common, *parts)

    def includes(self, path: Path, folders: tuple[Path, ...]) -> list[Path]:
        if (path, folders) not in self.included:
            names = [name.decode() for name in INCLUDE.findall(self.text(path))]
            places = [[folder / name for folder in (path.parent, *folders)] for name in names]
            found = [next((place for place in several if place.is_file()), None) for several in places]
            self.included[path, folders] = [Path(os.path.normpath(one)) for one in found if one is not None]
        return self.included[path, folders]

    def text(self, path: Path) -> bytes:
        if path not in self.texts:
            self.texts[path] = path.read_bytes()
        return self.texts[path]


def together(sources: list[Path]) -> str:
    """The text of a source that includes these."""
    return "".join(f'#include "{source}"\n' for source in sources)


def as_compiled(made: Path, source: Path, commands: dict[str, str]) -> dict:
    """The entry of compile_commands.json for the generated source of this source's folder."""
    name = str(source.relative_to(ROOT))
    command = commands[name].removesuffix(name) + shlex.quote(str(made))
    return {"directory": str(ROOT), "file": str(made), "command": command}


def write(path: Path, text: str) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    return path
