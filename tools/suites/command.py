"""The command ./steadyhand, as used at a terminal."""

import json
import os
import re
import shlex
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites import (
    figures,
    full_disk,
    installed_godot_cpp,
    study_crash,
    study_logs,
    study_page,
    study_report,
    worked_example,
)
from suites.figures import write_drag, write_program
from suites.outcome import Outcome
from suites.process import ROOT, run

KILL_S = 120


def outcomes() -> Iterator[Outcome]:
    yield from helps()
    with tempfile.TemporaryDirectory(prefix="steadyhand_refusals") as folder:
        yield from refusals(Path(folder))
        yield from emptied_cache(Path(folder))
        yield from other_godots(Path(folder))
    yield from study_logs.outcomes()
    yield from study_report.outcomes()
    yield from study_crash.outcomes()
    yield from study_page.outcomes()
    with tempfile.TemporaryDirectory(prefix="steadyhand_command") as folder:
        yield from training(Path(folder))
        yield from warned_once(Path(folder))
    yield from full_disk.outcomes()
    yield from figures.outcomes()
    yield from worked_example.outcomes()
    yield from installed_godot_cpp.outcomes()


def helps() -> Iterator[Outcome]:
    """`VERB --help` prints only the verb's part of the help."""
    _, whole = run(["./steadyhand", "--help"])
    verbs = dict.fromkeys(re.findall(r"^\./steadyhand (\w+)", whole, re.MULTILINE))
    parts = {verb: run(["./steadyhand", verb, "--help"]) for verb in verbs}
    for verb, (status, part) in parts.items():
        starts = re.findall(r"^\S+ \w+", part, re.MULTILINE)
        good = status == 0 and part in whole and set(starts) == {f"./steadyhand {verb}"}
        yield Outcome.of(f"command/{verb} --help", good, f"status {status}\n{part}")
    status, output = run(["./steadyhand", "evaluate", "--trials", "x", "-h"])
    good = (status, output) == parts["evaluate"]
    yield Outcome.of("command/evaluate -h after other options", good, output)
    with tempfile.TemporaryDirectory(prefix="steadyhand_link") as folder:
        link = Path(folder) / "steadyhand"
        link.symlink_to(ROOT / "steadyhand")
        status, output = run([link, "--help"])
    yield Outcome.of("command/by a symbolic link from elsewhere", (status, output) == (0, whole), output)
    status, output = run(["./steadyhand", "--help"], STEADYHAND_CACHE="/dev/null/cache")
    good = status == 0 and output.startswith("SteadyHand: ")
    yield Outcome.of("command/--help needs no cache", good, f"{status}\n{output}")
    status, output = run(["tools/setup_python.sh", "plots"], STEADYHAND_CACHE="/dev/null/cache")
    message = "cannot write to the cache /dev/null/cache: set $STEADYHAND_CACHE to a folder that you can write to"
    good = (status, output) == (1, f"steadyhand: {message}\n")
    yield Outcome.of("command/setup: a cache that cannot be written is named", good, f"{status}\n{output}")


def refusals(folder: Path) -> Iterator[Outcome]:
    """Bad arguments give exit code 2 and one line with the reason, before a build."""
    (folder / "set").mkdir()
    (folder / "set/trials.csv").touch()
    (folder / "file").touch()
    evaluate = ["evaluate", "--out", folder / "out", "--trials"]
    train = ["train", "--trials", folder / "set", "--gesture", "tap", "--out"]
    no_folder = f"cannot make the folder {folder}/{{}}: {folder}/file is a file"
    for given, message in (
        ([*evaluate, folder], f"no trials.csv in {folder}"),
        ([*evaluate, folder / "set/trials.csv"], f"--trials is a file, {folder}/set/trials.csv: name its folder"),
        ([*evaluate, folder / "set", "--models", folder / "none"], f"no folder {folder}/none"),
        (
            [*evaluate, folder / "set", "--models", folder / "file"],
            f"--models is a file, {folder}/file: name its folder",
        ),
        (
            ["evaluate", "--trials", folder / "set", "--out", folder / "set"],
            "--out is the folder of the trials: name another folder",
        ),
        (["evaluate", "--trials", folder / "set", "--out", folder / "file"], no_folder.format("file")),
        (
            ["train", "--trials", folder, "--gesture", "tap", "--out", folder / "a.gesture"],
            f"no trials.csv in {folder}",
        ),
        ([*train, folder / "set"], f"--out is a folder, {folder}/set: name a file in it, as NAME.gesture"),
        ([*train, folder / "file/a.gesture"], no_folder.format("file")),
        (["results", "--out", folder / "file"], no_folder.format("file")),
        (["demo", "--out", folder / "file/demo"], no_folder.format("file/demo")),
        (["docs", "--out", folder / "file"], no_folder.format("file")),
        (["docs", "--out", folder / "set"], f"{folder}/set is not empty, and is no earlier site: name a new folder"),
        (["bench", "--front", ""], "--front needs a value (./steadyhand --help)"),
        (["train", "--trials", "-none", "--gesture", "tap", "--out", "a"], f"no trials.csv in {ROOT}/-none"),
        (["train", "--trails", folder], "train has no '--trails' (./steadyhand --help)"),
        (["evaluate", "--out", folder / "a=b"], "evaluate needs --trials (./steadyhand --help)"),
    ):
        for arguments in (given, with_equals_signs(given)):
            status, output = run(["./steadyhand", *arguments])
            good = status == 2 and output == f"steadyhand: {message}\n"
            form = " ".join(str(word) for word in arguments).replace(str(folder), "DIR")
            yield Outcome.of(f"command/{form}: {message.replace(str(folder), 'DIR')}", good, f"{status}\n{output}")
    status, output = run(["./steadyhand", "train", "--trials", "--gesture", "circle", "--out", "x.gesture"])
    good = (status, output) == (2, "steadyhand: --trials needs a value (./steadyhand --help)\n")
    yield Outcome.of("command/train --trials --gesture: --trials needs a value", good, f"{status}\n{output}")
    status, output = run(["./steadyhand", "study", folder, f"--out={folder}/none"])
    yield Outcome.of("command/study --out=DIR", status == 2 and "no trial was read" in output, f"{status}\n{output}")


