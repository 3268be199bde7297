"""Runs the benchmarks of processor time, prints their output, and writes it into the tables of docs/cost.md."""

import argparse
import os
import platform
import re
import subprocess
import sys
from pathlib import Path

from commit import ROOT, commit_of
from dist.addon import version
from page_tables import fill, table

PAGE = ROOT / "docs/cost.md"
SOURCES = ["SConstruct", "extension/core", "models", "tests/bench"]
HMMLEARN = ROOT / "tests/bench/hmmlearn_training.py"
VECTORS = {"avx512f": "AVX-512", "avx2": "AVX2"}  # the widest first
VIBRATION_GOALS_NS = {"spring": "0.5", "spring, live": "0.5", "impulse": "1"}


def main() -> None:
    parser = argparse.ArgumentParser(prog="cost", description=__doc__)
    parser.add_argument("--programs", type=Path, required=True, help="folder of the benchmarks")
    parser.add_argument("--page", type=Path, default=PAGE, help="page whose tables are replaced")
    given = parser.parse_args()

    recognition = output_of([given.programs / "bench_recognition", ROOT / "models"])
    recognition += output_of([sys.executable, HMMLEARN], recognition)
    vibration = output_of([given.programs / "bench_vibration"])
    tables = {
        "machine": f"Made with SteadyHand {version()}{commit_of(SOURCES)}, on {machine()}.\n",
        "recognition": recognition_table(recognition),
        "vibration": vibration_table(vibration),
    }
    fill(given.page, tables)
    print(f"wrote {given.page}", file=sys.stderr)


def output_of(command: list, read: str = "") -> str:
    """What the command prints, also on the terminal. Raises SystemExit if it fails."""
    run = subprocess.run(command, input=read, stdout=subprocess.PIPE, text=True)
    print(run.stdout, end="", flush=True)
    if run.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))} failed with status {run.returncode}: no page is changed")
    return run.stdout


def machine() -> str:
    """Processor, cores and vector width."""
    try:
        cpuinfo = Path("/proc/cpuinfo").read_text()
    except OSError:
        cpuinfo = ""
    model = re.search(r"^model name\s*: (.+)", cpuinfo, re.MULTILINE)
    words = [model[1] if model else platform.machine(), f"{os.cpu_count()} cores"]
    words += [title for flag, title in VECTORS.items() if re.search(rf"\b{flag}\b", cpuinfo)][:1]
    return ", ".join(words)


def columns(line: str) -> list[str]:
    """The benchmarks put at least two spaces between columns."""
    return re.split(r"\s{2,}", line.strip())


def recognition_table(text: str) -> str:
    head, *rows = map(columns, text.splitlines())
    cells = ([name, rounded(ns), rounded(ratio), *goal, ""][:4] for name, ns, ratio, *goal in rows)
    return f"In ns, {head[0]}:\n\n{table(['', 'ns', 'x forward pass', 'goal'], cells)}"


def vibration_table(text: str) -> str:
    head, *rows = text.splitlines()
    cells = (
        [name, ns, ratio.split()[0], VIBRATION_GOALS_NS.get(name, "")] for name, ns, ratio, _ in map(columns, rows)
    )
    return f"In {head}:\n\n{table(['', 'ns', 'x std::sin', 'goal'], cells)}"


def rounded(number: str) -> str:
    return f"{float(number):.1f}" if float(number) < 100 else f"{float(number):.0f}"


if __name__ == "__main__":
    main()
