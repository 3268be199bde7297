"""The commands that measure and write pages: ./steadyhand results and bench."""

import csv
import re
import statistics
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_results") as folder:
        yield from results(Path(folder))
    with tempfile.TemporaryDirectory(prefix="steadyhand_haptics") as folder:
        yield from haptics(Path(folder))
    with tempfile.TemporaryDirectory(prefix="steadyhand_cost") as folder:
        yield from cost(Path(folder))
    yield from events()


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
