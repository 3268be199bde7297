#!/usr/bin/env python3
"""Analyse a study: statistics, tables and figures in one report.

A folder with session.json files (docs/study_files.md) gives OUT/report.html, OUT/*.csv and OUT/*.png. Logs of the
demo's task scenes (docs/study_logs.md) give tables of Fitts throughput.
"""

import argparse
import sys
from pathlib import Path

from study import demo_logs
from study.folders import session_files, sessions_without_json


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="./steadyhand study", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("logs", nargs="+", type=Path, metavar="DIR", help="folders of a study, or of the demo's logs")
    parser.add_argument("--report", "--out", required=True, type=Path, metavar="OUT", help="folder of the results")
    parser.add_argument(
        "--without", action="append", default=[], metavar="ID", help="leave this participant out (may be repeated)"
    )
    given = parser.parse_args()
    if not session_files(given.logs) and not sessions_without_json(given.logs):
        if given.without:
            parser.error("--without needs sessions with a session.json: there is none in the folders given")
        return demo_logs.run(given.logs, given.report)
    # Here, because pandas and pingouin take seconds to load.
    from study import report

    return report.run(given.logs, given.report, given.without)


if __name__ == "__main__":
    sys.exit(main())
