"""Child processes with a kill time."""

import os
import signal
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KILLED = "killed after {} s"


def run(command: list, kill_s: float = 600, **environment: str) -> tuple[int, str]:
    """Runs it in the repo's root. Returns exit status and output. A killed process has a status other than 0."""
    child = subprocess.Popen(
        [str(word) for word in command],
        cwd=ROOT,
        env={**os.environ, **environment},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        process_group=0,  # not a session: some kernels share time by sessions, and `nice` has no effect between them
    )
    try:
        output, _ = child.communicate(timeout=kill_s)
        return child.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(child.pid, signal.SIGKILL)
        output, _ = child.communicate()
        return -signal.SIGKILL, f"{output}\n{KILLED.format(kill_s)}"


def scons(*arguments: str) -> tuple[int, str]:
    return run(["scons", "-s", *arguments], kill_s=1800)
