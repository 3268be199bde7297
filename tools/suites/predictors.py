"""The compared predictors against closed forms, and their metrics against the core's."""

import csv
import json
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from peers import promp, ridge
from peers.comparison import read_curves
from peers.frozen_frames import FrozenFrames
from peers.metrics import compare
from peers.minimum_jerk import MinimumJerk, minimum_jerk
from peers.predictor import SENSOR_LATENCY_S, Hold, Predictor, follow
from peers.trials import Trial, read_trials
from suites.outcome import Outcome
from suites.process import ROOT, run
from suites.scenes import build

DURATION_S = 0.8
CONDITIONS = ("measured", "average", "one_euro", "kalman", "synthesised")


def outcomes() -> Iterator[Outcome]:
    yield minimum_jerk_is_found(DURATION_S, 1e-4)
    yield minimum_jerk_is_found(0.5, 5e-3)
    yield from ridge_goes_on()
    yield primitive_is_learned()
    yield from promp_is_gaussian_conditioning()
    yield frozen_frames_are_detected()
    yield from causality()
    yield refusal()
    yield unreadable()
    with tempfile.TemporaryDirectory(prefix="steadyhand_predictors") as folder:
        yield from metrics_as_in_core(Path(folder))


def minimum_jerk_is_found(duration_s: float, tolerance: float) -> Outcome:
    """The prior's mean is DURATION_S, which biases other durations slightly."""
    onset_s, predictor = 0.513, MinimumJerk(DURATION_S)
    for t_s in np.arange(0.0, onset_s + 0.6 * duration_s, 0.01):
        predictor.observe(t_s, float(minimum_jerk((t_s - onset_s) / duration_s)))
    times_s = t_s + np.linspace(0.0, 0.6, 61)
    wanted = minimum_jerk((times_s + SENSOR_LATENCY_S - onset_s) / duration_s)
    error = np.max(np.abs(predictor.predict(times_s) - wanted))
    name = f"predictors/minimum jerk: a movement of {duration_s} s is predicted from 60 % on"
    return Outcome.of(name, error < tolerance, f"error {error}, not below {tolerance}")


def trial_of(t_s: np.ndarray, value: np.ndarray, name: str = "") -> Trial:
    """A trial whose reference equals the measured track."""
    return Trial(name, "tap", "stable", 0.1, float(t_s[0]), float(t_s[-1]), t_s, value, t_s, value)


def ridge_goes_on() -> Iterator[Outcome]:
    t_s = np.arange(0.0, 1.0, 0.01)
    coefficients = ridge.train_ridge([trial_of(t_s, speed * t_s) for speed in (-1.0, 0.5, 2.0)])
    wanted = np.tile([1.0 / (1.0 + ridge.PENALTY), 0.0], (len(coefficients), 1))
    good = np.allclose(coefficients, wanted, atol=1e-6)
    yield Outcome.of(
        "predictors/ridge: hands of constant speed give a = 1 / (1 + penalty), b = 0", good, f"{coefficients}"
    )
    predictor = ridge.Ridge(wanted)
    for time_s in t_s:
        predictor.observe(time_s, 0.2 + 1.5 * time_s)
    ahead_s = np.array([0.0, 0.05, 0.2])
    found = predictor.predict(t_s[-1] + ahead_s)
    line = 0.2 + 1.5 * (t_s[-1] + wanted[0, 0] * (ahead_s + SENSOR_LATENCY_S))
    yield Outcome.of(
        "predictors/ridge: a constant speed continues", np.allclose(found, line, atol=1e-6), f"{found} {line}"
    )
    of_hand = ridge.derivatives(t_s, 0.3 + 0.7 * t_s + 2.0 * t_s**2)
    good = np.allclose(of_hand, [0.7 + 4.0 * t_s[-1], 4.0])
    yield Outcome.of("predictors/ridge: velocity and acceleration of a parabola are exact", good, f"{of_hand}")


def primitive_is_learned() -> Outcome:
    """Hands that differ by +1 or -1 of one shape."""
    mean, shape = minimum_jerk(promp.PHASES), 0.1 * np.sin(np.pi * promp.PHASES)
    primitive = promp.Primitive.of(np.array([mean + sign * shape for sign in (1.0, -1.0, 1.0, -1.0)]))
    modes = primitive.modes * np.sign(primitive.modes[:, 50:51])
    good = np.allclose(primitive.mean, mean) and np.allclose(modes[0], shape) and np.allclose(modes[1], 0.0)
    return Outcome.of("predictors/ProMP: mean and mode of training hands are recovered", good, f"{primitive}")


