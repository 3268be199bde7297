"""The folder of all that is kept outside the work tree, and what in it nobody has used for long."""

import os
import time
from pathlib import Path

KEPT_S = 14 * 86400


def folder() -> Path:
    """As tools/shell.sh has it."""
    user = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("STEADYHAND_CACHE") or Path(user) / "steadyhand")


def forget_unused(objects: Path) -> None:
    """`objects` is a CacheDir of SCons, which sets the time of what it uses."""
    for kept in objects.glob("*/*"):
        if time.time() - kept.stat().st_mtime > KEPT_S:
            kept.unlink(missing_ok=True)
