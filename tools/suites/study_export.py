"""python -m study_export on a sample study: tidy tables, and a BIDS dataset that the official validator accepts."""

import csv
import gzip
import json
import re
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path

from study_export.columns import CURVES, JOINTS
from suites.outcome import Outcome
from suites.process import ROOT, run
from suites.study_export_faults import contents, faults
from suites.study_sample import TRACK, write_study

NAME = "study_export"
TOLERANCE = 1e-6
VALIDATOR = Path(sys.executable).with_name("bids-validator-deno")
SESSIONS = ["sub-ann/ses-01", "sub-ann/ses-02", "sub-sim1/ses-01", "sub-sim1/ses-02"]
TRACKERS = {
    "sub-ann/ses-01": ["XRHandSource", "LibertySource"],
    "sub-ann/ses-02": ["XRHandSource"],
    "sub-sim1/ses-01": ["SyntheticSource", "truth"],
    "sub-sim1/ses-02": ["SyntheticSource", "truth"],
}


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        study, table, dataset = folder / "study", folder / "out/drags.csv", folder / "bids"
        write_study(study)
        status, output = export(study, "--tidy", table, "--bids", dataset)
        yield Outcome.of(f"{NAME}: a study without faults exits with 0", status == 0, output)
        if status != 0:
            return
        yield from tidy(study, table)
        yield from in_pandas(table)
        yield from recordings(study, dataset)
        yield from clocks_and_events(study, dataset)
        yield from valid(dataset)
        export(study, "--bids", folder / "again")
        same = contents(dataset) == contents(folder / "again")
        yield Outcome.of(f"{NAME}: the same study gives the same bytes", same)
        export(study, "--bids", study / "bids")
        status, output = export(study, "--tidy", folder / "after.csv")
        good = status == 0 and (folder / "after.csv").read_bytes() == table.read_bytes()
        yield Outcome.of(f"{NAME}: a dataset in the study's folder is no session", good, output)
        yield from faults(folder, export)


def export(*arguments: str | Path) -> tuple[int, str]:
    return run([sys.executable, "-m", "study_export", *arguments], PYTHONPATH=str(ROOT / "tools"))


def tidy(study: Path, table: Path) -> Iterator[Outcome]:
    rows = read(table)
    trials = {(t["participant"], t["session"], t["trial"]): t for t in source(study, "trials.csv")}
    keys = Counter((row["participant"], row["session"], row["trial"], row["curve"]) for row in rows)
    expected = {(*key, curve): 1 for key in trials for curve in CURVES}
    yield Outcome.of(f"{NAME}: each trial has each curve once", keys == expected, f"{keys}")
    wrong = []
    for row in rows:
        trial = trials[row["participant"], row["session"], row["trial"]]
        same = {
            "r2": "r2_C",
            "r2_zero": "r2_zero_C",
            "lag_s": "lag_C",
            "t_diff_s": "t_diff_C",
            "end_value_m": "end_value_m",
        }
        pairs = [(row[name], trial[of.replace("C", row["curve"])]) for name, of in same.items()]
        if trial["end_s"]:
            pairs.append((row["movement_time_s"], str(float(trial["end_s"]) - float(trial["onset_s"]))))
        wrong += [(row["trial"], pair) for pair in pairs if not near(*pair)]
        flags = {"practice": row["trial"] == "1", "recognised": bool(trial["recognised"])}
        flags["drives"] = row["curve"] == trial["condition"]
        wrong += [(row["trial"], name) for name, value in flags.items() if row[name] != str(int(value))]
    yield Outcome.of(f"{NAME}: numbers and flags of the tidy table match the trials", not wrong, f"{wrong}")
    answers = [tuple(row[name] for name in ("participant", "item", "text", "value")) for row in read(answers_of(table))]
    asked = [
        tuple(row[name] for name in ("participant", "item", "text", "value")) for row in source(study, "answers.csv")
    ]
    yield Outcome.of(f"{NAME}: each answer is there once, with its text", answers == asked, f"{answers}")
    described = {(row["file"], row["column"]) for row in read(table.with_name("drags_codebook.csv")) if row["meaning"]}
    columns = {(path.name, name) for path in (table, answers_of(table)) for name in read(path)[0]}
    yield Outcome.of(f"{NAME}: the codebook has every column", described == columns, f"{described ^ columns}")


