"""Names in a BIDS dataset: labels have letters and digits only."""

import re
from pathlib import Path

from study_export.sessions import Session

OUTSIDE = "session"  # task label of events outside of trials
QUESTIONNAIRES = "questionnaires"  # task label of answers
REFERENCE = "reference"
TRACKER = "tracker"


def label(name: str) -> str:
    """horizontal_drag: horizontalDrag. Empty: the name has no letter or digit of ASCII."""
    first, *rest = re.findall("[A-Za-z0-9]+", name) or [""]
    return first + "".join(word[0].upper() + word[1:] for word in rest)


def task_labels(sessions: list[Session]) -> dict[str, str]:
    """Label of each gesture. ValueError: two gestures would share one, also in other case, or a gesture has none."""
    labels: dict[str, str] = {}
    owners = {OUTSIDE.lower(): "events outside of trials", QUESTIONNAIRES.lower(): "answers"}
    for gesture in sorted({trial["gesture"] for session in sessions for trial in session.trials}):
        task = label(gesture)
        if not task:
            raise ValueError(f"gesture '{gesture}' has no letter or digit of ASCII. BIDS needs one: rename the gesture")
        if owner := owners.get(task.lower()):
            raise ValueError(f"BIDS label '{task}' stands for {owner} and for gesture '{gesture}': rename one")
        owners[task.lower()] = f"gesture '{gesture}'"
        labels[gesture] = task
    return labels


def check_participants(sessions: list[Session]) -> None:
    """ValueError: Windows and macOS would take the folders of two participants for one."""
    names: dict[str, str] = {}
    for session in sessions:
        first = names.setdefault(session.participant.lower(), session.participant)
        if first != session.participant:
            raise ValueError(
                f"participants '{first}' and '{session.participant}' differ only in upper and lower case:"
                " Windows and macOS take their BIDS folders for one. Rename one in its session.json and tables"
            )


def tracker_label(session: Session) -> str:
    return label(session.setting("source")) or TRACKER


def reference_label(session: Session, kind: str) -> str:
    """`kind`: the cell `reference` of the trial. A simulated hand's own motion is no tracker."""
    own = "truth" if kind == "truth" else label(session.setting("reference")) or REFERENCE
    return own if own != tracker_label(session) else own + "Reference"


def session_prefix(session: Session) -> str:
    return f"sub-{session.participant}_ses-{session.number:02d}"


def session_folder(session: Session) -> Path:
    return Path(f"sub-{session.participant}", f"ses-{session.number:02d}")
