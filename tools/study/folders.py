"""Finds the sessions below a folder."""

from pathlib import Path

from study.logs import set_apart

SESSION_FILE = "session.json"


def session_files(given: list[Path]) -> list[Path]:
    """Each session.json in or below the folders, once. A folder with a file no_study.txt is left out."""
    found: dict[Path, Path] = {}
    for folder in given:
        for path in sorted(folder.rglob(SESSION_FILE)) if folder.is_dir() else []:
            if not set_apart(path, folder):
                found.setdefault(path.resolve(), path)
    return list(found.values())


def sessions_without_json(given: list[Path]) -> list[Path]:
    """Folders named as a session that have rows but no session.json."""
    folders = {
        path.parent
        for folder in given
        if folder.is_dir()
        for path in folder.rglob("ses-*/trials.csv")
        if not set_apart(path, folder) and not (path.parent / SESSION_FILE).exists()
    }
    return sorted(folders)
