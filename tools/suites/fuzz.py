"""Fuzzing: libFuzzer runs each parser of the core under sanitizers, from the corpus in tests/fuzz/corpus.

Each target runs for 5 s; STEADYHAND_FUZZ_S sets another time. An input that fails stays in build/fuzz. Clones share the
compiled sources.
"""

import os
import re
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import caches
from suites import clean
from suites.outcome import Outcome
from suites.process import ROOT, run

CORE = ROOT / "extension/core"
TARGETS = ROOT / "tests/fuzz"
BUILD = ROOT / "build/fuzz"
OBJECTS = caches.folder() / "fuzz"
SANITIZERS = "address,undefined,float-cast-overflow"
COMPILER = "clang++"
COMPILE = [
    *[COMPILER, "-std=c++20", "-O1", "-g1", "-fno-omit-frame-pointer", "-ffp-contract=off", "-fno-math-errno"],
    *["-w", "-D_GLIBCXX_ASSERTIONS", "-DEIGEN_DONT_VECTORIZE"],
    *["-fno-sanitize-recover=all", f"-fsanitize=fuzzer-no-link,{SANITIZERS}", "-isystem", "/usr/include/eigen3"],
    *[f"-I{folder.relative_to(ROOT)}" for folder in (CORE, TARGETS)],
]
RUN = ["-timeout=5", "-rss_limit_mb=2048", "-print_final_stats=1"]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
RUNS = re.compile(r"^stat::number_of_executed_units:\s*(\d+)$", re.MULTILINE)


def outcomes() -> Iterator[Outcome]:
    targets = sorted(TARGETS.glob("fuzz_*.cpp"))
    if not targets:
        yield Outcome.of("fuzz: there are targets", False)
        return
    if shutil.which(COMPILER) is None:
        missing = "clang++ is missing: install the packages of tools/requirements/debian-test.txt"
        yield Outcome.of("fuzz: clang++ is installed", False, missing)
        return
    for folder in (BUILD, OBJECTS):
        folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        sources = sorted({source for target in targets for source in sources_of(target)})
        faults = dict(zip(sources, pool.map(compile_source, sources), strict=True))
        yield from pool.map(lambda target: outcome_of(target, faults), targets)
    caches.drop_old(OBJECTS.iterdir())


def outcome_of(target: Path, faults: dict[Path, str]) -> Outcome:
    name = f"fuzz/{target.stem.removeprefix('fuzz_')}"
    sources = sources_of(target)
    for source in sources:
        if faults[source]:
            return Outcome.of(f"{name} builds", False, faults[source])
    program = BUILD / target.stem
    objects = [object_of(source) for source in sources]
    status, output = run([COMPILER, f"-fsanitize=fuzzer,{SANITIZERS}", "-o", program, *objects])
    if status != 0:
        return Outcome.of(f"{name} builds", False, output)
    return fuzz(name, program)


def fuzz(name: str, program: Path) -> Outcome:
    """Runs it on a copy of the corpus, because libFuzzer adds inputs to its first folder."""
    seconds = float(os.environ.get("STEADYHAND_FUZZ_S", "5"))
    target = program.name.removeprefix("fuzz_")
    corpus = BUILD / f"{target}.corpus"
    shutil.rmtree(corpus, ignore_errors=True)
    shutil.copytree(TARGETS / "corpus" / target, corpus)
    for old in BUILD.glob(f"{target}-*"):
        old.unlink()
    options = [*RUN, f"-max_total_time={seconds:.0f}", f"-artifact_prefix={BUILD / target}-"]
    status, output = run([program, *options, corpus], kill_s=seconds + 120, UBSAN_OPTIONS="print_stacktrace=1")
    runs = RUNS.search(output)
    failing = [path.relative_to(ROOT) for path in sorted(BUILD.glob(f"{target}-*"))]
    good = status == 0 and runs is not None and int(runs[1]) > 0 and not failing
    where = "".join(f"\n-> failing input: {path}" for path in failing)
    return Outcome.of(name, good, f"exit status {status}\n{output[-8000:]}{where}")


def compile_source(source: Path) -> str:
    """Compiles the source if no clone has. Returns the compiler's output if it fails."""
    product = object_of(source)
    if product.exists():
        product.touch()
        return ""
    part = product.with_suffix(f".{os.getpid()}.part")
    status, output = run([*COMPILE, "-c", source.relative_to(ROOT), "-o", part])
    if status != 0:
        return f"{source.relative_to(ROOT)}: clang++ ends with {status}\n{output}"
    part.replace(product)
    return ""


@cache
def object_of(source: Path) -> Path:
    """Named by all that the compiler reads, without the headers of other packages."""
    read = sorted({source, *headers_of(source)})
    texts = [part for path in read for part in (str(path.relative_to(ROOT)), path.read_bytes())]
    return OBJECTS / f"{clean.key_of(version(), *COMPILE, *texts)}.o"


@cache
def version() -> str:
    return run([COMPILER, "--version"])[1]


@cache
def sources_of(target: Path) -> list[Path]:
    """The target and the sources of each header that it or one of them includes."""
    found, ahead = [], [target]
    while ahead:
        source = ahead.pop()
        if source not in found:
            found.append(source)
            ahead += [other for header in headers_of(source) for other in sources_of_header(header)]
    return sorted(found)


@cache
def sources_of_header(header: Path) -> list[Path]:
    """X.cpp of X.h, and sources in its folder that include it and have no own header."""
    folder = sorted(header.parent.glob("*.cpp")) if header.is_relative_to(CORE) else []
    own = [source for source in folder if source.stem == header.stem]
    others = [source for source in folder if not source.with_suffix(".h").exists()]
    return own + [source for source in others if header in included_by(source)]


@cache
def headers_of(source: Path) -> set[Path]:
    """All headers of the repo that it includes, directly or indirectly."""
    found: set[Path] = set()
    ahead = [source]
    while ahead:
        for header in included_by(ahead.pop()) - found:
            found.add(header)
            ahead.append(header)
    return found


@cache
def included_by(file: Path) -> set[Path]:
    names = INCLUDE.findall(file.read_text())
    return {path for name in names for folder in (CORE, TARGETS) if (path := folder / name).exists()}
