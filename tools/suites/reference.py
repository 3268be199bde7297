"""The class reference of extension/doc_classes is current and complete."""

import re
import shutil
import tempfile
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

PAGES = ROOT / "extension/doc_classes"
EMPTY = re.compile(r"<(?:brief_)?description>\s*</|<(?:member|constant) (?![^>]*overrides=)[^>]*(?:/>|>\s*</)")


def outcome(godot: str, project: Path) -> Outcome:
    """Compares with Godot's doctool, which writes each page from the classes and keeps descriptions."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(PAGES, Path(folder, "doc_classes"))
        _, output = run([godot, "--headless", "--path", project, "--doctool", folder, "--gdextension-docs"])
        made = {page.name: page.read_text() for page in Path(folder, "doc_classes").glob("*.xml")}
    kept = {page.name: page.read_text() for page in PAGES.glob("*.xml")}
    faults = [f"{name} is not in extension/doc_classes" for name in sorted(made.keys() - kept.keys())]
    faults += [f"{name} has no class" for name in sorted(kept.keys() - made.keys())]
    for name in sorted(made.keys() & kept.keys()):
        faults += [f"{name} is stale: {line}" for line in changed(kept[name], made[name])]
        faults += [f"{name} lacks a description: {found[0]}" for found in EMPTY.finditer(kept[name])]
    advice = "godot --doctool extension --gdextension-docs writes the pages anew"
    return Outcome.of("scenes: the class reference is current", not faults, "\n".join([*faults, advice, output]))


def changed(kept: str, made: str) -> list[str]:
    """Lines of one page that the other does not have, without white space."""
    before, after = ([line.strip() for line in text.splitlines()] for text in (kept, made))
    return [line for line in after if line and line not in before] + [
        line for line in before if line and line not in after
    ]
