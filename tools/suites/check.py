"""A linter's run as an outcome."""

from suites.outcome import Outcome
from suites.process import run


def check(name: str, command: list) -> Outcome:
    status, output = run(["nice", *command])  # what runs beside may have something to hear or to time
    return Outcome.of(f"lint/{name}", status == 0, output)
