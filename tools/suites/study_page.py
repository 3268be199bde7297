"""docs/study.md: saves its protocol, and runs its commands in order in an empty folder."""

import csv
import os
import re
import shlex
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

PAGE = ROOT / "docs/study.md"
BLOCK = re.compile(r"^( *)```(ini|sh|python)\n(.*?)^\1```$", re.MULTILINE | re.DOTALL)
SAVED_AS = re.compile(r"Save it as `([^`]+)`")
# The engine continues after an error, and exits with 0.
COMPLAINT = re.compile(r"^\s*(?:SCRIPT )?ERROR:|Parse Error|Traceback", re.MULTILINE)
KILL_S = 120
MADE = [
    "dry_run/sub-p03/ses-01/trials.csv",
    "dry_run_backup.tar.gz",
    "dry_run_report/report.html",
    "tables/dry_run_codebook.csv",
    "dry_run_bids/dataset_description.json",
]


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_study_page") as folder:
        yield from follow(Path(folder))


def follow(folder: Path) -> Iterator[Outcome]:
    for name in ("steadyhand", "demo_project"):
        (folder / name).symlink_to(ROOT / name)
    page = PAGE.read_text("utf-8")
    count = 0
    for block in BLOCK.finditer(page):
        kind, text = block[2], textwrap.dedent(block[3])
        if kind == "ini":
            (folder / SAVED_AS.findall(page[: block.start()])[-1]).write_text(text)
            continue
        # Closes the window of a person's session after some frames.
        text = re.sub(r"^godot ", f"{shlex.quote(os.environ['GODOT'])} --headless --quit-after 20 ", text)
        command = ["bash", "-ec", text] if kind == "sh" else [sys.executable, "-c", text]
        status, output = run(["env", "-C", folder, *command], kill_s=KILL_S)
        good = status == 0 and not COMPLAINT.search(output)
        name = textwrap.dedent(block[3]).split("\n")[0]
        yield Outcome.of(f"command/study page: {name}", good, f"status {status}\n{output}")
        if not good:
            return
        if "--resume" in name:
            expected = [f"sub-p0{number}/ses-01: complete" for number in (1, 2, 3)]
            good = all(text in output for text in expected)
            yield Outcome.of("command/study page: complete sessions stay as they are", good, output)
        count += 1
    missing = [name for name in MADE if not (folder / name).is_file()]
    yield Outcome.of("command/study page: its files are there", not missing and count >= 7, f"{missing}, {count}")
    with (folder / "dry_run/sub-p01/ses-01/answers.csv").open(newline="") as file:
        rated = {row["condition"] for row in csv.DictReader(file)}
    yield Outcome.of("command/study page: both conditions are rated", rated == {"measured", "synthesised"}, f"{rated}")
    session = (folder / "dry_run/sub-p01/ses-01/session.json").read_text()
    good = '"study": "pilot"' in session and '"three_statements"' in session
    yield Outcome.of("command/study page: its protocol is the one that was run", good, session)
