"""One line of the test report."""

from dataclasses import dataclass


@dataclass
class Outcome:
    name: str
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    output: str = ""  # shown if anything failed

    @classmethod
    def of(cls, name: str, good: bool, output: str = "") -> "Outcome":
        return cls(name, passed=int(good), failed=int(not good), output=output)
