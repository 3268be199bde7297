"""The add-on for the other platforms: Linux on arm64 under qemu-user, Windows on x86-64 under wine.

The core's unit tests run there, without the suite "figures", whose code is covered by the others. A program with a
stub of an engine loads the Windows library, because there is no Windows Godot.
"""

import os
import re
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from dist import addon
from suites import dist
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

TESTS = {"linux.arm64": "unit_tests", "windows.x86_64": "unit_tests.exe"}
ARM64 = ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"]
WINE = "/usr/lib/wine/wine64"
OF_WINDOWS = {"KERNEL32.dll", "msvcrt.dll", "USER32.dll"}  # parts of each Windows
ADDON_BIN = addon.ADDON / "bin"
PARTS_A_CORE = 4  # some cases take a hundred times as long as others
GLIBC = (2, 36)  # that of Debian 12
SET_UP_S = 600
BUILD_S = 3600
KILL_S = 1800


def outcomes() -> Iterator[Outcome]:
    status, output = run([ROOT / "tools/setup_debian.sh", "dist", "platforms"], kill_s=SET_UP_S)
    if status != 0:
        yield Outcome.of("platforms/cross-compilers and emulators are installed", False, output)
        return
    with tempfile.TemporaryDirectory(prefix="steadyhand_platforms") as name:
        folder = Path(name)
        wine = {"WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all", "DISPLAY": ""}
        status, output = run(["./steadyhand", "dist", "--out", folder], kill_s=BUILD_S)
        path = folder / f"steadyhand-{addon.version()}.zip"
        yield Outcome.of("platforms/the zip is written", status == 0 and path.is_file(), output)
        if status == 0:
            yield from dist.contents(path, ",".join(addon.STRIP))
            yield from needs()
            yield from loaded(folder, wine)
        yield from unit_tests("linux.arm64", ARM64, {})
        yield from unit_tests("windows.x86_64", [WINE], wine)


def needs() -> Iterator[Outcome]:
    """Requirements of a library for its system."""
    for target in addon.TARGETS:
        windows = ADDON_BIN / f"libsteadyhand.windows.{target}.x86_64.dll"
        _, output = run(["x86_64-w64-mingw32-objdump", "-p", windows])
        needed = set(re.findall(r"DLL Name: (\S+)", output))
        good = bool(needed) and needed <= OF_WINDOWS
        yield Outcome.of(f"platforms/Windows, {target}: no DLL but the system's", good, f"{sorted(needed)}")
        for arch in ("x86_64", "arm64"):
            linux = ADDON_BIN / f"libsteadyhand.linux.{target}.{arch}.so"
            _, output = run(["readelf", "--version-info", "--wide", linux])
            versions = {tuple(map(int, found.split("."))) for found in re.findall(r"GLIBC_([\d.]+)", output)}
            good = bool(versions) and max(versions) <= GLIBC
            yield Outcome.of(f"platforms/Linux {arch}, {target}: glibc of Debian 12", good, f"{sorted(versions)}")


def loaded(folder: Path, wine: dict[str, str]) -> Iterator[Outcome]:
    program = folder / "load_library.exe"
    command = ["x86_64-w64-mingw32-gcc-posix", "-o", program, ROOT / "tests/dist/load_library.c"]
    status, output = run(command)
    if status != 0:
        yield Outcome.of("platforms/load_library.c compiles", False, output)
        return
    for target in addon.TARGETS:
        library = ADDON_BIN / f"libsteadyhand.windows.{target}.x86_64.dll"
        status, output = run([WINE, program, f"Z:{library}"], kill_s=120, **wine)
        yield Outcome.of(f"platforms/Windows, {target}: the library loads", status == 0, output)


def unit_tests(one: str, emulator: list[str], environment: dict[str, str]) -> Iterator[Outcome]:
    platform, arch = one.split(".")
    status, output = scons(f"platform={platform}", f"arch={arch}", "tests")
    if status != 0:
        yield Outcome.of(f"platforms/{one}: the unit tests build", False, output)
        return
    program = [*emulator, ROOT / f"build/template_debug.{one}" / TESTS[one], "--test-suite-exclude=figures"]
    status, output = run([*program, "--count"], **environment)
    total = re.search(r"(\d+)\s*$", output)
    if status != 0 or total is None:
        yield Outcome.of(f"platforms/{one}: the unit tests start", False, output)
        return
    count, cores = int(total[1]), len(os.sched_getaffinity(0))
    size = -(-count // (PARTS_A_CORE * cores))
    parts = [range(first, min(first + size, count + 1)) for first in range(1, count + 1, size)]
    with ThreadPoolExecutor(cores) as pool:
        yield from pool.map(partial(run_part, one, program, environment), parts)


def run_part(one: str, program: list, environment: dict[str, str], cases: range) -> Outcome:
    """These cases, counted from 1. doctest says how many of them fail, but counts the others as passed."""
    part = [f"--first={cases[0]}", f"--last={cases[-1]}", "--no-colors"]
    status, output = run([*program, *part], kill_s=KILL_S, **environment)
    found = re.search(r"test cases: +\d+ \| +\d+ passed \| +(\d+) failed", output)
    failed = int(found[1]) if found else len(cases)
    if status != 0 and failed == 0:
        failed, output = 1, f"{output}\nexit status {status}"
    return Outcome(f"platforms/{one}: unit tests from {cases[0]}", len(cases) - failed, failed, output=output)
