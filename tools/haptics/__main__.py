#!/usr/bin/env python3
"""Measures the vibration from the outside and writes the tables into docs/haptics_measured.md."""

import argparse
import shutil
import subprocess
from pathlib import Path

from haptics import live, page, trials
from page_tables import fill
from results.evaluation import ROOT, run_tool

REAL = ROOT.parent / "shared/real/drags"
PAGE = ROOT / "docs/haptics_measured.md"
RATES_HZ = [44100, 8000, 48000, 96000, 192000]
GESTURES = "horizontal_drag,vertical_drag,tap,zoom"


def main() -> None:
    parser = argparse.ArgumentParser(prog="haptics", description=__doc__)
    parser.add_argument("--page", type=Path, default=PAGE, help="page whose tables are replaced")
    parser.add_argument("--work", type=Path, default=ROOT / "build/haptics", help="for trials and recordings")
    parser.add_argument("--rates", type=int, nargs="+", default=RATES_HZ, help="mix rates (Hz)")
    parser.add_argument("--subjects", type=int, default=6, help="simulated people")
    parser.add_argument("--minutes", type=float, default=60.0, help="length of play through the nodes")
    parser.add_argument("--real", type=Path, default=REAL, help="trial set of real hands")
    parser.add_argument("--programs", type=Path, help="folder of the benchmarks; without it they are left out")
    given = parser.parse_args()

    shutil.rmtree(given.work, ignore_errors=True)
    synthetic = given.work / "trials"
    options = {"out": synthetic, "gestures": GESTURES, "subjects": given.subjects, "trials-per-subject": 2}
    run_tool("make_trials", options)
    sets = {"synthetic": synthetic}
    if given.real.is_dir():
        sets["real"] = given.real
    tables = {"live": page.live_tables(live.measure(given.rates, synthetic, given.work))}
    felt = {}
    for name, folder in sets.items():
        print(f"vibration of the {name} trials", flush=True)
        felt[name] = trials.measure(folder, given.work / f"felt_{name}")
    tables["trials"] = page.trials_table(felt)
    print(f"{given.minutes:g} minutes of play", flush=True)
    outputs = []
    for program in ("bench_vibration", "soak_vibration") if given.programs else ():
        outputs.append(subprocess.run([given.programs / program], check=True, capture_output=True, text=True).stdout)
    run_tool("soak", {"trials": synthetic, "minutes": given.minutes}, on_line=outputs.append)
    tables["cost"] = page.as_text(outputs)
    fill(given.page, tables)
    for recording in [*given.work.rglob("*.wav"), *given.work.rglob("*.f32")]:
        recording.unlink()
    print(f"wrote {given.page}")


if __name__ == "__main__":
    main()
