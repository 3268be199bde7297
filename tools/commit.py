"""The commit that figures were made with."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def commit_of(sources: list[str]) -> str:
    """The last commit that changed these paths, as ", commit HASH" with a note of changes since. Without git: ""."""
    try:
        commit = git("log", "-1", "--format=%h", "--", *sources).strip()
        changes = git("status", "--porcelain", "--", *sources)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return f", commit {commit}{' with changes' if changes else ''}" if commit else ""


def git(*words: str) -> str:
    return subprocess.run(["git", "-C", ROOT, *words], check=True, capture_output=True, text=True).stdout
