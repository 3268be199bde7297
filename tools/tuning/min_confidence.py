"""Prints the effect of GestureHMM.min_confidence: trial sets without a task, at several values of it.

    python tools/tuning/min_confidence.py --out DIR SET...

For the gestures of a set: mean zero-lag R2, stable and unstable, and detection rate. For its other motion: starts per
minute, fraction of time with an active gesture, and false alarms per minute.
"""

import argparse
import json
import subprocess
from pathlib import Path
from statistics import mean

ROOT = Path(__file__).resolve().parents[2]
VALUES = (0.0, 0.02, 0.2, 0.5, 0.8)
NONE = "none"
HEADER = """\
| trials | min_confidence | stable | unstable | detected | starts per minute | active | false alarms per minute |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"""


def evaluate(trials: Path, value: float, out: Path) -> dict:
    command = [ROOT / "steadyhand", "evaluate", "--trials", trials, "--out", out, "--context", "open"]
    subprocess.run([*command, "--min-confidence", str(value)], check=True, stdout=subprocess.DEVNULL)
    return json.loads((out / "summary.json").read_text())


def gestures(summary: dict) -> list[str]:
    groups = [group for group in summary["groups"] if group["gesture"] != NONE]
    if not groups:
        return ["", "", ""]
    cells = []
    for position in ("stable", "unstable"):
        r2s = [
            group["conditions"]["synthesised"]["r2_zero"]["mean"] for group in groups if group["position"] == position
        ]
        cells.append(f"{mean(r2s):.3f}" if r2s else "")
    recognised, trials = (sum(group[key] for group in groups) for key in ("recognised", "trials"))
    return [*cells, f"{100 * recognised / trials:.1f} %"]


def other_motion(summary: dict) -> list[str]:
    if summary["none_minutes"] == 0:
        return ["", "", ""]
    share = f"{100 * summary['under_way_share']:.0f} %"
    return [f"{summary['begun_per_minute']:.1f}", share, f"{summary['false_alarms_per_minute']:.2f}"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trials", type=Path, nargs="+", metavar="SET")
    parser.add_argument("--out", type=Path, required=True, help="for the evaluations")
    options = parser.parse_args()
    print(HEADER, flush=True)
    for number, trials in enumerate(options.trials):
        for value in VALUES:
            summary = evaluate(trials, value, options.out / f"{number}_{value:g}")
            name = trials.parent.name if trials.name == "trials" else trials.name
            cells = [name, f"{value:g}", *gestures(summary), *other_motion(summary)]
            print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
