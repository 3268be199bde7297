"""The command ./steadyhand, as used at a terminal."""

import csv
import os
import re
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites import full_disk, installed_godot_cpp, study_crash, study_logs, study_page, study_report, worked_example
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
    with tempfile.TemporaryDirectory(prefix="steadyhand_results") as folder:
        yield from results(Path(folder))
    with tempfile.TemporaryDirectory(prefix="steadyhand_haptics") as folder:
        yield from haptics(Path(folder))
    with tempfile.TemporaryDirectory(prefix="steadyhand_cost") as folder:
        yield from cost(Path(folder))
    yield from events()
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
    """One model, equal to the one of `./steadyhand train` without options."""
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
    good = status == 0 and model.read_bytes() == (folder / "models/tap.gesture").read_bytes()
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


def cost(folder: Path) -> Iterator[Outcome]:
    """docs/cost.md from benchmarks with two rows each, and then from a failing one."""
    page = folder / "cost.md"
    page.write_text((ROOT / "docs/cost.md").read_text())
    recognition = [("plain scaled forward pass, a symbol", 12.34, 1.0), ("a frame", 5678.9, 460.2)]
    rows = "".join(f"  {name:<46} {ns:12.1f} {ratio:14.1f}\n" for name, ns, ratio in recognition)
    write_program(folder / "bench_recognition", f"least of 2 rounds   ns    x forward\n{rows}", 0)
    vibration = "ns a sample\n  spring              0.250   0.031 x std::sin     7.1 x memset\n"
    write_program(folder / "bench_vibration", vibration, 0)
    command = [sys.executable, "-m", "cost", "--programs", folder, "--page", page]
    status, output = run(command, PYTHONPATH=str(ROOT / "tools"))
    text = page.read_text()
    wanted = [
        "In ns, least of 2 rounds:",
        "| a frame | 5679 | 460 |  |",
        "In ns a sample:",
        "| spring | 0.250 | 0.031 | 0.5 |",
    ]
    good = status == 0 and rows in output and all(f"\n{line}\n" in text for line in wanted)
    yield Outcome.of("command/bench: prints its output and fills the tables", good, f"{status}\n{output}\n{text}")
    write_program(folder / "bench_vibration", vibration.replace("0.250", "0.350"), 1)
    status, output = run(command, PYTHONPATH=str(ROOT / "tools"))
    good = status != 0 and "no page is changed" in output and page.read_text() == text
    yield Outcome.of("command/bench: a benchmark that fails leaves the page as it is", good, f"{status}\n{output}")


def write_program(path: Path, output: str, status: int) -> None:
    """A program that prints the output and ends with the status."""
    path.write_text(f"#!/bin/sh\ncat <<'END'\n{output}END\nexit {status}\n")
    path.chmod(0o755)


def haptics(folder: Path) -> Iterator[Outcome]:
    """The tables of docs/haptics_measured.md, short: one mix rate, one person, two minutes of play."""
    page = folder / "haptics_measured.md"
    page.write_text((ROOT / "docs/haptics_measured.md").read_text())
    options = ["--page", page, "--work", folder / "work", "--real", folder / "none"]
    options += ["--rates", 48000, "--subjects", 1, "--minutes", 2]
    status, output = run([sys.executable, "-m", "haptics", *options], PYTHONPATH=str(ROOT / "tools"))
    yield Outcome.of("command/bench haptics: the tables are made", status == 0, output)
    if status != 0:
        return
    text = page.read_text()
    held = re.search(r"^\| 48000 \| ([\d.]+) \| ([\d.]+) \|", text, re.MULTILINE)
    good = held is not None and abs(float(held[1]) - 180.0) < 0.5 and abs(float(held[2]) - 0.5) < 0.005
    yield Outcome.of("command/bench haptics: 180 Hz at half the amplitude", good, text)
    steps = re.findall(r"^\| [a-z].* \| ([\d.]+) \| [\d.]+ \|$", text, re.MULTILINE | re.IGNORECASE)
    good = len(steps) > 15 and max(float(step) for step in steps) < 1.02
    yield Outcome.of("command/bench haptics: no change clicks", good, f"{steps}\n{text}")
    grown = re.search(r"memory +([+-]\d+) bytes", text)
    yield Outcome.of("command/bench haptics: memory stays", grown is not None and int(grown[1]) < 10000, text)


def events() -> Iterator[Outcome]:
    """The tables of events, of one run each: hands by trackers and contexts."""
    status, output = run(["./steadyhand", "bench", "events", "--runs", 1])
    rows = re.findall(r"^\| ([a-z].*?) \|((?: [\d.]+ \|){6})$", output, re.MULTILINE)
    yield Outcome.of("command/bench events: every hand", status == 0 and len(rows) == 38, output)
    plain = dict(rows).get("twelve equal gestures in a row")
    yield Outcome.of("command/bench events: plain gestures are detected", plain == " 100 |" * 6, output)
    status, output = run(["./steadyhand", "bench", "events", "--runs", "some"])
    good = status == 2 and output.startswith("steadyhand: --runs is no whole number of at least 1: 'some'")
    yield Outcome.of("command/bench events: --runs must be a number", good, f"{status}\n{output}")
    status, output = run(["./steadyhand", "bench", "events", "--min-confidence", "1.5"])
    good = status == 2 and output.startswith("steadyhand: --min-confidence is no probability, 0 to 1: '1.5'")
    yield Outcome.of("command/bench events: --min-confidence must be a probability", good, f"{status}\n{output}")


