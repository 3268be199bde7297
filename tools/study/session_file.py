"""session.json of a study (docs/study_files.md)."""

import json
import re
from dataclasses import dataclass, field
from pathlib import Path

# Who made the trials, and how every title of the report names it.
ORIGINS = {
    "person": "person",
    "mouse": "mouse",
    "synthetic": "made-up data (synthetic)",
    "replay": "replay",
}
FORMAT, VERSION = "steadyhand-session", 1
LONGEST_VALUE = 60  # in a note


@dataclass(frozen=True)
class Planned:
    practice: bool
    gesture: str
    position: str
    condition: str


@dataclass(frozen=True)
class Session:
    folder: Path
    study: str
    participant: str
    number: int
    origin: str
    plan: dict[int, Planned] = field(hash=False)
    protocol: dict = field(hash=False)
    settings: dict = field(hash=False)
    versions: dict = field(hash=False)

    @property
    def name(self) -> str:
        return f"participant {self.participant}, session {self.number}"


def read_session(path: Path) -> Session:
    """ValueError names file, place and fault."""
    try:
        data = json.loads(path.read_text("utf-8-sig"))
    except json.JSONDecodeError as fault:
        raise ValueError(f"{path}:{fault.lineno}: this is not JSON ({fault.msg}): restore the file") from fault
    except UnicodeDecodeError as fault:
        raise ValueError(f"{path}: this is not UTF-8 text: restore the file") from fault
    except RecursionError as fault:
        raise ValueError(f"{path}: this JSON is nested too deeply: restore the file") from fault
    except OSError as fault:
        raise ValueError(f"{path}: {fault.strerror or fault}") from fault
    try:
        return parse_session(path.parent, data)
    except ValueError as fault:
        raise ValueError(f"{path}: {fault}") from fault


def parse_session(folder: Path, data: object) -> Session:
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise ValueError(f'"format" must be "{FORMAT}"')
    if data.get("version") != VERSION:
        raise ValueError(f'"version" must be {VERSION}, is {data.get("version")!r}: use the matching SteadyHand')
    for key in ("study", "participant", "origin"):
        if not isinstance(data.get(key), str) or not data[key]:
            raise ValueError(f'"{key}" must be a text that is not empty')
    if not re.fullmatch(r"[A-Za-z0-9]{1,32}", data["participant"]):
        raise ValueError(f'"participant" must be 1 to 32 letters and digits, is "{data["participant"]}"')
    if data["origin"] not in ORIGINS:
        raise ValueError(f'"origin" must be one of {", ".join(ORIGINS)}, is "{data["origin"]}"')
    return Session(
        folder,
        data["study"],
        data["participant"],
        whole_number(data, "session"),
        data["origin"],
        parse_plan(data.get("trials")),
        part_of(data, "protocol"),
        part_of(data, "settings"),
        part_of(data, "versions"),
    )


def part_of(data: dict, key: str) -> dict:
    return data[key] if isinstance(data.get(key), dict) else {}


def differences(parts: list[dict]) -> list[str]:
    """`KEY: VALUE, VALUE` for each key whose values differ. Long values are left out."""
    found = []
    for key in sorted({key for part in parts for key in part}):
        values = sorted({value_text(part.get(key)) for part in parts})
        if len(values) > 1:
            are_short = all(len(value) <= LONGEST_VALUE for value in values)
            found.append(f"{key}: {', '.join(values)}" if are_short else key)
    return found


def value_text(value: object) -> str:
    """Godot writes every number of a JSON file as 1.0."""
    if value is None:
        return "none"
    return str(int(value) if isinstance(value, float) and value.is_integer() else value)


def parse_plan(trials: object) -> dict[int, Planned]:
    if not isinstance(trials, list):
        raise ValueError('"trials" must be a list')
    plan = {}
    for place, trial in enumerate(trials, start=1):
        try:
            number = whole_number(trial, "trial")
            texts = [trial[key] for key in ("gesture", "position", "condition")]
            plan[number] = Planned(bool(trial["practice"]), *texts)
        except (KeyError, TypeError) as fault:
            raise ValueError(f'"trials", object {place}: {fault} is missing') from fault
        except ValueError as fault:
            raise ValueError(f'"trials", object {place}: {fault}') from fault
    if len(plan) < len(trials):
        raise ValueError('"trials" has one trial number twice')
    return plan


def whole_number(data: dict, key: str) -> int:
    value = data.get(key) if isinstance(data, dict) else None
    # Godot writes every number of a JSON file as 1.0.
    if isinstance(value, bool) or not isinstance(value, int | float) or value != int(value) or value < 1:
        raise ValueError(f'"{key}" must be a whole number from 1, is {value!r}')
    return int(value)
