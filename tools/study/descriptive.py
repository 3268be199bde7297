"""Tables that describe the data of one analysis: who, how many, and means over participants."""

import statistics
from collections import Counter, defaultdict
from dataclasses import asdict

from study.analysis import Analysis
from study.measures import Mean, throughput_cells
from study.rows import POSITIONS
from study.session_rows import CURVES, StudyTrial
from study.tables import Column, Table, decimals, percent, spoken, with_titles
from study.throughput import groups

TASK = [Column("gesture", "Gesture", spoken), Column("position", "Position")]


def sessions_table(analysis: Analysis) -> Table:
    rows = []
    for session in sorted(analysis.sessions, key=lambda one: (one.participant, one.number)):
        own = [trial for trial in analysis.trials if trial.session is session]
        planned = sum(not one.practice for one in session.plan.values())
        recognised = sum(trial.is_recognised for trial in own)
        row = {"participant": session.participant, "session": session.number, "planned": planned}
        rows.append(row | {"trials": len(own), "missing": planned - len(own), "recognised": recognised})
    columns = [
        Column("participant", "Participant"),
        Column("session", "Session"),
        Column("planned", "Planned trials"),
        Column("trials", "Trials"),
        Column("missing", "Without a row"),
        Column("recognised", "Recognised"),
    ]
    note = "Practice trials are not counted. All sessions of a participant count as one person."
    return Table("sessions", "Sessions", columns, rows, note, folded=True)


def by_task(trials: list[StudyTrial]) -> dict[tuple[str, str], list[StudyTrial]]:
    parts = defaultdict(list)
    for trial in trials:
        parts[(trial.gesture, trial.position)].append(trial)
    return {key: parts[key] for key in sorted(parts, key=lambda key: (key[0], POSITIONS.index(key[1])))}


def curves_table(analysis: Analysis, means: list[Mean]) -> Table:
    rows = []
    for (gesture, position), trials in by_task(analysis.trials).items():
        recognised = [trial for trial in trials if trial.is_recognised]
        for curve in CURVES:
            with_reference = [trial for trial in recognised if trial.figures[f"r2_{curve}"] is not None]
            row = {"gesture": gesture, "position": position, "curve": curve}
            row |= {"not_recognised": len(trials) - len(recognised)}
            row |= {"no_reference": len(recognised) - len(with_reference), "trials": len(with_reference)}
            own = [one for one in means if (one.gesture, one.position, one.motion) == (gesture, position, curve)]
            for measure in ("r2", "r2_zero", "t_diff"):
                values = [one.value for one in own if (one.kind, one.measure) == ("curve", measure)]
                row |= {"people": len(values)} if measure == "r2" else {}
                row |= {f"{measure}_mean": statistics.fmean(values) if values else None}
                row |= {f"{measure}_sd": statistics.stdev(values) if len(values) > 1 else None}
            rows.append(row)
    columns = [
        *TASK,
        Column("curve", "Motion", with_titles),
        Column("people", "People"),
        Column("trials", "Trials"),
        Column("not_recognised", "Left out: not recognised"),
        Column("no_reference", "Left out: no reference"),
        Column("r2_mean", "R², best lag", decimals(3)),
        Column("r2_sd", "SD", decimals(3)),
        Column("r2_zero_mean", "R², zero lag", decimals(3)),
        Column("r2_zero_sd", "SD", decimals(3)),
        Column("t_diff_mean", "T_diff, ms", decimals(0, 1000)),
        Column("t_diff_sd", "SD, ms", decimals(0, 1000)),
    ]
    note = (
        "Means and standard deviations over participants' means. Only trials with the right gesture recognised count,"
        " as in the paper. Each trial has all three motions, whichever condition drove the vibration."
        " T_diff is the reference's end minus the motion's end: above 0, the motion ends early."
        " In the CSV file T_diff is in seconds."
    )
    return Table("curves", "Motion against the reference", columns, rows, note)


