"""Writes docs/results*.md, with all numbers and marks."""

from pathlib import Path
from textwrap import fill

from results.goals import Goal
from results.other_hands import OtherHands
from results.rounds import Rounds
from results.sensors import Sensors
from results.speed import Speed
from results.study import MODES, Study
from results.tables import conditions_table, open_table, others_table, rounds_table, sensors_table, speed_table, table
from whole_file import whole

HEAD = """# Results

`./steadyhand results` makes every number and picture of this page. Two more pages have the details:
[motion in each condition](results_motion.md), and [speed, repetition and sensors](results_conditions.md).

{sets}
- **made with**: {origin}

| word | meaning |
| --- | --- |
| stable, unstable | position of the hand in front of the sensor: it tracks well there, or badly |
| with a task | only the trial's model is active, and the task's start, axis and length are known (`--context scene`) |
| without a task | all models are active, and no task is known (`--context open`) |
| R2 | of a curve against the reference sensor's curve, at the lag within ±0.5 s that fits best. 1: equal |
| zero-lag R2 | the same without a shift. It counts what a user feels at each instant |
| T_diff | end of the reference minus end of the curve. Positive: the curve ends early |
| missed | the curve never reaches its end. T_diff then counts with the end of the record |
| worst 5 % | the 5th percentile of the trials |
"""

WIDTH = 120
REACHED = {True: "reached", False: "**not reached**"}

GOALS = """## Goals

`phase` mode, the default. It reaches {reached} of {judged} goals.

- *Best predictor*: the best of One Euro, Kalman, ridge, minimum jerk and ProMP ([table](#other-predictors)).
- The goals at stable positions are for real hands. A simulated sensor has a constant latency, which no motion shows.
- Half of the synthetic taps go down, the others forward. [Recognition](recognition.md) has both apart.
- Single faults, short tasks and sudden stops have goals of their own: `tests/core/matrix/bounds.h`.

{table}
"""

SET = """## {title}, with a task

{text}

{table}
"""

PREDICTORS = """## Other predictors

Filters and published predictors ([method](method.md#compared-conditions)) on the same frames, with a task.
{text}"""

WITHOUT_A_TASK = """## Without a task

{picture}
"""

OTHERS = """### Real hands that make no gesture

Without a task, in `phase` mode. Every gesture that ends is a false alarm. Some of these motions look like a gesture:
the stroke of a 1 is straight and 20 cm long.

{table}
"""

MOTION_HEAD = """# Results: motion

The motion of each gesture in each condition. `./steadyhand results` makes this page. [Results](results.md) explains the
words and the sets. R2 of *measured* at the best lag is the limit of a filter that knows only the sensor's lag.
"""

TYPICAL = """## A typical unstable trial

The trial whose measured curve has the median zero-lag R2.
"""

WORST = """## The worst trials

The six trials with the lowest zero-lag R2 of `phase` mode, the worst first. Dotted lines: start and end of the gesture.
"""

CONDITIONS_HEAD = """# Results: speed, repetition and sensors

The same simulated people make the gestures under other conditions. `./steadyhand results` makes this page.
[Results](results.md) explains the words. *Recognised* is without a task. All other figures are with a task.
"""

SPEED = """## Speed

Gestures of one duration, from onset to end. All gestures together.

![Figures of a trial against the duration of the gesture](images/results_speed.png)

{table}
"""

ROUNDS = """## Repetition

The first gesture of a hand, and the same gesture after others of its kind. Between two gestures the hand returns, and
rests for half a second at both ends.

{table}
"""

SENSORS = """## Other sensors

The same simulated sensor with one change. All gestures together. Noise and rounding act on each axis, also in frozen
frames. Jumps and drifts begin at random, every 2 s on average, and last 0.3 s on average. They come at stable positions
too.

{table}
"""


def write_pages(
    folder: Path,
    studies: list[Study],
    goals: list[Goal],
    predictors: str,
    speed: Speed,
    rounds: Rounds,
    sensors: Sensors,
    others: list[OtherHands],
    pictures: dict[str, str],
    origin: str,
    sets: dict[str, str],
) -> None:
    """predictors: text and tables. pictures: Markdown of each by its name. sets: what each set is."""
    bullets = (fill(f"- **{name}**: {text}", WIDTH, subsequent_indent="  ") for name, text in sets.items())
    parts = [HEAD.format(origin=origin, sets="\n".join(bullets))]
    parts.append(goals_part(goals))
    parts.append(PREDICTORS.format(text=predictors))
    parts.append(WITHOUT_A_TASK.format(picture=pictures["confusion"]))
    for study in studies:
        text = f"{study.name.capitalize()}. {false_alarms(study)}".rstrip()
        parts.append(f"{text}\n\n{table(open_table(study))}\n")
    if others:
        parts.append(OTHERS.format(table=table(others_table(others))))
    write(folder / "results.md", parts)

    def of(ending: str) -> list[str]:
        return [f"{picture}\n" for name, picture in pictures.items() if name.endswith(ending)]

    parts = [MOTION_HEAD]
    for study in studies:
        text = "\n\n".join(pictures[name] for name in pictures if name.startswith(f"{study.name} boxes"))
        parts.append(SET.format(title=study.name.capitalize(), text=text, table=table(conditions_table(study))))
    parts += [TYPICAL, *of("typical"), WORST, *of("worst"), "## The models\n"]
    parts += [f"{picture}\n" for name, picture in pictures.items() if name.startswith("model")]
    write(folder / "results_motion.md", parts)
    tables = [(SPEED, speed_table(speed)), (ROUNDS, rounds_table(rounds)), (SENSORS, sensors_table(sensors))]
    parts = [CONDITIONS_HEAD, *(text.format(table=table(rows)) for text, rows in tables)]
    write(folder / "results_conditions.md", parts)


def write(path: Path, parts: list[str]) -> None:
    with whole(path) as part:
        part.write_text("\n".join(parts).rstrip() + "\n")


def goals_part(goals: list[Goal]) -> str:
    lines = [["what", "trials", "paper", "raw", "best predictor", "ours", "aim", ""]]
    for goal in goals:
        cells = [goal.what, goal.trials, goal.paper, goal.raw, goal.best_predictor, goal.ours, goal.aim]
        lines.append([*cells, REACHED[goal.is_reached]])
    reached = sum(goal.is_reached for goal in goals)
    return GOALS.format(reached=reached, judged=len(goals), table=table(lines))


def false_alarms(study: Study) -> str:
    minutes = study.open["phase"].summary["none_minutes"]
    if minutes == 0:
        return ""
    nothing, task = (
        [runs[mode].summary["false_alarms_per_minute"] for mode in MODES] for runs in (study.open, study.scene)
    )
    return (
        f"False alarms a minute, in {minutes:.0f} minutes of other motion without a task: {nothing[0]:.2f} in `paper` "
        f"mode, {nothing[1]:.2f} in `phase` mode. With one task: {task[0]:.2f} and {task[1]:.2f}. This motion is "
        "random, and keeps 30 degrees away from the axis of any drag or tap. Motion of people is harder to reject."
    )