def some_primitive() -> promp.Primitive:
    phases = promp.PHASES
    curves = [minimum_jerk(phases) + a * phases**2 * (1.0 - phases) + b * phases for a, b in np.eye(4, 2) * 0.2]
    return promp.Primitive.of(np.array(curves))


def promp_is_gaussian_conditioning() -> Iterator[Outcome]:
    """One hypothesis: state and marginal likelihood after many frames, against one dense Gaussian over all of them."""
    random = np.random.default_rng(3)
    t_s = np.cumsum(random.uniform(0.005, 0.03, size=40))
    seen = minimum_jerk((t_s - 0.1) / 0.6) + random.normal(0.0, 0.01, size=len(t_s))
    for kind, name in ((promp.SOUND, "sound"), (promp.FAULTY, "faulty")):
        one = promp.ProMP(some_primitive(), 0.6)
        for row in ("duration_s", "log_weight", "mean", "covariance"):
            setattr(one, row, getattr(one, row)[:1])
        one.onset_s, one.kind, one.log_weight = np.array([0.12]), np.array([kind]), np.zeros(1)
        deviation, deviation_s = promp.DEVIATION[kind], promp.DEVIATION_S[kind]
        one.covariance[0, -1, -1] = deviation**2
        prior = one.covariance[0].copy()
        variance = 0.01**2
        mean, rows = one.linear(t_s[:, None])
        mean, rows = mean[:, 0], rows[:, 0, :-1]
        for before_s, time_s, value in zip([t_s[0], *t_s], t_s, seen, strict=False):
            one.drift(time_s - before_s)
            one.update(time_s, value, variance)
        kernel = deviation**2 * np.exp(-np.abs(t_s[:, None] - t_s) / deviation_s)
        covariance = rows @ prior[:-1, :-1] @ rows.T + kernel + variance * np.eye(len(t_s))
        across = np.vstack([prior[:-1, :-1] @ rows.T, kernel[-1]])
        wanted = across @ np.linalg.solve(covariance, seen - mean)
        wanted_covariance = prior - across @ np.linalg.solve(covariance, across.T)
        off = seen - mean
        determinant = np.linalg.slogdet(2.0 * np.pi * covariance)[1]
        wanted_log = len(t_s) * np.log(1.0 - promp.OUTLIERS) - 0.5 * (
            off @ np.linalg.solve(covariance, off) + determinant
        )
        good = np.allclose(one.mean[0], wanted) and np.allclose(one.covariance[0], wanted_covariance)
        title = f"predictors/ProMP: a hypothesis with a {name} tracker is a dense Gaussian's posterior"
        yield Outcome.of(title, good, f"{one.mean[0]} {wanted}")
        title = f"predictors/ProMP: its weight with a {name} tracker is the marginal likelihood"
        yield Outcome.of(title, np.isclose(one.log_weight[0], wanted_log), f"{one.log_weight[0]} {wanted_log}")


def frozen_frames_are_detected() -> Outcome:
    frames = FrozenFrames()
    values = [0.0] * 10 + [0.01 * i for i in range(1, 11)] + [0.1] * 10
    frozen = [frames.is_frozen(0.01 * i, value) for i, value in enumerate(values)]
    first = frozen.index(True) if True in frozen else -1
    good = first in (23, 24) and all(frozen[24:])  # 30 ms after the last change, at frame 19 or 20 by rounding
    return Outcome.of("predictors/frozen frames: a hand at rest has none, a moving one has", good, f"{frozen}")


def causality() -> Iterator[Outcome]:
    """Later frames do not change earlier output, to the last bit."""
    random = np.random.default_rng(4)
    t_s = np.delete(np.arange(0.0, 1.2, 0.01), range(60, 75))
    value = minimum_jerk((t_s - 0.3) / 0.6) + random.normal(0.0, 0.01, size=len(t_s))
    times_s = np.arange(0.0, 1.2, 0.001)
    coefficients = ridge.train_ridge([trial_of(t_s, value)])
    makers = {
        "hold": Hold,
        "ridge": lambda: ridge.Ridge(coefficients),
        "minimum jerk": lambda: MinimumJerk(DURATION_S),
        "ProMP": lambda: promp.ProMP(some_primitive(), DURATION_S),
    }
    for name, make in makers.items():
        whole, _ = follow(make(), trial_of(t_s, value), times_s)
        equal = [is_prefix(make(), t_s, value, cut_s, times_s, whole) for cut_s in (0.35, 0.62, 0.9)]
        yield Outcome.of(f"predictors/{name}: a cut track gives the same output before the cut", all(equal), f"{equal}")