def in_pandas(table: Path) -> Iterator[Outcome]:
    try:
        import pandas
    except ImportError:
        yield Outcome(f"{NAME}: pandas reads the tidy table (skipped: pandas is not installed)", skipped=1)
        return
    documented = re.search(r"pandas\.read_csv\(.*\)", (ROOT / "docs/study_export.md").read_text("utf-8"))[0]
    renamed = table.with_name("renamed.csv")
    renamed.write_text(table.read_text().replace(",ann,", ",007,").replace(",sim1,", ",NA,"))
    frame, other = (
        eval(documented.replace('"drags.csv"', repr(str(path))), {"pandas": pandas}) for path in (table, renamed)
    )
    people = set(other.participant)
    yield Outcome.of(f"{NAME}: pandas keeps ids such as 007 and NA", people == {"007", "NA"}, f"{people}")
    codebook = pandas.read_csv(table.with_name("drags_codebook.csv"))
    numbers = codebook[(codebook.file == table.name) & (codebook.type != "text") & (codebook.type != "time")].column
    wrong = [name for name in numbers if not pandas.api.types.is_numeric_dtype(frame[name])]
    yield Outcome.of(f"{NAME}: pandas reads every number as a number", not wrong and len(frame) == 48, f"{wrong}")


def recordings(study: Path, dataset: Path) -> Iterator[Outcome]:
    wrong: list[str] = []
    missing = 0
    expected = set()
    for session in SESSIONS:
        for trial in read(study / session / "trials.csv"):
            for tracker in TRACKERS[session]:
                stem = motion_stem(session, trial, tracker)
                expected.add(f"{stem}_motion.tsv")
                kind = "frames" if tracker == TRACKERS[session][0] else "reference"
                frames = read(study / session / f"trial_{int(trial['trial']):04d}.{kind}.csv")
                rows = lines(dataset / f"{stem}_motion.tsv")
                names = [row["name"] for row in read(dataset / f"{stem}_channels.tsv", "\t")]
                wrong += [f"{stem}: channels {names}"] if names != ["latency", *TRACK[1:]] else []
                wrong += [f"{stem}: {len(rows)} rows"] if len(rows) != len(frames) else []
                for row, frame in zip(rows, frames, strict=False):
                    latency = str(float(frame["t"]) - float(frames[0]["t"]))
                    cells = [latency, *(frame[name] or "n/a" for name in TRACK[1:])]
                    missing += cells.count("n/a")
                    wrong += [f"{stem}: {row}"] if not all(map(near, row, cells)) else []
                about = json.loads((dataset / f"{stem}_motion.json").read_text())
                counts = [about[f"{name}ChannelCount"] for name in ("Motion", "POS", "LATENCY", "MISC")]
                rate = 60 if kind == "frames" else 240
                if counts != [len(names), 3 * len(JOINTS), 1, 1] or abs(about["SamplingFrequency"] / rate - 1) > 0.1:
                    wrong.append(f"{stem}: {about}")
            wrong += curve_faults(study / session, dataset, session, trial)
    found = {str(path.relative_to(dataset)) for path in dataset.rglob("*_motion.tsv")}
    yield Outcome.of(f"{NAME}: each trial is one run of each tracker", found == expected, f"{found ^ expected}")
    yield Outcome.of(f"{NAME}: frames and curves survive to 1e-6", not wrong, "\n".join(wrong[:5]))
    yield Outcome.of(f"{NAME}: joints that were not tracked are n/a", missing > 100, f"{missing}")


def curve_faults(source_folder: Path, dataset: Path, session: str, trial: dict[str, str]) -> list[str]:
    number = f"{int(trial['trial']):04d}"
    stem = motion_stem(session, trial).replace(f"_run-{number}", f"_run-{number}_recording-curves")
    start = float(read(source_folder / f"trial_{number}.frames.csv")[0]["t"])
    rows = read(source_folder / f"trial_{number}.motion.csv")
    about = json.loads((dataset / f"{stem}_stim.json").read_text())
    with gzip.open(dataset / f"{stem}_stim.tsv.gz", "rt") as file:
        curves = [line.rstrip("\n").split("\t") for line in file]
    expected = [[str(float(row["t"]) - start), *(row[name] or "n/a" for name in about["Columns"][1:])] for row in rows]
    same = len(curves) == len(rows) and all(all(map(near, *pair)) for pair in zip(curves, expected, strict=True))
    return [] if same and near(str(about["StartTime"]), expected[0][0]) else [f"{stem}: curves differ"]


