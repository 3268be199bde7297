"""Writes all sessions as one BIDS dataset with motion-BIDS recordings."""

import shutil
from collections import defaultdict
from pathlib import Path

from study.logs import NO_STUDY
from study_export.bids_curves import write_curves
from study_export.bids_events import sidecars, write_events, write_session_tables
from study_export.bids_files import MISSING, described, header, write_json, write_tsv
from study_export.bids_names import (
    check_participants,
    reference_label,
    session_folder,
    session_prefix,
    task_labels,
    tracker_label,
)
from study_export.bids_readme import README
from study_export.bids_tracks import Recording, write_recording, write_sidecars
from study_export.columns import ORIGIN, TEXT, TIME, TRIALS, Column
from study_export.sessions import Row, Session
from study_export.tables import Findings

BIDS_VERSION = "1.11.1"
OF_SCANS = [c for c in TRIALS if c.name in ("trial", "run", "block", "practice", "gesture", "position", "condition")]
SCANS = [
    Column("filename", "", TEXT, "the recording"),
    Column("acq_time", "", TIME, "local date and time of its first frame"),
    *OF_SCANS,
]
PARTICIPANTS = [
    Column("participant_id", "", TEXT, "id of the participant"),
    Column(
        "origin",
        "",
        TEXT,
        "who made the trials: person, mouse, synthetic or replay; mixed: see the sessions.tsv of each",
    ),
    Column("sessions", "", TEXT, "number of sessions"),
]
SESSIONS = [
    Column("session_id", "", TEXT, "id of the session"),
    Column("acq_time", "", TIME, "local date and time of the start"),
    ORIGIN,
    Column("seed", "", TEXT, "the order of the trials is drawn from it and the participant's id"),
    Column("planned_trials", "", TEXT, "number of planned trials"),
    Column("finished_trials", "", TEXT, "number of trials that have a result"),
]


