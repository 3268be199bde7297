"""Trials of simulated people that were not used for training or tuning."""

from pathlib import Path

from results.evaluation import run_tool

# Their own pace, faster, very fast, and slower.
PACES = [1.0, 0.6, 0.4, 1.6]
# Other motion of the same people: long enough to distinguish 0.2 false alarms per minute from none.
OTHER_MOTION_S = 20.0


def at_all_paces(subjects: int) -> dict[str, object]:
    return {"subjects": subjects, "trials-per-subject": len(PACES), "paces": ",".join(str(pace) for pace in PACES)}


def make_gesture_trials(folder: Path, gestures: list[str], subjects: int) -> None:
    """One set of gestures."""
    run_tool("make_trials", {"out": folder, "gestures": ",".join(gestures), **at_all_paces(subjects)})


def make_trials(folder: Path, gestures: list[str], subjects: int) -> None:
    """One set of gestures and other motion; the latter is longer."""
    make_gesture_trials(folder, gestures, subjects)
    gesture_rows = (folder / "trials.csv").read_text()
    run_tool("make_trials", {"out": folder, "gestures": "none", "duration": OTHER_MOTION_S, **at_all_paces(subjects)})
    other_rows = (folder / "trials.csv").read_text()
    (folder / "trials.csv").write_text(gesture_rows + other_rows.partition("\n")[2])


def make_timed_trials(
    folder: Path, gestures: list[str], subjects: int, duration_s: float | None = None, earlier_rounds: int = 0
) -> None:
    """A trial of each person, gesture and position; at their own pace, unless the duration is given."""
    timed = {} if duration_s is None else {"duration": duration_s}
    common = {"subjects": subjects, "trials-per-subject": 1, "earlier-rounds": earlier_rounds, **timed}
    run_tool("make_trials", {"out": folder, "gestures": ",".join(gestures), **common})
