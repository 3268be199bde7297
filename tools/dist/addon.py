"""What the add-on's zip holds: the files of the add-on's folder, and its libraries without debug information."""

import re
import subprocess
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import platforms

ROOT = Path(__file__).resolve().parents[2]
ADDON = ROOT / "demo_project/addons/steadyhand"
INSIDE = "addons/steadyhand"
TARGETS = ["template_debug", "template_release"]
STRIP = {
    "linux.x86_64": "x86_64-linux-gnu-strip",
    "linux.arm64": "aarch64-linux-gnu-strip",
    "windows.x86_64": "x86_64-w64-mingw32-strip",
}
CHANGED = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip can hold: the build's own would differ each time
UNIX, MODE = 3, 0o100644


def version() -> str:
    found = re.search(r'^version="([^"]+)"', (ADDON / "plugin.cfg").read_text(), re.MULTILINE)
    if not found:
        raise SystemExit(f'{ADDON}/plugin.cfg: no line version="..."')
    return found[1]


def write(path: Path, built_for: list[str]) -> None:
    """The zip of the add-on with the libraries of these PLATFORM.ARCH. The same files give the same bytes."""
    libraries = {library: one for one in built_for for library in libraries_of(one)}
    files = dict(resources())
    files["steadyhand.gdextension"] = of_libraries(ADDON / "steadyhand.gdextension", set(libraries))
    files |= {f"bin/{library}": stripped(ADDON / "bin" / library, STRIP[one]) for library, one in libraries.items()}
    half = path.with_name(f"{path.name}.part")
    with zipfile.ZipFile(half, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as zipped:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"{INSIDE}/{name}", CHANGED)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system, entry.external_attr = UNIX, MODE << 16
            zipped.writestr(entry, files[name])
    half.replace(path)


def libraries_of(one: str) -> list[str]:
    platform, arch = one.split(".")
    return [platforms.library(platform, target, arch) for target in TARGETS]


def stripped(library: Path, program: str) -> bytes:
    """Without the build's identity too, which is a hash of the debug information and so of folders of this machine.

    strip writes its own time into a Windows library unless it preserves dates.
    """
    with tempfile.TemporaryDirectory(prefix="steadyhand_dist") as folder:
        out = Path(folder, library.name)
        options = ["--strip-unneeded", "--preserve-dates", "--remove-section=.note.gnu.build-id"]
        subprocess.run([program, *options, "-o", out, library], check=True)
        return out.read_bytes()


def resources() -> Iterator[tuple[str, bytes]]:
    """Path below the add-on's folder, and content, of all that is not compiled."""
    for path in sorted(ADDON.rglob("*")):
        place = path.relative_to(ADDON)
        of_absent = path.suffix in (".uid", ".import") and not path.with_suffix("").exists()
        if path.is_file() and place.parts[0] not in ("bin", "models") and not of_absent:
            yield place.as_posix(), path.read_bytes()
    for path in sorted((ROOT / "models").glob("*.gesture")):
        yield f"models/{path.name}", path.read_bytes()
    yield "icon.svg", (ROOT / "demo_project/icon.svg").read_bytes()
    yield "CHANGELOG.md", (ROOT / "CHANGELOG.md").read_bytes()


def of_libraries(path: Path, libraries: set[str]) -> bytes:
    """The .gdextension file without the rows of other libraries: Godot then says which platform is not supported."""
    rows = path.read_text().splitlines(keepends=True)
    kept = [row for row in rows if (found := re.search(r"/bin/([^/\"]+)\"", row)) is None or found[1] in libraries]
    named = {found[1] for row in kept if (found := re.search(r"/bin/([^/\"]+)\"", row))}
    if named != libraries:
        raise SystemExit(f"{path}: no row of {', '.join(sorted(libraries - named))}")
    return "".join(kept).encode()
