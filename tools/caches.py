"""The cache folder outside the work tree, and removal of old entries."""

import os
import time
from collections.abc import Iterable
from pathlib import Path

KEPT_S = 30 * 86400


def folder() -> Path:
    """The cache folder. It must be the same as in tools/shell.sh."""
    user = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(os.environ.get("STEADYHAND_CACHE") or Path(user) / "steadyhand")


def prepare(objects: Path) -> bool:
    """Makes this cache of SCons, and deletes what no clone has used for long. False if it cannot be written.

    SCons sets the time of a file that it uses.
    """
    try:
        objects.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    drop_old(objects.glob("*/*"))
    return os.access(objects, os.W_OK)


def drop_old(files: Iterable[Path]) -> None:
    """Deletes the files that no clone has used for long. Who uses one must touch it."""
    for file in files:
        if time.time() - file.stat().st_mtime > KEPT_S:
            file.unlink(missing_ok=True)
