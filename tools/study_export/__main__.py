#!/usr/bin/env python3
"""Exports the sessions of a study as tidy tables for R and pandas, or as a BIDS dataset."""

import argparse
import sys
from pathlib import Path

from study_export.bids_dataset import write_dataset
from study_export.sessions import read_sessions
from study_export.tables import Findings
from study_export.tidy import write_tidy

# Exit codes, as those of the module study.
INCOMPLETE = 1
BAD_INPUT = 2


def main() -> int:
    parser = argparse.ArgumentParser(prog="./steadyhand study", description=__doc__)
    parser.add_argument("study", type=Path, metavar="DIR", help="folder of the study, or any folder above its sessions")
    parser.add_argument(
        "--tidy", type=Path, metavar="OUT.csv", help="write OUT.csv, OUT_answers.csv and OUT_codebook.csv"
    )
    parser.add_argument("--bids", type=Path, metavar="OUTDIR", help="write a BIDS dataset into a new folder")
    given = parser.parse_args()
    if not (given.tidy or given.bids):
        parser.error("name --tidy OUT.csv, --bids OUTDIR, or both")

    found = Findings()
    sessions = read_sessions(given.study, found)
    trials = sum(len(session.trials) for session in sessions)
    failure = ""
    if not trials and not found.faults:
        failure = (
            f"{given.study}: no finished trial in it. Name the folder that has sub-NAME/ses-NN/session.json below it"
        )
    written = []
    if trials:
        try:
            if given.tidy:
                written += [str(path) for path in write_tidy(sessions, given.tidy)]
            if given.bids:
                write_dataset(sessions, given.bids, found)
                written.append(str(given.bids))
        except ValueError as fault:
            failure = str(fault)
        except OSError as fault:
            failure = f"cannot write {fault.filename or ''}: {fault.strerror or fault}"
    for line in [*found.notes, *found.faults, *filter(None, [failure])]:
        print(f"study: {line}", file=sys.stderr)
    if written:
        answers = sum(len(session.answers) for session in sessions)
        print(f"{len(sessions)} sessions, {trials} trials, {answers} answers: wrote {', '.join(written)}")
    if failure or not trials:
        return BAD_INPUT
    return INCOMPLETE if found.faults else 0


if __name__ == "__main__":
    sys.exit(main())
