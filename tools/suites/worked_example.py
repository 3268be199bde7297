"""docs/new_gesture.md: saves its scripts, and runs its commands in order."""

import json
import os
import re
import shutil
from collections.abc import Iterator

from suites.outcome import Outcome
from suites.process import ROOT, run

PAGE = ROOT / "docs/new_gesture.md"
FOLDER = ROOT / "build/new_gesture"
BLOCK = re.compile(r"^```(gdscript|sh)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SAVED_AS = re.compile(r"[Ss]ave\s+(?:this\s+|it\s+)?as\s+`([^`]+)`")
# The engine continues after an error, and exits with 0.
COMPLAINT = re.compile(r"^\s*(?:SCRIPT )?ERROR:|Parse Error", re.MULTILINE)


def outcomes() -> Iterator[Outcome]:
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    page = PAGE.read_text()
    printed = ""
    for block in BLOCK.finditer(page):
        kind, text = block.groups()
        if kind == "gdscript":
            name = SAVED_AS.findall(page[: block.start()])[-1]
            (ROOT / name).write_text(text)
            continue
        status, output = run(["bash", "-ec", text], GODOT=os.environ["GODOT"])
        good = status == 0 and not COMPLAINT.search(output)
        yield Outcome.of(f"command/new gesture: {text.split()[0]} ... {text.split()[-1]}", good, output)
        printed += output
        if not good:
            return
    yield Outcome.of("command/new gesture: its feature is found", "by index_along_circle" in printed, printed)
    followed = re.search(
        r"^started circle$.*^ended circle at [\d.]+ s: (\d+) degrees$", printed, re.MULTILINE | re.DOTALL
    )
    good = followed is not None and abs(int(followed[1]) - 360) < 36
    yield Outcome.of("command/new gesture: a whole circle is followed", good, printed)
    yield from figures(json.loads((FOLDER / "evaluation/summary.json").read_text()))


def figures(summary: dict) -> Iterator[Outcome]:
    """With bad tracking the synthesised motion must be better than the raw data and all filters."""
    for group in summary["groups"]:
        means = {name: figure["r2_zero"]["mean"] for name, figure in group["conditions"].items()}
        name = f"command/new gesture: {group['position']}: {group['trials']} trials, mean zero-lag R2 {means}"
        best = max(mean for condition, mean in means.items() if condition != "synthesised")
        allowed = best if group["position"] == "unstable" else best - 0.005
        yield Outcome.of(name, group["trials"] == 18 and means["synthesised"] >= allowed)