def write_dataset(sessions: list[Session], out: Path, found: Findings) -> None:
    """Writes all of `out` or nothing. ValueError: the study cannot be a BIDS dataset. OSError: a disk error."""
    if out.exists() and not out.is_dir():
        raise ValueError(f"{out}: this is a file. Name a new folder")
    if out.exists() and any(out.iterdir()):
        raise ValueError(f"{out}: it is not empty. Name a new folder, or delete this one")
    check_participants(sessions)
    tasks = task_labels(sessions)
    part = out.with_name(out.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    try:
        for session in sessions:
            write_session(session, part / session_folder(session), tasks, found)
        write_root(sessions, part, tasks)
        if out.exists():
            out.rmdir()
        part.rename(out)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise


def write_session(session: Session, folder: Path, tasks: dict[str, str], found: Findings) -> None:
    prefix = session_prefix(session)
    groups: dict[tuple[str, str, str], list[Recording]] = defaultdict(list)
    scans: list[list[str]] = []
    written: set[tuple[str, str]] = set()
    for trial in session.trials:
        start_s = None
        for system, name, track in tracks(session, trial, found):
            stem = f"{prefix}_task-{tasks[trial['gesture']]}_tracksys-{system}_run-{trial.count('trial'):04d}"
            (folder / "motion").mkdir(parents=True, exist_ok=True)
            if recording := write_recording(track, folder / "motion" / stem, found):
                groups[trial["gesture"], system, name].append(recording)
                moment = session.local_time(trial.count("run"), recording.start_s)
                time = MISSING if moment is None else moment.isoformat(timespec="microseconds")
                scans.append([f"motion/{stem}_motion.tsv", time, *(trial[column.name] for column in OF_SCANS)])
                start_s = recording.start_s if start_s is None else start_s
        if start_s is None:
            found.notes.append(f"{session.folder}: trial {trial['trial']} has no frame: BIDS gets its result only")
            continue
        stem = f"{prefix}_task-{tasks[trial['gesture']]}_"
        run = f"run-{trial.count('trial'):04d}"
        key = (trial["trial"], trial["run"])
        own = [event for event in session.events if (event["trial"], event["run"]) == key]
        written.add(key)
        write_events(folder / "motion" / f"{stem}{run}_events.tsv", session, own, start_s)
        curves = session.folder / f"{trial_name(trial)}.motion.csv"
        write_curves(curves, folder / "motion" / f"{stem}{run}_recording-curves", trial["gesture"], start_s, found)
    for (gesture, _, name), recordings in groups.items():
        write_sidecars(recordings, gesture, name, about(session, gesture), found)
    if scans:
        write_tsv(folder / f"{prefix}_scans.tsv", header(SCANS), scans)
        write_json(folder / f"{prefix}_scans.json", described(SCANS))
    write_session_tables(folder / "beh", session, tasks, written)


def trial_name(trial: Row) -> str:
    return f"trial_{trial.count('trial'):04d}"


def tracks(session: Session, trial: Row, found: Findings) -> list[tuple[str, str, Path]]:
    """Label, name and file of each tracker of the trial. The first one gives the recording's zero time."""
    name = trial_name(trial)
    frames = session.folder / f"{name}.frames.csv"
    reference = session.folder / f"{name}.reference.csv"
    own = []
    if frames.exists():
        own.append((tracker_label(session), session.setting("source") or MISSING, frames))
    else:
        found.faults.append(f"{frames}: not there. Restore the file, or the trial stays without its frames")
    if reference.exists():
        system = reference_label(session, trial["reference"])
        own.append((system, session.setting("reference") or system, reference))
    elif trial["reference"] == "sensor":
        found.faults.append(f"{reference}: not there. Restore the file, or the trial stays without its reference")
    return own


def about(session: Session, gesture: str) -> dict:
    versions = [f"{name} {session.version(name.lower())}" for name in ("SteadyHand", "Godot")]
    return {
        "TaskDescription": f"The participant makes the gesture {gesture} toward a target",
        "SoftwareVersions": ", ".join(versions),
    }


def write_root(sessions: list[Session], root: Path, tasks: dict[str, str]) -> None:
    studies = sorted({str(session.about.get("study") or "study") for session in sessions})
    versions = sorted({session.version("steadyhand") for session in sessions} - {""})
    dates = sorted(session.started[:10] for session in sessions)
    write_json(
        root / "dataset_description.json",
        {
            "Name": ", ".join(studies),
            "BIDSVersion": BIDS_VERSION,
            "DatasetType": "raw",
            "GeneratedBy": [{"Name": "SteadyHand study_export", "Version": ", ".join(versions) or MISSING}],
        },
    )
    (root / "README").write_text(README.format(name=", ".join(studies)), encoding="utf-8")
    (root / "CHANGES").write_text(f"1.0.0 {dates[-1] or '1970-01-01'}\n  - First export.\n", encoding="utf-8")
    (root / "sourcedata").mkdir()
    text = "Copies of session.json, without their tables. ./steadyhand study leaves them out.\n"
    (root / "sourcedata" / NO_STUDY).write_text(text, encoding="utf-8")
    by_participant: dict[str, list[Session]] = defaultdict(list)
    for session in sessions:
        by_participant[session.participant].append(session)
        source = root / "sourcedata" / session_folder(session) / "session.json"
        source.parent.mkdir(parents=True, exist_ok=True)
        source.write_text((session.folder / "session.json").read_text(encoding="utf-8"), encoding="utf-8")
    rows = []
    for participant, own in by_participant.items():
        origins = {session.origin for session in own}
        rows.append([f"sub-{participant}", origins.pop() if len(origins) == 1 else "mixed", str(len(own))])
        path = root / f"sub-{participant}" / f"sub-{participant}_sessions"
        write_tsv(path.with_suffix(".tsv"), header(SESSIONS), map(session_row, own))
        write_json(path.with_suffix(".json"), described(SESSIONS))
    write_tsv(root / "participants.tsv", header(PARTICIPANTS), rows)
    write_json(root / "participants.json", described(PARTICIPANTS))
    for name, content in sidecars(tasks).items():
        write_json(root / name, content)


def session_row(session: Session) -> list[str]:
    planned, finished = str(len(session.about["trials"])), str(len(session.trials))
    return [f"ses-{session.number:02d}", session.started, session.origin, session.seed, planned, finished]
