"""The GDScript of the pages: all of it compiles, and complete scenes run headless until a gesture ends."""

import os
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites.markdown import Page
from suites.outcome import Outcome
from suites.process import ROOT, run

PROJECT = ROOT / "demo_project"
COMPLETE = "<!-- complete scene -->"
# The nodes that a piece of a script is about; it becomes the body of a function.
AROUND_A_PIECE = """extends Node3D

var tracker: HandTracker
var hmm: GestureHMM
var synth: HapticSynth
var alignment: TrackerAlignment


func run() -> void:
"""
COMPLAINT = re.compile(r"^\s*(?:SCRIPT )?ERROR:|Parse Error", re.MULTILINE)


def outcomes(pages: dict[str, Page]) -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_docs") as folder:
        saved = {}  # path of a script by the place of its block
        for name, page in pages.items():
            for block in page.blocks:
                if block.language == "gdscript":
                    path = Path(folder, f"{page.path.stem}_{block.line}.gd")
                    path.write_text(as_script(block.text))
                    saved[f"{name}:{block.line}"] = path
        yield compiled(saved)
        yield linted(saved)
        for name, page in pages.items():
            for block in page.blocks:
                if block.before.strip() == COMPLETE:
                    yield scene(f"{name}:{block.line}", saved[f"{name}:{block.line}"])


def as_script(text: str) -> str:
    if "extends " in text:
        return text
    lines = text.rstrip("\n").split("\n")
    body = [f"\t{line}" if line else "" for line in lines]
    declared = re.findall(r"^var (\w+)", text, re.MULTILINE)
    around = "".join(
        line for line in AROUND_A_PIECE.splitlines(True) if not any(line.startswith(f"var {name}:") for name in declared)
    )
    return around + "\n".join(body) + "\n"


def compiled(saved: dict[str, Path]) -> Outcome:
    command = [os.environ["GODOT"], "--headless", "--path", PROJECT, "--script", ROOT / "tests/docs/compile.gd", "--"]
    status, output = run([*command, *saved.values()], kill_s=60)
    good = status == 0 and f"{len(saved)} scripts compile" in output and not COMPLAINT.search(output)
    return Outcome.of(f"docs/{len(saved)} scripts compile", good and len(saved) > 0, output)


def linted(saved: dict[str, Path]) -> Outcome:
    status, output = run([Path(sys.executable).parent / "gdlint", *saved.values()])
    return Outcome.of("docs/gdlint accepts the scripts", status == 0, output)


def scene(place: str, script: Path) -> Outcome:
    """Faster than real time, as a script of its node."""
    command = [os.environ["GODOT"], "--headless", "--fixed-fps", "60", "--path", PROJECT]
    status, output = run([*command, "--script", ROOT / "tests/docs/play.gd", "--", script], kill_s=60)
    good = status == 0 and "a gesture has ended" in output and not COMPLAINT.search(output)
    return Outcome.of(f"docs/the scene of {place} runs until a gesture ends", good, output)