def clocks_and_events(study: Path, dataset: Path) -> Iterator[Outcome]:
    wrong = []
    for session in SESSIONS:
        starts = {
            event["run"]: (float(event["t_s"]), datetime.fromisoformat(event["value"]))
            for event in read(study / session / "events.csv")
            if event["event"] == "run_started"
        }
        scans = read(dataset / session / f"{session.replace('/', '_')}_scans.tsv", "\t")
        for scan in scans:
            kind = "frames" if f"tracksys-{TRACKERS[session][0]}" in scan["filename"] else "reference"
            first = read(study / session / f"trial_{int(scan['trial']):04d}.{kind}.csv")[0]
            clock, begun = starts[scan["program_run"]]
            late = (datetime.fromisoformat(scan["acq_time"]) - begun).total_seconds()
            wrong += [] if abs(late - (float(first["t"]) - clock)) < 2e-6 else [scan["filename"]]
        count = len(read(study / session / "trials.csv")) * len(TRACKERS[session])
        wrong += [session] if len(scans) != count else []
    yield Outcome.of(f"{NAME}: acq_time is the clock of the run", not wrong, f"{wrong}")
    found, events = [], [(row["t_s"], row["event"], row["value"]) for row in source(study, "events.csv")]
    for path in dataset.rglob("*_events.tsv"):
        found += [(row["t_s"], row["trial_type"], row["value"].replace("n/a", "")) for row in read(path, "\t")]
    yield Outcome.of(
        f"{NAME}: each event is there once", sorted(found) == sorted(events), f"{len(found)}, {len(events)}"
    )


def valid(dataset: Path) -> Iterator[Outcome]:
    if not VALIDATOR.exists():
        reason = "skipped: tools/setup_python.sh export installs the validator"
        yield Outcome(f"{NAME}: the BIDS validator reports no error ({reason})", skipped=1)
        return
    status, errors = validator_errors(dataset)
    yield Outcome.of(f"{NAME}: the BIDS validator reports no error", status == 0 and not errors, f"{status} {errors}")
    sidecar = next(dataset.rglob("*_motion.json"))
    whole = sidecar.read_text()
    sidecar.write_text(whole.replace("SamplingFrequency", "Rate"))
    status, errors = validator_errors(dataset)
    sidecar.write_text(whole)
    refused = "SIDECAR_KEY_REQUIRED" in errors
    yield Outcome.of(f"{NAME}: the BIDS validator refuses a missing sampling frequency", refused, f"{status} {errors}")


def validator_errors(dataset: Path) -> tuple[int, list[str]]:
    """Without a network: the schema is a part of the validator."""
    result = dataset.with_name("validator.json")
    command = [VALIDATOR, "--max-rows", "-1", "--format", "json", "--outfile", result, dataset]
    status, output = run(command, DENO_NO_UPDATE_CHECK="1", DENO_DIR=str(dataset.with_name("deno")))
    try:
        issues = json.loads(result.read_text())["issues"]["issues"]
    except (OSError, ValueError, KeyError):
        return status or 1, [output]
    return status, [issue["code"] for issue in issues if issue["severity"] == "error"]


def motion_stem(session: str, trial: dict[str, str], tracker: str = "") -> str:
    task = {"tap": "tap", "horizontal_drag": "horizontalDrag"}[trial["gesture"]]
    system = f"_tracksys-{tracker}" if tracker else ""
    return f"{session}/motion/{session.replace('/', '_')}_task-{task}{system}_run-{int(trial['trial']):04d}"


def source(study: Path, name: str) -> list[dict[str, str]]:
    return [row for session in SESSIONS for row in read(study / session / name)]


def answers_of(table: Path) -> Path:
    return table.with_name(f"{table.stem}_answers.csv")


def read(path: Path, delimiter: str = ",") -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, delimiter=delimiter))


def lines(path: Path) -> list[list[str]]:
    return [line.split("\t") for line in path.read_text().splitlines()]


def near(found: str, expected: str) -> bool:
    """Equal texts, or numbers within the tolerance."""
    if found == expected:
        return True
    try:
        return abs(float(found) - float(expected)) <= TOLERANCE
    except ValueError:
        return False
