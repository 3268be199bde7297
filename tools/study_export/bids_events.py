"""Events, results of trials, and answers of a session as BIDS tables."""

from pathlib import Path

from study_export.bids_files import MISSING, described, header, write_tsv
from study_export.bids_names import OUTSIDE, QUESTIONNAIRES, session_prefix
from study_export.columns import ANSWERS, EVENTS, NUMBER, TEXT, TRIALS, Column
from study_export.sessions import Row, Session

# Each of these events lasts until the other one.
ENDS = {"tracking_lost": "tracking_restored", "rest_started": "rest_ended", "paused": "continued"}
OF_RUN = {column.name: column for column in EVENTS}
EVENT_COLUMNS = [
    Column("onset", "s", NUMBER, "time from the first frame of the recording; in beh/: from the start of the run"),
    Column("duration", "s", NUMBER, "length of the event; 0: it is a moment"),
    Column("trial_type", "", TEXT, "kind of the event"),
    OF_RUN["value"],
    OF_RUN["run"],
    OF_RUN["trial"],
    OF_RUN["t_s"],
]
# In a BIDS table the file name holds participant and session.
BEH_TRIALS = [column for column in TRIALS if column.name not in ("participant", "session", "origin")]
BEH_ANSWERS = [column for column in ANSWERS if column.name not in ("participant", "session", "origin")]


def durations(events: list[Row]) -> dict[int, str]:
    """Length of each event that has one, by its line."""
    found: dict[int, str] = {}
    for place, event in enumerate(events):
        if end := ENDS.get(event["event"]):
            until = next((e for e in events[place:] if e["event"] == end and e["run"] == event["run"]), None)
            found[event.line] = MISSING if until is None else f"{until.number('t_s') - event.number('t_s'):.6f}"
    return found


def write_events(path: Path, session: Session, events: list[Row], start_s: float) -> None:
    lengths = durations(session.events)
    rows = [
        [
            f"{event.number('t_s') - start_s:.6f}",
            lengths.get(event.line, "0"),
            event["event"],
            *(event[name] for name in ("value", "run", "trial", "t_s")),
        ]
        for event in sorted(events, key=lambda event: event.number("t_s"))
    ]
    if rows:
        write_tsv(path, header(EVENT_COLUMNS), rows)


def write_session_tables(folder: Path, session: Session, tasks: dict[str, str], written: set[tuple[str, str]]) -> None:
    """Results of trials, answers, and events, into beh/. `written`: trial and run of the events that have a file."""
    prefix = session_prefix(session)
    for gesture, task in tasks.items():
        trials = [trial for trial in session.trials if trial["gesture"] == gesture]
        if trials:
            write_rows(folder / f"{prefix}_task-{task}_beh.tsv", BEH_TRIALS, trials)
    if session.answers:
        write_rows(folder / f"{prefix}_task-{QUESTIONNAIRES}_beh.tsv", BEH_ANSWERS, session.answers)
    outside = [event for event in session.events if (event["trial"], event["run"]) not in written]
    for run in sorted({event.count("run") for event in outside}):
        events = [event for event in outside if event.count("run") == run]
        starts = [event.number("t_s") for event in events if event["event"] == "run_started"]
        start_s = starts[0] if starts else min(event.number("t_s") for event in events)
        write_events(folder / f"{prefix}_task-{OUTSIDE}_run-{run:04d}_events.tsv", session, events, start_s)


def write_rows(path: Path, columns: list[Column], rows: list[Row]) -> None:
    write_tsv(path, header(columns), ([row[c.name] for c in columns] for row in rows))


def sidecars(tasks: dict[str, str]) -> dict[str, dict]:
    """Files of the dataset's root that describe the tables of all sessions."""
    files = {f"task-{OUTSIDE}_events.json": {"TaskName": OUTSIDE, **described(EVENT_COLUMNS)}}
    for gesture, task in tasks.items():
        files[f"task-{task}_events.json"] = described(EVENT_COLUMNS)
        files[f"task-{task}_beh.json"] = {"TaskName": gesture, **described(BEH_TRIALS)}
    files[f"task-{QUESTIONNAIRES}_beh.json"] = {"TaskName": QUESTIONNAIRES, **described(BEH_ANSWERS)}
    return files
