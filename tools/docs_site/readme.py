"""The README's table and moving picture, from what `./steadyhand demo` leaves in its folder."""

import csv
import shutil
import statistics
from pathlib import Path

from page_tables import fill, table

ROOT = Path(__file__).resolve().parents[2]
CONDITIONS = {"measured": "raw tracker", "one_euro": "One Euro filter", "synthesised": "SteadyHand"}
SETS = {"real": "recorded hands", "synthetic": "simulated hands"}
PICTURE = "motion.gif"


def update(demo: Path) -> None:
    """demo: the folder. Raises SystemExit if a file is missing there."""
    picture, folder = demo / PICTURE, demo / "evaluation"
    missing = [path for path in (picture, folder) if not path.exists()]
    if missing:
        raise SystemExit(f"{missing[0]} is not there: run ./steadyhand demo --out {demo} first")
    shutil.copyfile(picture, ROOT / "docs/images" / PICTURE)
    fill(ROOT / "README.md", {"figures": table(["position of the hand", "trials", *CONDITIONS.values()], rows(folder))})


def rows(folder: Path) -> list[list[str]]:
    """For each set and position: median and worst zero-lag R2 of each condition over all gestures."""
    found = []
    for name, title in SETS.items():
        path = folder / name / "results.csv"
        if not path.exists():
            continue
        with path.open(newline="") as file:
            trials = [row for row in csv.DictReader(file) if row["r2_zero_synthesised"]]
        for position in ("unstable", "stable"):
            own = [row for row in trials if row["position"] == position]
            cells = []
            for condition in CONDITIONS:
                values = [float(row[f"r2_zero_{condition}"]) for row in own]
                cells.append(f"{statistics.median(values):.3f} / {min(values):.2f}")
            found.append([f"{position}, {title}", str(len(own)), *cells])
    return found