def with_equals_signs(arguments: list) -> list[str]:
    """A verb and pairs of --NAME and VALUE, as --NAME=VALUE."""
    return [arguments[0], *(f"{name}={value}" for name, value in zip(arguments[1::2], arguments[2::2], strict=True))]


def emptied_cache(folder: Path) -> Iterator[Outcome]:
    """A stamp for installed packages whose folder was removed."""
    stamp = folder / "cache/stamps/python-plots"
    stamp.parent.mkdir(parents=True)
    stamp.write_text((ROOT / "tools/requirements/python-plots.txt").read_text())
    python = folder / "bin/python3"
    python.parent.mkdir()
    python.write_text("#!/bin/sh\nexit 1\n")
    python.chmod(0o755)
    environment = {"STEADYHAND_CACHE": str(folder / "cache"), "PATH": f"{python.parent}:{os.environ['PATH']}"}
    status, output = run(["tools/setup_python.sh", "plots"], **environment)
    good = status == 1 and "python3 -m venv failed" in output
    yield Outcome.of("command/setup: a stamp without its folder is ignored", good, f"{status}\n{output}")


def other_godots(folder: Path) -> Iterator[Outcome]:
    """A $GODOT that is no Godot ends the command."""
    old = folder / "old_godot"
    write_program(old, "3.5.stable\n", 0)
    for named, message in ((folder / "none", "is no program"), (old, "is no Godot 4.4 or later")):
        status, output = run(["./steadyhand", "build"], GODOT=str(named))
        good = (status, output) == (1, f"steadyhand: $GODOT {message}: {named}\n")
        yield Outcome.of(f"command/build: a $GODOT that {message} ends it", good, f"{status}\n{output}")


def training(folder: Path) -> Iterator[Outcome]:
    """One model, equal to the one of `./steadyhand train` without options but for its own HMMs."""
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
    yield Outcome.of("command/train: Ctrl-C cancels and leaves no file", good, f"status {status}, {left}\n{output}")

    status, output = run(["./steadyhand", *with_equals_signs(command[1:])])
    trained, own = (json.loads(path.read_text()) for path in (model, folder / "models/tap.gesture"))
    has_hmms = trained.pop("recorded_hmms", None) is not None
    good = status == 0 and has_hmms and trained == own
    yield Outcome.of("command/train: the model", good, output)
    yield Outcome.of("command/train: progress in lines without a terminal", "##" not in output, output)
    _, output = run(["script", "--quiet", "--command", shlex.join(str(word) for word in command), "/dev/null"])
    good = len(re.findall(r"training tap  #+-* ", output)) > 20
    yield Outcome.of("command/train: progress in one line on a terminal", good, output)
    good = picture.is_file() and picture.read_bytes().startswith(b"\x89PNG")
    yield Outcome.of("command/train: its picture", good, output)

    command[command.index("tap")] = "swipe"
    status, output = run(command)
    message = (
        f"ERROR: {folder}/train: no trial of the gesture 'swipe', but of horizontal_drag, tap, vertical_drag, zoom"
    )
    good = status == 2 and output.splitlines()[-1] == message
    yield Outcome.of("command/train: an unknown gesture gives one line", good, f"{status}\n{output}")


def warned_once(folder: Path) -> Iterator[Outcome]:
    """Each track is read once."""
    write_drag(folder / "cut/one.reference.csv")
    text = (folder / "cut/one.reference.csv").read_text()
    for kind in ("reference", "measured"):
        (folder / f"cut/one.{kind}.csv").write_text(text + "3.01,0.2,")
    columns = "trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_z,axis_x,axis_y,axis_z,amplitude_m"
    row = "one,horizontal_drag,stable,ann,1.0,2.0,0,0,0,1,0,0,0.2"
    (folder / "cut/trials.csv").write_text(f"{columns}\n{row}\n")
    for context in ("scene", "open"):
        options = ["--trials", folder / "cut", "--out", folder / "cut_out", "--context", context]
        status, output = run(["./steadyhand", "evaluate", *options])
        warned = [line for line in output.splitlines() if "this last row is cut off" in line]
        files = sorted(line.split(": ")[1].split(":")[0].split("/")[-1] for line in warned)
        good = status == 0 and files == ["one.measured.csv", "one.reference.csv"]
        yield Outcome.of(f"command/evaluate: each cut track is one warning ({context})", good, f"{status}\n{output}")


def interrupted(command: list[str], at: str) -> tuple[int, str]:
    """Sends Ctrl-C to all processes of the command once it prints `at`. Returns exit status and output."""
    child = subprocess.Popen(
        command,
        cwd=ROOT,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
        # Background jobs of a shell ignore SIGINT, and so do their children.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    lines = []
    for line in child.stdout:
        lines.append(line)
        if at in line:
            os.killpg(child.pid, signal.SIGINT)
            break
    try:
        rest, _ = child.communicate(timeout=KILL_S)
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)
        rest, _ = child.communicate()
    return child.returncode, "".join(lines) + rest
