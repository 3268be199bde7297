#!/usr/bin/env python3
"""Evaluates on synthetic people and on recorded real hands, if they are there, and writes the pages of results."""

import argparse
import json
import os
import shutil
from pathlib import Path

from commit import commit_of
from peers.comparison import compare_all
from peers.table import as_markdown
from peers.training import Trained
from plots.box_plots import draw_box_plots
from plots.confusion import draw_confusions
from plots.speed import draw_speed
from plots.trials import draw_small_multiples, draw_trial
from results.evaluation import ROOT, run_all
from results.goals import goals
from results.made_trials import PACES, make_timed_trials, make_trials
from results.other_hands import OtherHands
from results.page import write_pages
from results.rounds import EARLIER_ROUNDS, Rounds
from results.sensors import Sensors
from results.speed import DURATIONS_S, Speed
from results.study import Study

REAL = ROOT.parent / "shared/real/drags"
# Folders beside REAL with other motion, and a description.
OTHER_HANDS = {
    "lm_digits": "an index finger that writes digits into the air, 10 to 20 cm tall",
    "leapjs_playback": "hands that splay, pinch, clap, wave, paddle, tap on a table, roll, move about",
}
SOURCES = ["extension", "models", "demo_project", "tools/results", "tools/peers"]
WORST = 6
TYPICAL = ("horizontal_drag", "unstable")


def main() -> None:
    parser = argparse.ArgumentParser(prog="results", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "docs", help="folder of results*.md and images/")
    parser.add_argument("--work", type=Path, default=ROOT / "build/results", help="for trials and evaluations")
    parser.add_argument("--subjects", type=int, default=12, help="simulated people")
    parser.add_argument("--real", type=Path, default=REAL, help="trial set of real hands")
    parser.add_argument("--durations", type=seconds, default=DURATIONS_S, help="of gestures (s): 0.15,0.6")
    given = parser.parse_args()

    models = sorted((ROOT / "models").glob("*.gesture"))
    gestures = [json.loads(model.read_text())["gesture"] for model in models]
    shutil.rmtree(given.work, ignore_errors=True)
    print("making trials", flush=True)
    synthetic = given.work / "trials"
    make_trials(synthetic, gestures, given.subjects)
    timed = {duration: given.work / f"trials_{duration:g}s" for duration in given.durations}
    for duration, folder in timed.items():
        make_timed_trials(folder, gestures, given.subjects, duration)
    unhurried = given.work / "trials_unhurried"
    make_timed_trials(unhurried, gestures, given.subjects)
    after_others = given.work / "trials_after_others"
    make_timed_trials(after_others, gestures, given.subjects, earlier_rounds=EARLIER_ROUNDS)
    studies = [Study.of("synthetic", synthetic, given.work)]
    if given.real.is_dir():
        studies.append(Study.of("real", given.real, given.work))
    speed = Speed.of(timed, given.work / "speed")
    rounds = Rounds.of({0: unhurried, EARLIER_ROUNDS: after_others}, given.work / "rounds")
    sensors = Sensors.of(unhurried, given.work / "sensors")
    others = [
        OtherHands.of(folder, what, given.work / "other_hands")
        for name, what in OTHER_HANDS.items()
        if (folder := given.real.parent / name).is_dir()
    ]
    evaluations = [evaluation for study in studies for evaluation in study.evaluations()]
    apart = [*speed.evaluations(), *rounds.evaluations(), *sensors.evaluations()]
    run_all([*evaluations, *apart, *(other.evaluation for other in others)])

    images = given.out / "images"
    images.mkdir(parents=True, exist_ok=True)
    sets = {study.name: describe(study, given.subjects) for study in studies}
    sets.setdefault("real", "their recordings are not there.")
    pictures = draw(studies, images)
    draw_speed(images / "results_speed.png", given.durations, speed.values, speed.recognised)
    for model in models:
        picture = os.path.relpath(model.with_suffix(".png"), given.out)
        pictures[f"model {model.stem}"] = f"![The model {model.stem}]({picture})"
    trained = Trained.of(given.real.parent / "drags_train", given.work)
    scenes = {study.name: study.scene["phase"] for study in studies}
    compared = {name: compare_all(scene.trials, scene.out, trained) for name, scene in scenes.items()}
    predictors = as_markdown(compared, trained.source)
    write_pages(
        given.out,
        studies,
        list(goals(studies, compared, others)),
        predictors,
        speed,
        rounds,
        sensors,
        others,
        pictures,
        origin(studies[0]),
        sets,
    )
    for evaluation in evaluations:
        evaluation.drop_curves()
    print(f"wrote {given.out / 'results.md'}, results_motion.md and results_conditions.md")


def seconds(text: str) -> list[float]:
    return [float(number) for number in text.split(",")]


def describe(study: Study, subjects: int) -> str:
    summary = study.scene["phase"].summary
    trials = sum(group["trials"] for group in summary["groups"])
    if study.name == "real":
        return (
            f"{trials} aimed 20 cm moves of recorded hands. Stable: as tracked. Unstable: with recorded tracker errors "
            "added. They serve evaluation only, and are not in the repository."
        )
    paces = ", ".join(f"{pace:g}" for pace in PACES)
    return (
        f"{trials} trials of {subjects} simulated people in front of a simulated sensor. They make each gesture in "
        f"{paces} times their own duration. No model was trained or tuned on these people. Among the trials are "
        f"{summary['none_minutes']:.0f} minutes of other motion."
    )


def origin(study: Study) -> str:
    """The version, and the last commit of the sources of the figures."""
    settings = study.scene["phase"].summary["settings"]
    return f"SteadyHand {settings['version']}, Godot {settings['godot']}{commit_of(SOURCES)}."


def draw(studies: list[Study], images: Path) -> dict[str, str]:
    """Markdown of each picture by its name, which begins with the name of its set."""
    pictures = {}

    def add(name: str, file: str, caption: str) -> Path:
        pictures[name] = f"![{caption}](images/{file})"
        return images / file

    for study in studies:
        for gesture in study.gestures():
            title = f"{gesture.replace('_', ' ')}, {study.name}"
            file = f"results_{study.name}_{gesture}.png"
            path = add(f"{study.name} boxes {gesture}", file, f"R2 and T_diff by condition: {title}")
            draw_box_plots(path, title, lambda p, f, c, s=study, g=gesture: s.values(g, p, f, c))
        scene = study.scene["phase"]
        if typical := scene.typical(*TYPICAL):
            title = f"{study.name}: {typical['trial']}"
            path = add(f"{study.name} typical", f"results_{study.name}_typical.png", f"Curves of {typical['trial']}")
            draw_trial(path, title, study.curves(typical["trial"]))
        worst = scene.ranked("synthesised")[:WORST]
        path = add(f"{study.name} worst", f"results_{study.name}_worst.png", f"The worst {study.name} trials")
        spans = scene.spans()
        draw_small_multiples(
            path, {worst_title(row): (study.curves(row["trial"]), *spans[row["trial"]]) for row in worst}
        )
    tables = {f"{study.name}, phase mode": study.open["phase"].summary["confusion"] for study in studies}
    draw_confusions(
        add("confusion", "results_confusion.png", "Confusion tables of `phase` mode, without a task"), tables
    )
    return pictures


def worst_title(row: dict) -> str:
    return f"{row['trial']}\nzero-lag R² {row['r2_zero_synthesised']:.3f}, measured {row['r2_zero_measured']:.3f}"


if __name__ == "__main__":
    main()
