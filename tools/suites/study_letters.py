"""Figures of ./steadyhand study with names and questions that are not in Latin letters."""

from collections.abc import Iterator
from pathlib import Path

from suites.made_up_sessions import Made, write_session
from suites.outcome import Outcome
from suites.process import run
from suites.study_folders import SMALL


def any_letters(folder: Path) -> Iterator[Outcome]:
    """Matplotlib warns of a letter that no font has, and draws a box."""
    for person in ("p1", "p2"):
        write_session(folder, Made(person, study="研究 연구 かな हिन्दी ไทย", **SMALL))
    for path in folder.rglob("answers.csv"):
        path.write_text(path.read_text("utf-8").replace(",smoothness,", ",流畅度,"), "utf-8")
    status, output = run(["./steadyhand", "study", folder, "--report", folder / "out"])
    good = status == 0 and "missing from" not in output
    yield Outcome.of("command/study report: figures have the letters of all languages", good, output)
    from study.box_figures import LETTERS, wrapped

    lines = wrapped("触觉反馈非常流畅。" * 10).split("\n")
    good = max(map(len, lines)) == LETTERS // 2 and wrapped("a " * 30).index("\n") == LETTERS - 1
    yield Outcome.of("command/study report: lines of wide letters have half as many", good, f"{lines}")
