"""docs/results.md: every number and every mark of it is filled in here."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from textwrap import fill

import numpy as np
from results.other_hands import OtherHands
from results.rounds import Rounds
from results.sensors import Sensors
from results.speed import Speed
from results.study import CONDITIONS, MODES, Study
from results.targets import Target, percent, targets

HEAD = """# Results

Every number and picture on this page is made by `./steadyhand results`, none typed by hand. {origin}

{sets}

*stable*, *unstable*: where the hand is before the sensor. Each trial runs through the real nodes in headless Godot.
*Task given*: only the trial's own model is active, and the start, axis and length of the task are known
(`--context scene`). *Nothing given*: all models, no task (`--context open`). **R2**: of a curve against the reference
sensor's, at the lag within ±0.5 s that fits best, and at no lag. **T_diff**: end of the reference minus end of the
curve; positive: the curve ends early. A curve that never gets there is *missed*, and takes part in T_diff with the
bound that its record gives. **Worst 5 %**: the 5th percentile of the trials. For *measured*, R2 at the best lag is
what a filter that knew the sensor's lag, and nothing else, could come to.
"""

WIDTH = 120
POSITIONS = ["stable", "unstable"]
FIGURES = ["r2", "r2_zero", "lag", "t_diff", "sparc"]
REACHED = {True: "reached", False: "**not reached**"}

TARGETS = """## What is to be reached

`phase` mode, the default. {reached} of {judged} are reached.

{table}

What a frame costs, training, bridging and the vibration are measured elsewhere, not by this command. 
"""

SET = """## {title}

{text}

{table}
"""

PREDICTORS = """## Beside other predictors

