"""The tables of docs/results*.md."""

from collections.abc import Iterable, Iterator

import numpy as np
from results.formats import ms, percent
from results.other_hands import OtherHands
from results.rounds import Rounds
from results.sensors import Sensors
from results.speed import Speed
from results.study import CONDITIONS, MODES, Study

POSITIONS = ["stable", "unstable"]
FIGURES = ["r2", "r2_zero", "lag", "t_diff", "sparc"]


def table(rows: Iterable[list[str]]) -> str:
    """The first row is the header; the first two columns are text, the others numbers."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    columns = lines[0].count("|") - 1
    lines.insert(1, "| " + " | ".join(["---", "---"] + ["---:"] * (columns - 2)) + " |")
    return "\n".join(lines)


def conditions_table(study: Study) -> Iterator[list[str]]:
    r2 = ["R2", "worst 5 %", "zero-lag R2", "worst 5 %"]
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
    figures = [f"{what}, `{mode}`" for mode in MODES for what in ("recognised", "zero-lag R2", "T_diff", "missed")]
    yield ["gesture", "position", "trials", "measured zero-lag R2", *figures]
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
    figures = ["R2", "worst 5 %", "zero-lag R2", "worst 5 %", "lag", "T_diff", "missed", "SPARC", "recognised"]
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
    figures = ["measured: zero-lag R2", "`phase`: R2", "zero-lag R2", "T_diff", "missed", "recognised"]
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
        "zero-lag R2",
        "`phase`: R2",
        "worst 5 %",
        "zero-lag R2",
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
