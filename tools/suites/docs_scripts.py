"""The GDScript of the pages: all of it compiles, and complete scenes run headless until a gesture ends."""

import os
import re
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from pathlib import Path

from docs_site.class_page import read_classes
from suites.markdown import Page
from suites.outcome import Outcome
from suites.process import ROOT, run

PROJECT = ROOT / "demo_project"
COMPLETE = "<!-- complete scene -->"
# Nodes for a piece of a script, which becomes the body of a function.
AROUND_A_PIECE = """extends Node3D

{constants}
var tracker: HandTracker
var hmm: GestureHMM
var synth: HapticSynth
var alignment: TrackerAlignment
var fingertip: Vector3


func run() -> void:
"""
COMPLAINT = re.compile(r"^\s*(?:SCRIPT )?ERROR:|Parse Error", re.MULTILINE)


def outcomes(pages: dict[str, Page]) -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_docs") as folder:
        saved = {}  # path of a script by the place of its block
        for name, page in pages.items():
            classes = {}  # that earlier scripts of the page define
            for block in page.blocks:
                if block.language == "gdscript":
                    path = Path(folder, f"{page.path.stem}_{block.line}.gd")
                    path.write_text(as_script(block.text, classes))
                    saved[f"{name}:{block.line}"] = path
                    classes |= {defined: path for defined in re.findall(r"^class_name (\w+)", block.text, re.MULTILINE)}
        for name, page in read_classes().items():
            text = page.findtext("description", "").expandtabs(4)
            for number, piece in enumerate(re.findall(r"\[codeblock\]\n(.*?)\[/codeblock\]", text, re.DOTALL)):
                path = Path(folder, f"{name.lower()}_{number}.gd")
                path.write_text(as_script(textwrap.dedent(piece).replace("    ", "\t"), {}))
                saved[f"{name}.xml"] = path
        yield compiled(saved)
        yield linted(saved)
        for name, page in pages.items():
            for block in page.blocks:
                if block.before.strip() == COMPLETE:
                    yield scene(f"{name}:{block.line}", saved[f"{name}:{block.line}"])


def as_script(text: str, classes: dict[str, Path]) -> str:
    if "extends " in text:
        return text
    if "func _" in text:
        return f"extends Node3D\n\n{text}"
    constants = "".join(f'const {name} := preload("{path}")\n' for name, path in classes.items())
    return AROUND_A_PIECE.format(constants=constants) + textwrap.indent(text, "\t")


def compiled(saved: dict[str, Path]) -> Outcome:
    command = [os.environ["GODOT"], "--headless", "--path", PROJECT, "--script", ROOT / "tests/docs/compile.gd", "--"]
    status, output = run([*command, *saved.values()], kill_s=60)
    good = status == 0 and f"{len(saved)} scripts compile" in output and not COMPLAINT.search(output)
    return Outcome.of(f"docs/{len(saved)} scripts compile", good and len(saved) > 0, output)


def linted(saved: dict[str, Path]) -> Outcome:
    status, output = run([Path(sys.executable).parent / "gdlint", *saved.values()])
    return Outcome.of("docs/gdlint accepts the scripts", status == 0, output)


def scene(place: str, script: Path) -> Outcome:
    """Runs it faster than real time, as the script of its node."""
    command = [os.environ["GODOT"], "--headless", "--fixed-fps", "60", "--path", PROJECT]
    status, output = run([*command, "--script", ROOT / "tests/docs/play.gd", "--", script], kill_s=60)
    good = status == 0 and "a gesture has ended" in output and not COMPLAINT.search(output)
    return Outcome.of(f"docs/the scene of {place} runs until a gesture ends", good, output)
