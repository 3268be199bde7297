"""Cache of sources that a linter has found clean, shared by all clones."""

import hashlib
import sys
import time
from collections.abc import Iterable
from pathlib import Path

FOLDER = Path(sys.prefix).parent / "clean"
KEPT_S = 60 * 86400


def key_of(*parts: bytes | str) -> str:
    digests = [hashlib.sha256(part.encode() if isinstance(part, str) else part).digest() for part in parts]
    return hashlib.sha256(b"".join(digests)).hexdigest()[:32]


def is_clean(key: str) -> bool:
    return (FOLDER / key).exists()


def keep(keys: Iterable[str]) -> None:
    """Marks the keys as clean and used, and removes keys that no clone has used for long."""
    FOLDER.mkdir(exist_ok=True)
    for key in keys:
        (FOLDER / key).touch()
    for stamp in FOLDER.iterdir():
        if time.time() - stamp.stat().st_mtime > KEPT_S:
            stamp.unlink(missing_ok=True)
