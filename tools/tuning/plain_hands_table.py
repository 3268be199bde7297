"""Prints the table of the trackers of tools/tuning/plain_hands.py, from `./steadyhand evaluate` in both contexts.

    python tools/tuning/plain_hands_table.py --scene DIR --open DIR [--gesture NAME]...

Columns: mean zero-lag R2 of the measured curve, and of the synthesised one with and without a task; number of gestures
that were not detected, or as another one, with and without a task. Without a task the curve is 0 before a gesture is
detected. For all gestures, or the named ones.
"""

import argparse
import csv
from collections import defaultdict
from pathlib import Path
from statistics import mean


def results_by_tracker(folder: Path, gestures: list[str]) -> dict[str, list[dict[str, str]]]:
    groups = defaultdict(list)
    with (folder / "results.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            if not gestures or row["gesture"] in gestures:
                groups[row["subject"]].append(row)
    return groups


def mean_r2(rows: list[dict[str, str]], curve: str) -> float:
    return mean(float(row[f"r2_zero_{curve}"]) for row in rows)


def lost(rows: list[dict[str, str]]) -> int:
    return sum(row["recognised"] != row["gesture"] for row in rows)


def line(tracker: str, with_task: list[dict[str, str]], without_task: list[dict[str, str]]) -> str:
    r2s = mean_r2(with_task, "measured"), mean_r2(with_task, "synthesised"), mean_r2(without_task, "synthesised")
    cells = [tracker, str(len(with_task)), *(f"{r2:.3f}" for r2 in r2s)]
    return f"| {' | '.join(cells)} | {lost(with_task)}, {lost(without_task)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", type=Path, required=True, help="evaluation with --context scene")
    parser.add_argument("--open", type=Path, required=True, help="the same set with --context open")
    parser.add_argument("--gesture", action="append", default=[])
    options = parser.parse_args()
    with_task, without_task = (results_by_tracker(folder, options.gesture) for folder in (options.scene, options.open))
    print("| tracker | trials | measured | with a task | without a task | lost |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for tracker, rows in with_task.items():
        print(line(tracker.replace("_", " "), rows, without_task[tracker]))


if __name__ == "__main__":
    main()