def results(folder: Path) -> Iterator[Outcome]:
    """The pages of results for one simulated person, compared with numbers computed from results.csv."""
    write_drag(folder / "lm_digits/plain.csv")
    options = ["--out", folder, "--work", folder / "work", "--subjects", 1, "--real", folder / "none"]
    options += ["--durations", "0.15,4"]
    status, output = run([sys.executable, "-m", "results", *options], PYTHONPATH=str(ROOT / "tools"))
    yield Outcome.of("command/results: a page is made", status == 0, output)
    if status != 0:
        return
    page = "".join(path.read_text() for path in sorted(folder.glob("results*.md")))
    pictures = re.findall(r"!\[[^]]*\]\(([^)]*)\)", page)
    missing = [picture for picture in pictures if not (folder / picture).is_file()]
    yield Outcome.of(
        "command/results: its pictures are there", len(pictures) > 8 and not missing, f"missing: {missing}"
    )
    with (folder / "work/synthetic/phase_scene/results.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    for gesture in ("horizontal_drag", "tap"):
        own = [row for row in rows if row["gesture"] == gesture and row["position"] == "unstable"]
        raw, ours = (statistics.fmean(float(row[f"r2_zero_{of}"]) for row in own) for of in ("measured", "synthesised"))
        line = f"| zero-lag R2, unstable | synthetic, {gesture.replace('_', ' ')}: {len(own)} |"
        cells = [row.split(" | ") for row in page.splitlines() if row.startswith(line)]
        good = len(cells) == 1 and [cells[0][3], cells[0][5]] == [f"{raw:.4f}", f"{ours:.4f}"]
        if good:
            mark = "reached" if ours > max(raw, float(cells[0][4].split()[0])) else "**not reached**"
            good = cells[0][7] == f"{mark} |"
        yield Outcome.of(f"command/results: the goal of {gesture}", good, f"{raw:.4f}, {ours:.4f}, not\n{cells}")

    own = [row for row in rows if (row["gesture"], row["position"]) == ("tap", "unstable")]
    mean = statistics.fmean(float(row["r2_zero_synthesised"]) for row in own)
    found = [row for row in page.splitlines() if row.startswith(f"| synthetic, tap, unstable: {len(own)} |")]
    good = len(found) == 1 and found[0].split("|")[-2].strip(" *").startswith(f"{mean:.3f}")
    yield Outcome.of("command/results: mean zero-lag R2 of taps beside other predictors", good, f"{mean}, {found}")

    with (folder / "work/speed/4 s/phase_scene/results.csv").open(newline="") as file:
        own = [row for row in csv.DictReader(file) if row["position"] == "unstable"]
    mean = statistics.fmean(float(row["r2_zero_synthesised"]) for row in own)
    at = page.find(f"| 4 s, unstable: {len(own)} | measured |")
    found = page[at:].splitlines()[2].split("|")[5].strip() if at >= 0 else ""
    yield Outcome.of("command/results: mean zero-lag R2 of gestures of 4 s", found == f"{mean:.3f}", f"{mean}, {found}")

    with (folder / "work/rounds/4_scene/results.csv").open(newline="") as file:
        own = [row for row in csv.DictReader(file) if (row["gesture"], row["position"]) == ("tap", "unstable")]
    mean = statistics.fmean(float(row["r2_zero_synthesised"]) for row in own)
    at = page.find(f"| tap, unstable: {len(own)} | none |")
    cells = page[at:].splitlines()[1].split("|") if at >= 0 else []
    found = [cell.strip() for cell in (cells[2], cells[5])] if cells else []
    good = found == ["4", f"{mean:.3f}"]
    yield Outcome.of("command/results: mean zero-lag R2 of taps after four others", good, f"{mean}, {found}")

    with (folder / "work/sensors/rounded to 1 mm_scene/results.csv").open(newline="") as file:
        own = [row for row in csv.DictReader(file) if row["position"] == "stable"]
    means = [
        f"{statistics.fmean(float(row[f'r2_zero_{name}']) for row in own):.3f}" for name in ("measured", "synthesised")
    ]
    cells = [
        cell.strip() for line in page.splitlines() if line.startswith("| rounded to 1 mm |") for cell in line.split("|")
    ]
    found = [cells[4], cells[7]] if cells else []
    yield Outcome.of("command/results: mean zero-lag R2 of a sensor that rounds", found == means, f"{means}, {found}")

    rate = f"{60 / 3.001:.2f}"
    found = [row for row in page.splitlines() if row.startswith("| false alarms a minute, without a task |")]
    good = len(found) == 1 and found[0].endswith(f"| {rate} | < 1 | **not reached** |")
    yield Outcome.of("command/results: the goal of false alarms", good, f"{rate}, not\n{found}")
    row = f"|  | horizontal drag | plain | 1 | {rate} |"
    found = [line for line in page.splitlines() if "horizontal drag | plain" in line]
    yield Outcome.of("command/results: a drag of other hands is a false alarm", found == [row], f"{found}")


def write_drag(path: Path) -> None:
    """Three seconds of a hand that rests, moves 20 cm to the side in 1 s, and rests."""
    path.parent.mkdir()
    lines = ["t,index_x,index_y,index_z"]
    for frame in range(301):
        s = min(max(frame / 100 - 1.0, 0.0), 1.0)
        lines.append(f"{frame / 100},{0.2 * (10 * s**3 - 15 * s**4 + 6 * s**5):.6f},0,{1e-4 * (frame % 3)}")
    path.write_text("\n".join(lines) + "\n")


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
