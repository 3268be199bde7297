"""Cache of sources that a linter has found clean, shared by all clones."""

import hashlib
from collections.abc import Iterable

import caches

FOLDER = caches.folder() / "clean"


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
    caches.drop_old(FOLDER.iterdir())