def is_prefix(
    predictor: Predictor, t_s: np.ndarray, value: np.ndarray, cut_s: float, times_s: np.ndarray, whole: np.ndarray
) -> bool:
    kept, before = t_s <= cut_s, times_s <= cut_s
    cut, _ = follow(predictor, trial_of(t_s[kept], value[kept]), times_s[before])
    return bool(np.array_equal(cut, whole[before]))


def refusal() -> Outcome:
    """Files of the user in the output folder stay."""
    with tempfile.TemporaryDirectory(prefix="steadyhand_predictors") as folder:
        own = [Path(folder, "trials.csv"), Path(folder, "work/mine.txt")]
        for path in own:
            path.parent.mkdir(exist_ok=True)
            path.touch()
        command = [sys.executable, "-m", "peers", "--trials", folder, "--train", folder, "--out", folder]
        status, output = run(command, PYTHONPATH=str(ROOT / "tools"))
        kept = [path for path in Path(folder).rglob("*") if path.is_file()]
    good = status == 2 and "is what ridge and ProMP are trained on" in output and sorted(kept) == own
    return Outcome.of("predictors/bench predictors: refuses to evaluate its training set", good, f"{kept}\n{output}")


def unreadable() -> Outcome:
    with tempfile.TemporaryDirectory(prefix="steadyhand_predictors") as folder:
        path = Path(folder) / "trials.csv"
        path.write_text("trial,gesture\na,tap\n")
        try:
            message = f"{read_trials(Path(folder))}"
        except SystemExit as error:
            message = str(error)
    good = message.startswith(f"{path}: no trial set: ")
    return Outcome.of("predictors/trials: a set without its columns gives the path and the reason", good, message)


def metrics_as_in_core(folder: Path) -> Iterator[Outcome]:
    """One simulated person: zero-lag R2, T_diff and missed of each curve, against results.csv and summary.json."""
    status, output = build()
    trials, out = folder / "trials", folder / "out"
    gestures = "horizontal_drag,tap,vertical_drag,zoom"
    for tool in (
        ["make_trials", "--", "--out", trials, "--gestures", gestures, "--subjects", 1, "--trials-per-subject", 1],
        ["evaluate", "--", "--trials", trials, "--out", out],
    ):
        if status == 0:
            script = ["--script", f"res://tools/{tool[0]}.gd", *tool[1:]]
            status, output = run([os.environ["GODOT"], "--headless", "--path", "demo_project", *script])
    if status != 0:
        yield Outcome.of("predictors/metrics: a trial set is evaluated", False, output)
        return
    with (out / "results.csv").open(newline="") as file:
        results = {row["trial"]: row for row in csv.DictReader(file)}
    summary = json.loads((out / "summary.json").read_text())
    missed = {
        condition: sum(group["conditions"][condition]["missed"] for group in summary["groups"])
        for condition in CONDITIONS
    }
    found, wanted, counted, apart = [], [], dict.fromkeys(CONDITIONS, 0), 0.0
    for trial in read_trials(trials):
        curves = read_curves(out / f"{trial.name}.curves.csv")
        apart = max(apart, np.max(np.abs(curves["reference"] - trial.reference_at(curves["t"]))))
        for condition in CONDITIONS:
            of = compare(curves["t"], curves["reference"], curves[condition], trial.start_s, trial.end_s)
            found.append([of.r2_zero, of.t_diff_s])
            wanted.append([float(results[trial.name][f"{what}_{condition}"]) for what in ("r2_zero", "t_diff")])
            counted[condition] += of.missed
    good = len(found) == 8 * len(CONDITIONS) and np.allclose(found, wanted, rtol=0.0, atol=2e-6)
    yield Outcome.of("predictors/metrics: zero-lag R2 and T_diff as in results.csv", good, f"{found}\n{wanted}")
    yield Outcome.of("predictors/metrics: missed as in summary.json", counted == missed, f"{counted} {missed}")
    yield Outcome.of("predictors/trials: the reference is the curve of evaluate", apart < 1e-6, f"{apart}")