Filters and published predictors ([method.md](method.md#compared-conditions)) on the same frames, task given.
{text}"""

SPEED = """## Speed of execution

The same people, asked for gestures of one duration, from onset to end; all gestures together. Recognised: all models
active, nothing given; the rest with the task given.

![Figures of a trial against the duration of the gesture](images/results_speed.png)

{table}
"""

ROUNDS = """## One after another

The same people at their own pace: a gesture that is the hand's first, beside the same execution after others of its
kind. In between the hand comes back, with half a second of rest at either end. Recognised: all models active, nothing
given; the rest with the task given.

{table}
"""

SENSORS = """## Other sensors

The same people at their own pace, before the same simulated sensor, but for what is said of its frames; all gestures
together. Noise and rounding are per axis, and in frozen frames too; jumps and wandering begin at random, every 2 s in
the mean (and 0.3 s), in any direction, where the hand is stable too. Recognised: all models active, nothing given; the
rest with the task given.

{table}
"""

OTHERS = """### Real hands that do something else

Nothing given, `phase` mode. Every gesture that ends counts as a false alarm, though some of what these hands do is one
but for its purpose: the stroke of a 1 is a straight way of 20 cm, and a hand that moves about may go up, stop, and go
to the side.

{table}
"""


def write_page(
    path: Path,
    studies: list[Study],
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
    parts.append(targets_part(list(targets(studies, others)), studies))
    for study in studies:
        title = f"{study.name.capitalize()}, task given"
        text = "\n\n".join(pictures[name] for name in pictures if name.startswith(f"{study.name} boxes"))
        parts.append(SET.format(title=title, text=text, table=table(conditions_table(study))))
    parts.append(PREDICTORS.format(text=predictors))
    parts.append("## A typical unstable trial\n")
    parts.append("The trial whose measured curve has the median R2 at no lag.\n")
    parts += [pictures[name] + "\n" for name in pictures if name.endswith("typical")]
    parts.append("## The worst trials\n")
    parts.append(
        "The six with the lowest R2 at no lag of `phase` mode, the worst first; dotted: start and end of the gesture.\n"
    )
    parts += [pictures[name] + "\n" for name in pictures if name.endswith("worst")]
    parts.append("## Nothing given\n")
    parts.append(pictures["confusion"] + "\n")
    for study in studies:
        text = f"{study.name.capitalize()}. {false_alarms(study)}".rstrip()
        parts.append(f"{text}\n\n{table(open_table(study))}\n")
    if others:
        parts.append(OTHERS.format(table=table(others_table(others))))
    parts.append(SPEED.format(table=table(speed_table(speed))))
    parts.append(ROUNDS.format(table=table(rounds_table(rounds))))
    parts.append(SENSORS.format(table=table(sensors_table(sensors))))
    parts.append("## The models\n")
    parts += [pictures[name] + "\n" for name in pictures if name.startswith("model")]
    path.write_text("\n".join(parts).rstrip() + "\n")


def table(rows: Iterable[list[str]]) -> str:
    """The first row is the header; the first two columns are text, the others numbers."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    columns = lines[0].count("|") - 1
    lines.insert(1, "| " + " | ".join(["---", "---"] + ["---:"] * (columns - 2)) + " |")
    return "\n".join(lines)


def targets_part(rows: list[Target], studies: list[Study]) -> str:
    names = [study.name for study in studies]
    verdicts = [row.verdicts[name] for row in rows for name in names if name in row.verdicts]
    lines = [["what", "paper", "to reach", *(cell for name in names for cell in (name, ""))]]
    for row in rows:
        cells = [row.what, row.paper, row.wanted]
        for name in names:
            verdict = row.verdicts.get(name)
            cells += [verdict.ours, REACHED[verdict.reached]] if verdict else ["-", ""]
        lines.append(cells)
    reached = sum(verdict.reached for verdict in verdicts)
    return TARGETS.format(reached=reached, judged=len(verdicts), table=table(lines))


def conditions_table(study: Study) -> Iterator[list[str]]:
    r2 = ["R2", "worst 5 %", "R2 at no lag", "worst 5 %"]
    yield ["trials", "condition", *r2, "lag", "T_diff", "95 % of T_diff", "missed", "SPARC"]
    for gesture, position in study.groups():
        for condition, title in CONDITIONS.items():
            figures = study.group(gesture, position)[condition]
            is_first = condition == next(iter(CONDITIONS))
            t_diff = figures["t_diff"]
            yield [
                f"{gesture.replace('_', ' ')}, {position}: {figures['n']}" if is_first else "",
                f"**{title}**" if condition == "phase" else title,
                *(f"{figures[name][part]:.3f}" for name in ("r2", "r2_zero") for part in ("mean", "p5")),
                ms(figures["lag"]["median"]),
                ms(t_diff["median"]),
                f"{ms(t_diff['p2_5'])} .. {ms(t_diff['p97_5'])}",
                str(figures["missed"]),
                f"{figures['sparc']['mean']:.2f}",
            ]


def open_table(study: Study) -> Iterator[list[str]]:
    figures = [f"{what}, `{mode}`" for mode in MODES for what in ("recognised", "R2 at no lag", "T_diff", "missed")]
    yield ["gesture", "position", "trials", "measured R2 at no lag", *figures]
    for gesture, position in study.groups():
        group = study.group(gesture, position, "open")
        cells = [gesture.replace("_", " "), position, str(group["phase"]["n"])]
        cells.append(f"{group['measured']['r2_zero']['mean']:.3f}")
        for mode in MODES:
            counts = study.open[mode].group(gesture, position)
            cells.append(percent(counts["recognised"] / counts["trials"]))
            cells.append(f"{group[mode]['r2_zero']['mean']:.3f}")
            cells.append(ms(group[mode]["t_diff"]["median"]))
            cells.append(str(group[mode]["missed"]))
        yield cells


def speed_table(speed: Speed) -> Iterator[list[str]]:
    figures = ["R2", "worst 5 %", "R2 at no lag", "worst 5 %", "lag", "T_diff", "missed", "SPARC", "recognised"]
    yield ["gestures", "condition", *figures]
    for position in POSITIONS:
        for duration in speed.studies:
            for condition in ("measured", *MODES):
                values = {name: speed.values(duration, position, name, condition) for name in FIGURES}
                is_first = condition == "measured"
                trials = len(values["r2"])
                yield [
                    f"{duration:g} s, {position}: {trials}" if is_first else "",
                    f"**{CONDITIONS[condition]}**" if condition == "phase" else CONDITIONS[condition],
                    *(
                        f"{part:.3f}"
                        for name in ("r2", "r2_zero")
                        for part in (np.mean(values[name]), np.percentile(values[name], 5))
                    ),
                    ms(np.median(values["lag"])),
                    ms(np.median(values["t_diff"])),
                    str(speed.missed(duration, position, condition)),
                    f"{np.mean(values['sparc']):.2f}",
                    percent(speed.recognised(duration, position, condition)) if condition in MODES else "",
                ]


def rounds_table(rounds: Rounds) -> Iterator[list[str]]:
    figures = ["measured: R2 at no lag", "`phase`: R2", "at no lag", "T_diff", "missed", "recognised"]
    yield ["gestures", "before", *figures]
    for gesture, position in rounds.groups():
        for count in rounds.task_given:
            of = rounds.figures(count, gesture, position)
            ours = of["synthesised"]
            yield [
                f"{gesture.replace('_', ' ')}, {position}: {ours['n']}" if count == 0 else "",
                str(count) if count else "none",
                *(f"{part['mean']:.3f}" for part in (of["measured"]["r2_zero"], ours["r2"], ours["r2_zero"])),
                ms(ours["t_diff"]["median"]),
                str(ours["missed"]),
                percent(rounds.recognised(count, gesture, position)),
            ]


def sensors_table(sensors: Sensors) -> Iterator[list[str]]:
    yield [
        "sensor",
        "position",
        "measured: R2",
        "at no lag",
        "`phase`: R2",
        "worst 5 %",
        "at no lag",
        "T_diff",
        "missed",
        "recognised",
    ]
    for sensor in sensors.task_given:
        for position in POSITIONS:
            measured = [np.mean(sensors.values(sensor, position, figure, "measured")) for figure in ("r2", "r2_zero")]
            r2 = sensors.values(sensor, position, "r2", "synthesised")
            ours = [
                np.mean(r2),
                np.percentile(r2, 5),
                np.mean(sensors.values(sensor, position, "r2_zero", "synthesised")),
            ]
            yield [
                sensor if position == POSITIONS[0] else "",
                position,
                *(f"{value:.3f}" for value in (*measured, *ours)),
                ms(np.median(sensors.values(sensor, position, "t_diff", "synthesised"))),
                str(sensors.missed(sensor, position)),
                percent(sensors.recognised(sensor, position)),
            ]


def others_table(others: list[OtherHands]) -> Iterator[list[str]]:
    yield ["recordings", "taken for", "in", "times", "false alarms a minute"]
    for other in others:
        alarms = other.alarms()
        total = sum(sum(recordings.values()) for recordings in alarms.values())
        what = f"{len(other.evaluation.rows)}, {other.minutes:.2f} minutes: {other.what}"
        yield [what, "anything", "", str(total), f"{total / other.minutes:.2f}"]
        for gesture, recordings in alarms.items():
            times = sum(recordings.values())
            where = ", ".join(name if count == 1 else f"{name} ({count})" for name, count in recordings.items())
            yield ["", gesture.replace("_", " "), where, str(times), f"{times / other.minutes:.2f}"]


def false_alarms(study: Study) -> str:
    minutes = study.open["phase"].summary["none_minutes"]
    if minutes == 0:
        return ""
    nothing, task = (
        [runs[mode].summary["false_alarms_per_minute"] for mode in MODES] for runs in (study.open, study.scene)
    )
    return (
        f"In {minutes:.0f} minutes of other motion: {nothing[0]:.2f} false alarms a minute in `paper` mode, "
        f"{nothing[1]:.2f} in `phase` mode; where a scene waits for one task, {task[0]:.2f} and {task[1]:.2f}. "
        "That motion is random, and its reaches keep 30 degrees away from the way of any drag or tap."
    )


def ms(value_s: float) -> str:
    return f"{1000 * value_s:+.0f} ms"
