"""Makes one trial set with the errors of each of the other sensors of docs/results.md.

python tools/tuning/other_sensors.py --trials DIR --out DIR
"""

import argparse
import csv
import shutil
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from results.sensors import SENSORS, write_trials


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    with (options.trials / "trials.csv").open(newline="") as file:
        header, *trials = csv.reader(file)
    options.out.mkdir(parents=True)
    rows = [header]
    for number, (name, sensor) in enumerate(list(SENSORS.items())[1:]):
        with tempfile.TemporaryDirectory() as place:
            write_trials(options.trials, Path(place) / "set", sensor)
            for trial, *rest in trials:
                for track in ("measured", "reference"):
                    shutil.move(Path(place) / f"set/{trial}.{track}.csv", options.out / f"{trial}_{number}.{track}.csv")
                rows.append([f"{trial}_{number}", *rest])
        print(f"{number}: {name}")
    with (options.out / "trials.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


if __name__ == "__main__":
    main()
