"""Compares `phase` mode with raw data, filters and three published predictors, and writes the tables."""

import argparse
import json
import tempfile
from pathlib import Path

from peers.comparison import compare_all
from peers.table import as_markdown, write_csv
from peers.training import REAL, Trained
from results.evaluation import ROOT, Evaluation, run_all
from results.made_trials import make_gesture_trials

RECORDED = [ROOT.parent / "shared/real/drags", ROOT.parent / "shared/cases"]


def main() -> None:
    parser = argparse.ArgumentParser(prog="./steadyhand bench predictors", description=__doc__)
    parser.add_argument("--trials", type=Path, action="append", metavar="DIR", help="trial set, once or more")
    parser.add_argument("--train", type=Path, default=REAL, metavar="DIR", help="trial set for ridge and ProMP")
    parser.add_argument("--subjects", type=int, default=12, metavar="N", help="simulated people, where no set is given")
    parser.add_argument("--out", type=Path, default=ROOT / "build/predictors", metavar="DIR", help="for the tables")
    given = parser.parse_args()
    out = given.out.resolve()  # Godot runs in another folder
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="work_", dir=out) as work:
        text = compare(parser, given, Path(work), out)
    print(f"\n{text}\nwrote {out / 'predictors.md'} and predictors.csv")


def compare(parser: argparse.ArgumentParser, given: argparse.Namespace, work: Path, out: Path) -> str:
    folders = [folder.resolve() for folder in given.trials or recorded_and_synthetic(work, given.subjects)]
    for folder in folders:
        if not (folder / "trials.csv").is_file():
            parser.error(f"no trials.csv in {folder}")
        if folder == given.train.resolve():
            parser.error(f"{folder} is what ridge and ProMP are trained on: name another set with --train or --trials")
    if len({folder.name for folder in folders}) < len(folders):
        parser.error("two of the trial sets have the same name")
    trained = Trained.of(given.train, work)
    evaluations = {folder.name: Evaluation(folder, "phase", "scene", work / folder.name, True) for folder in folders}
    run_all(list(evaluations.values()))
    sets = {name: compare_all(of.trials, of.out, trained) for name, of in evaluations.items()}

    text = as_markdown(sets, trained.source)
    (out / "predictors.md").write_text(text)
    write_csv(out / "predictors.csv", sets)
    return text


def recorded_and_synthetic(work: Path, subjects: int) -> list[Path]:
    """Simulated people of the population `evaluate`, and the recorded sets that are there."""
    gestures = [json.loads(model.read_text())["gesture"] for model in sorted((ROOT / "models").glob("*.gesture"))]
    synthetic = work / "synthetic"
    make_gesture_trials(synthetic, gestures, subjects)
    return [synthetic, *(folder for folder in RECORDED if (folder / "trials.csv").is_file())]


if __name__ == "__main__":
    main()
