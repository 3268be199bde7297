"""A study that is killed repeatedly: each trial is there once, and a crash loses only the running trial."""

import csv
import json
import os
import random
import select
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

KILLS = 20
# Time from the open session to the kill: about ten trials.
LONGEST_S = 0.3
START_S = 60
PROTOCOL = """[gd_resource type="Resource" script_class="StudyProtocol" load_steps=3 format=3]

[ext_resource type="Script" path="res://study/study_protocol.gd" id="protocol"]
[ext_resource type="Resource" path="res://study/questionnaires/three_statements.tres" id="statements"]

[resource]
script = ExtResource("protocol")
study_name = "crashes"
gestures = PackedStringArray("tap", "horizontal_drag")
conditions = PackedStringArray("measured", "synthesised")
trials_per_cell = 15
questionnaires = [ExtResource("statements")]
"""


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_study_crash") as folder:
        yield from killed(Path(folder))


def killed(folder: Path) -> Iterator[Outcome]:
    protocol = folder / "tiny.tres"
    protocol.write_text(PROTOCOL)
    out = folder / "study"
    tool = ["--headless", "--path", ROOT / "demo_project", "--script", "res://tools/study.gd", "--"]
    options = ["--participants", "1", "--protocol", protocol, "--out", out, "--resume"]
    command = [str(word) for word in [os.environ["GODOT"], *tool, *options]]
    session = out / "sub-p01/ses-01"
    instants = random.Random(1)
    lost = []
    for _ in range(KILLS):
        kill_after(command, instants.uniform(0.0, LONGEST_S))
        begun, finished = count(session, "*.frames.csv"), len(whole_rows(session / "trials.csv"))
        if begun > finished + 1:
            lost.append(f"{begun} trials begun, {finished} have a row")
    yield Outcome.of(f"command/study: {KILLS} kills lose the running trial at most", not lost, "\n".join(lost))
    reached = len(whole_rows(session / "trials.csv"))
    status, output = run(command, kill_s=120)
    faults = [] if status == 0 else [f"exit status {status}"]
    faults += check_session(session)
    faults += [f"a folder too many: {path}" for path in out.glob("*/*") if path != session]
    shown = f"{reached} trials before the last run\n{output}\n" + "\n".join(faults)
    yield Outcome.of("command/study: after kills every trial is there once, and all files are whole", not faults, shown)


def kill_after(command: list[str], wait_s: float) -> None:
    """Kills it this long after the session was opened."""
    child = subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, process_group=0
    )
    until = time.monotonic() + START_S
    output_so_far = b""
    while b"sub-p01" not in output_so_far and time.monotonic() < until:
        if select.select([child.stdout], [], [], 1.0)[0]:
            more = os.read(child.stdout.fileno(), 65536)
            output_so_far += more
            if not more:
                break
    time.sleep(wait_s)
    os.killpg(child.pid, signal.SIGKILL)
    child.communicate()


def whole_rows(path: Path) -> list[bytes]:
    """Without the header, and without a row that was cut."""
    return path.read_bytes().split(b"\n")[1:-1] if path.exists() else []


def count(session: Path, pattern: str) -> int:
    return len(list(session.glob(pattern)))


def check_session(session: Path) -> list[str]:
    plan = json.loads((session / "session.json").read_text())
    faults = []
    with (session / "trials.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    numbers = [row["trial"] for row in rows]
    if numbers != [str(trial["trial"]) for trial in plan["trials"]]:
        faults.append(f"trials are {' '.join(numbers)}")
    answers = list(csv.DictReader((session / "answers.csv").open(newline="")))
    given = {(row["after_trial"], row["questionnaire"], row["item"]) for row in answers}
    if len(given) != len(answers) or len(given) != 3 * len(plan["questionnaires"]):
        faults.append(f"{len(answers)} answers, {len(given)} of them different")
    for kind in ("frames", "reference", "motion"):
        if count(session, f"trial_*.{kind}.csv") != len(plan["trials"]):
            faults.append(f"{count(session, f'trial_*.{kind}.csv')} {kind} files")
    for path in sorted(session.glob("*.csv")):
        data = path.read_bytes()
        rows = list(csv.reader(line for line in data.decode().splitlines() if not line.startswith("#")))
        if not data.endswith(b"\n") or len({len(row) for row in rows}) != 1:
            faults.append(f"{path.name} is cut or glued")
    return faults