def recognition_table(analysis: Analysis) -> Table:
    rows = []
    for (gesture, position), trials in by_task(analysis.trials).items():
        people = defaultdict(list)
        for trial in trials:
            people[trial.session.participant].append(trial.is_recognised)
        rates = [statistics.fmean(own) for own in people.values()]
        others = Counter(trial.recognised for trial in trials if trial.recognised not in ("", gesture))
        row = {"gesture": gesture, "position": position, "people": len(people), "trials": len(trials)}
        row |= {"right": sum(trial.is_recognised for trial in trials), "other": sum(others.values())}
        row |= {"none": sum(not trial.recognised for trial in trials)}
        row |= {"rate_mean": statistics.fmean(rates), "rate_sd": statistics.stdev(rates) if len(rates) > 1 else None}
        row |= {"others": ", ".join(f"{name}: {count}" for name, count in sorted(others.items()))}
        row |= {"aborts": sum(trial.aborts for trial in trials), "losses": sum(trial.losses for trial in trials)}
        rows.append(row)
    columns = [
        *TASK,
        Column("people", "People"),
        Column("trials", "Trials"),
        Column("right", "Right"),
        Column("other", "Another gesture"),
        Column("none", "None"),
        Column("rate_mean", "Rate", percent),
        Column("rate_sd", "SD", percent),
        Column("others", "Recognised as"),
        Column("aborts", "Aborts"),
        Column("losses", "Losses of tracking"),
    ]
    note = "The rate is the mean over participants."
    return Table("recognition", "Recognition", columns, rows, note)


def throughput_tables(analysis: Analysis) -> list[Table]:
    of_participants = throughput_cells(analysis.trials)
    condition = Column("condition", "Driven by", with_titles)
    figures = [
        Column("without_end", "Without an end"),
        Column("movement_time_s", "MT, s", decimals(3)),
        Column("effective_amplitude_m", "Ae, mm", decimals(1, 1000)),
        Column("effective_width_m", "We, mm", decimals(1, 1000)),
        Column("effective_difficulty_bits", "IDe, bits", decimals(2)),
        Column("throughput_bits_s", "TP, bits/s", decimals(2)),
    ]
    deviation = Column("throughput_deviation_bits_s", "SD", decimals(2))
    of_all = [*TASK, condition, Column("participants", "People"), Column("n", "Trials"), *figures, deviation]
    of_one = [
        Column("participant", "Participant"),
        *(*TASK, condition, Column("amplitude_m", "A, mm", decimals(0, 1000))),
        *(Column("width_m", "W, mm", decimals(0, 1000)), Column("n", "Trials"), *figures),
    ]
    note = (
        "Throughput by the effective width (ISO/TS 9241-411): We = 4.133 SD of the end points,"
        " IDe = log2(Ae / We + 1), TP = IDe / MT. A trial that ended as another gesture counts as one without an end."
    )
    means = [asdict(group) for group in groups(of_participants)]
    return [
        Table("throughput_means", "Fitts throughput by driving condition", of_all, means, note),
        Table(
            "throughput", "Fitts throughput of each participant", of_one, [*map(asdict, of_participants)], folded=True
        ),
    ]


def answers_table(analysis: Analysis, means: list[Mean]) -> Table:
    parts = defaultdict(list)
    for one in means:
        if one.kind == "answer":
            parts[(one.measure, one.gesture, one.position, one.motion)].append(one.value)
    skipped = Counter(
        (f"{one.questionnaire}/{one.item}", one.gesture, one.position, one.condition)
        for one in analysis.answers
        if one.value is None
    )
    rows = []
    for key in [*parts, *(key for key in skipped if key not in parts)]:
        values = parts.get(key, [])
        row = dict(zip(("item", "gesture", "position", "condition"), key, strict=True))
        row |= {"people": len(values), "skipped": skipped[key]}
        row |= {"mean": statistics.fmean(values) if values else None}
        row |= {"sd": statistics.stdev(values) if len(values) > 1 else None}
        rows.append(row | {"median": statistics.median(values) if values else None})
    columns = [
        Column("item", "Item"),
        *TASK,
        Column("condition", "Driven by", with_titles),
        Column("people", "People"),
        Column("skipped", "Skipped answers"),
        Column("mean", "Mean", decimals(2)),
        Column("sd", "SD", decimals(2)),
        Column("median", "Median", decimals(2)),
    ]
    texts = sorted({(f"{one.questionnaire}/{one.item}", one.text) for one in analysis.answers})
    note = " ".join(f"{item}: “{text}”" for item, text in texts)
    return Table("answers", "Questionnaires", columns, rows, f"Over participants' means. {note}", folded=True)


def means_table(means: list[Mean]) -> Table:
    columns = [
        Column("measure", "Measure"),
        Column("gesture", "Gesture", spoken),
        Column("participant", "Participant"),
        Column("position", "Position"),
        Column("motion", "Motion or condition", with_titles),
        Column("n", "Values"),
        Column("value", "Mean", decimals(4)),
    ]
    note = "The input of every test: T_diff in s, throughput in bits/s, answers on their scale."
    return Table("participant_means", "Means of each participant", columns, [*map(asdict, means)], note, folded=True)
