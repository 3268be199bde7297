"""The table of the trackers of tools/tuning/plain_hands.py, from what `./steadyhand evaluate` left in both contexts.

    python tools/tuning/plain_hands_table.py --scene DIR --open DIR [--gesture NAME]...

Mean R2 at no lag of what was measured, counted from the task's start, and of the synthesised curve with each trial's
task given and with nothing given, where no curve moves before a gesture is found; and how many gestures were lost
(none recognised, or another one), with the task given and with nothing given. Of all gestures, or of those named.
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


def line(tracker: str, task_given: list[dict[str, str]], nothing_given: list[dict[str, str]]) -> str:
    r2s = mean_r2(task_given, "measured"), mean_r2(task_given, "synthesised"), mean_r2(nothing_given, "synthesised")
    cells = [tracker, str(len(task_given)), *(f"{r2:.3f}" for r2 in r2s)]
    return f"| {' | '.join(cells)} | {lost(task_given)}, {lost(nothing_given)} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", type=Path, required=True, help="evaluated with --context scene")
    parser.add_argument("--open", type=Path, required=True, help="the same set with --context open")
    parser.add_argument("--gesture", action="append", default=[])
    given = parser.parse_args()
    task_given, nothing_given = (results_by_tracker(folder, given.gesture) for folder in (given.scene, given.open))
    print("| tracker | trials | measured | task given | nothing given | lost |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for tracker, rows in task_given.items():
        print(line(tracker.replace("_", " "), rows, nothing_given[tracker]))


if __name__ == "__main__":
    main()
