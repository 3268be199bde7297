"""A linter's run as an outcome."""

from suites.outcome import Outcome
from suites.process import run


def check(name: str, command: list) -> Outcome:
    status, output = run(["nice", *command])  # parallel tests may measure audio or time
    return Outcome.of(f"lint/{name}", status == 0, output)
