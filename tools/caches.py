"""The cache folder outside the work tree, and removal of old entries."""

import os
import time
from pathlib import Path

KEPT_S = 14 * 86400


def folder() -> Path:
    """The cache folder. It must be the same as in tools/shell.sh."""
    user = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("STEADYHAND_CACHE") or Path(user) / "steadyhand")


def forget_unused(objects: Path) -> None:
    """Removes objects unused for KEPT_S. `objects` is a CacheDir of SCons, which touches the files it uses."""
    for kept in objects.glob("*/*"):
        if time.time() - kept.stat().st_mtime > KEPT_S:
            kept.unlink(missing_ok=True)
