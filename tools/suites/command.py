"""The entry, ./steadyhand, as a user at a terminal meets it."""

import os
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

KILL_S = 120


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_command") as folder:
        yield from training(Path(folder))


def training(folder: Path) -> Iterator[Outcome]:
    """One model from trials of which `./steadyhand train` without options would make all."""
    status, output = run(["./steadyhand", "build"])
    if status == 0:
        options = ["--models", folder / "models", "--work", folder]
        tool = [os.environ["GODOT"], "--headless", "--path", "demo_project", "--script", "res://tools/train.gd", "--"]
        status, output = run([*tool, *options])
    if status != 0:
        yield Outcome.of("command/train prepares", False, output)
        return
    model, picture = folder / "tap.gesture", folder / "tap.png"
    command = ["./steadyhand", "train", "--trials", folder / "train", "--gesture", "tap", "--out", model]

    status, output = interrupted([str(word) for word in command], "training tap")
    left = [path.name for path in folder.iterdir() if path.name.startswith("tap")]
    good = status == 128 + signal.SIGINT and "cancelled" in output and not left
    yield Outcome.of("command/train: Ctrl-C cancels and leaves nothing", good, f"status {status}, {left}\n{output}")

    status, output = run(command)
    good = status == 0 and model.read_bytes() == (folder / "models/tap.gesture").read_bytes()
    yield Outcome.of("command/train: the model", good, output)
    good = picture.is_file() and picture.read_bytes().startswith(b"\x89PNG")
    yield Outcome.of("command/train: its picture", good, output)


def interrupted(command: list[str], at: str) -> tuple[int, str]:
    """Ctrl-C, to all processes of the command, as soon as it says `at`; its exit status and what it said."""
    child = subprocess.Popen(
        command,
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    said = []
    for line in child.stdout:
        said.append(line)
        if at in line:
            os.killpg(child.pid, signal.SIGINT)
            break
    try:
        rest, _ = child.communicate(timeout=KILL_S)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)
        rest, _ = child.communicate()
    return child.returncode, "".join(said) + rest
