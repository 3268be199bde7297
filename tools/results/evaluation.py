"""Runs evaluations in headless Godot, and reads their results."""

import csv
import json
import os
import re
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from results.progress import Progress

ROOT = Path(__file__).resolve().parents[2]
PERCENT = re.compile(r"(\d+) %")
FIGURES = ("r2_", "lag_", "t_diff_", "sparc_")


def run_tool(
    name: str, options: dict[str, object], on_line=lambda line: None, project: Path = ROOT / "demo_project"
) -> None:
    """tools/NAME.gd of the project with these options; ends the program with its output if it fails."""
    command = [os.environ["GODOT"], "--headless", "--path", project, "--script", f"res://tools/{name}.gd"]
    command += ["--", *(word for option, value in options.items() for word in (f"--{option}", value))]
    child = subprocess.Popen(
        [str(word) for word in command],
        env={**os.environ, "STEADYHAND_TERMINAL": ""},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    lines = []
    for line in child.stdout:
        lines.append(line)
        on_line(line)
    if child.wait() != 0:
        raise SystemExit(f"{name} failed with status {child.returncode}:\n{''.join(lines[-20:])}")


def is_figure(column: str) -> bool:
    return column.startswith(FIGURES)


@dataclass
class Evaluation:
    """One run of ./steadyhand evaluate: a trial set in one mode and context."""

    trials: Path
    mode: str
    context: str
    out: Path
    keeps_curves: bool  # until drop_curves(): they are large
    summary: dict = field(default_factory=dict)
    rows: list[dict] = field(default_factory=list)  # of results.csv, figures as numbers

    def run(self, on_line) -> None:
        run_tool(
            "evaluate", {"trials": self.trials, "out": self.out, "mode": self.mode, "context": self.context}, on_line
        )
        if not self.keeps_curves:
            self.drop_curves()

    def drop_curves(self) -> None:
        for curves in self.out.glob("*.curves.csv"):
            curves.unlink()

    def read(self) -> None:
        self.summary = json.loads((self.out / "summary.json").read_text())
        with (self.out / "results.csv").open(newline="") as file:
            for row in csv.DictReader(file):
                self.rows.append(
                    {name: float(cell) if is_figure(name) and cell else cell for name, cell in row.items()}
                )

    def spans(self) -> dict[str, tuple[float, float]]:
        """When the gesture of each trial starts and ends (s)."""
        with (self.trials / "trials.csv").open(newline="") as file:
            rows = [row for row in csv.DictReader(file) if row["gesture"] != "none"]
        return {row["trial"]: (float(row["start_s"]), float(row["end_s"])) for row in rows}

    def groups(self) -> list[dict]:
        """Groups with figures, by gesture, the stable position first."""
        judged = [group for group in self.summary["groups"] if group["conditions"]]
        return sorted(judged, key=lambda group: (group["gesture"], group["position"]))

    def group(self, gesture: str, position: str) -> dict | None:
        found = [g for g in self.groups() if (g["gesture"], g["position"]) == (gesture, position)]
        return found[0] if found else None

    def gestures(self) -> list[str]:
        return list(dict.fromkeys(group["gesture"] for group in self.groups()))

    def values(self, gesture: str, position: str, figure: str, condition: str) -> list[float]:
        column = f"{figure}_{condition}"
        rows = [row for row in self.rows if (row["gesture"], row["position"]) == (gesture, position)]
        return [row[column] for row in rows if row[column] != ""]

    def ranked(self, condition: str) -> list[dict]:
        """Trials with figures, the lowest zero-lag R2 of the condition first."""
        judged = [row for row in self.rows if row[f"r2_zero_{condition}"] != ""]
        return sorted(judged, key=lambda row: (row[f"r2_zero_{condition}"], row["trial"]))

    def typical(self, gesture: str, position: str) -> dict | None:
        """The trial whose measured curve has the median zero-lag R2."""
        rows = [row for row in self.ranked("measured") if (row["gesture"], row["position"]) == (gesture, position)]
        return rows[len(rows) // 2] if rows else None


def run_all(evaluations: list[Evaluation]) -> None:
    """Runs as many at once as there are processors."""
    progress = Progress("evaluating")
    done = [0.0] * len(evaluations)
    lock = threading.Lock()

    def run(number: int) -> None:
        def on_line(line: str) -> None:
            if percent := PERCENT.search(line):
                with lock:
                    done[number] = int(percent[1]) / 100
                    progress.show(sum(done) / len(done))

        evaluations[number].run(on_line)

    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        list(pool.map(run, range(len(evaluations))))
    for evaluation in evaluations:
        evaluation.read()
