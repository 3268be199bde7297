"""The add-on's zip: unpacked into an empty project, exported for release, and run; its vibration is recorded.

For Linux on x86-64; the suite `platforms` has the others.
"""

import os
import re
import shutil
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from dist import addon
from suites.outcome import Outcome
from suites.process import ROOT, run

GAME = ROOT / "tests/dist/project"
PLATFORM = "linux.x86_64"
SPRING_HZ = 180.0
SET_UP_S = 600
BUILD_S = 3600
KILL_S = 120
COMPLAINT = re.compile(r"^\s*(?:SCRIPT ERROR|ERROR|USER ERROR|Parse Error)", re.MULTILINE)


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_dist") as name:
        folder = Path(name)
        command = ["./steadyhand", "dist", "--out", folder, "--platform", PLATFORM]
        status, output = run(command, kill_s=BUILD_S)
        path = folder / f"steadyhand-{addon.version()}.zip"
        yield Outcome.of("dist/the zip is written", status == 0 and path.is_file(), output)
        if path.is_file():
            yield from contents(path)
            yield from installed(path, folder)


def contents(path: Path, built_for: str = PLATFORM) -> Iterator[Outcome]:
    with zipfile.ZipFile(path) as zipped:
        names = zipped.namelist()
        text = zipped.read(f"{addon.INSIDE}/steadyhand.gdextension").decode()
        libraries = {name.rpartition("/")[2]: zipped.read(name) for name in names if "/bin/" in name}
    outside = [name for name in names if not name.startswith(f"{addon.INSIDE}/")]
    yield Outcome.of("dist/all files are in addons/steadyhand", not outside, "\n".join(outside))
    wanted = "LICENSE licenses/README.md README.md icon.svg plugin.cfg editor/plugin.gd models/tap.gesture"
    absent = [name for name in wanted.split() if f"{addon.INSIDE}/{name}" not in names]
    yield Outcome.of("dist/licences, icon, models and editor scripts are inside", not absent, "\n".join(absent))
    source = [name for name in names if name.endswith((".cpp", ".h", ".o", ".a"))]
    yield Outcome.of("dist/no source is inside", not source, "\n".join(source))
    named = set(re.findall(r'/bin/([^/"]+)"', text))
    yield Outcome.of("dist/the .gdextension names the libraries inside", named == set(libraries), f"{named}\n{names}")
    debug = [name for name, data in libraries.items() if b".debug_info" in data]
    yield Outcome.of("dist/libraries have no debug information", bool(libraries) and not debug, "\n".join(debug))
    places = [name for name, data in libraries.items() if str(ROOT).encode() in data]
    yield Outcome.of("dist/libraries name no folder of this machine", not places, "\n".join(places))
    with tempfile.TemporaryDirectory(prefix="steadyhand_dist") as folder:
        again = Path(folder, path.name)
        addon.write(again, built_for.split(","))
        yield Outcome.of("dist/the same build gives the same bytes", again.read_bytes() == path.read_bytes())


def installed(path: Path, folder: Path) -> Iterator[Outcome]:
    godot = os.environ["GODOT"]
    status, output = run([ROOT / "tools/setup_templates.sh"], kill_s=SET_UP_S)
    if status != 0:
        yield Outcome(f"dist: {output.strip().splitlines()[-1]}", skipped=1)
        return
    root = Path(output.splitlines()[-1])
    project, exported = folder / "project", folder / "exported"
    make_project(project, path, root)
    exported.mkdir()
    # The first import aborts (godotengine/godot#111048).
    run([godot, "--headless", "--path", project, "--import"], kill_s=KILL_S)
    status, output = run([godot, "--headless", "--path", project, "--import"], kill_s=KILL_S)
    good = status == 0 and not COMPLAINT.search(output)
    yield Outcome.of("dist/an empty project imports the unpacked add-on", good, output)
    command = [godot, "--headless", "--path", project, "--export-release", "Linux", exported / "game.x86_64"]
    status, output = run(command, kill_s=KILL_S)
    inside = sorted(one.name for one in exported.glob("*.so"))
    good = status == 0 and inside == ["libsteadyhand.linux.template_release.x86_64.so"]
    yield Outcome.of("dist/the export has the release library", good, f"{inside}\n{output}")
    if good:
        yield from heard(root, exported, folder)


def make_project(project: Path, path: Path, templates: Path) -> None:
    shutil.copytree(GAME, project)
    presets = project / "export_presets.cfg"
    presets.write_text(presets.read_text().replace("TEMPLATES", str(templates)))
    with zipfile.ZipFile(path) as zipped:
        zipped.extractall(project)


def heard(root: Path, exported: Path, folder: Path) -> Iterator[Outcome]:
    """The game finds its .pck by the name of the running program, the loader of its root: it has the .pck's name."""
    libraries = root / "usr/lib/x86_64-linux-gnu"
    shutil.copy(libraries / "ld-linux-x86-64.so.2", exported / "game")
    game = [exported / "game", "--library-path", f"{libraries}:{libraries}/pulseaudio", exported / "game.x86_64"]
    status, output = run([*game, "--headless", "--", folder], kill_s=KILL_S)
    ended = re.search(r"^END horizontal_drag, ([\d.]+) Hz$", output, re.MULTILINE)
    good = status == 0 and ended and "release build, exported: true" in output and not COMPLAINT.search(output)
    yield Outcome.of("dist/the exported game recognises a drag", bool(good), f"status {status}\n{output}")
    if not good:
        return
    bus = np.frombuffer((folder / "bus.raw").read_bytes(), dtype="<f4")[::2]
    yield is_spring("dist/the exported game's bus carries 180 Hz", bus, float(ended[1]))
    wav = np.frombuffer((folder / "vibration.wav").read_bytes()[44:], dtype="<i2") / 32768
    rate_hz = int.from_bytes((folder / "vibration.wav").read_bytes()[24:28], "little")
    yield is_spring("dist/the exported game's WAV file has 180 Hz", wav, rate_hz)


def is_spring(name: str, samples: np.ndarray, rate_hz: float) -> Outcome:
    """Half of the power or more is within 10 Hz of the spring's carrier: the drag's own motion is far slower."""
    power = np.abs(np.fft.rfft(samples)) ** 2
    frequency_hz = np.fft.rfftfreq(len(samples), 1.0 / rate_hz)
    near = power[np.abs(frequency_hz - SPRING_HZ) < 10.0].sum() / max(power.sum(), 1e-30)
    peak = float(np.abs(samples).max(initial=0.0))
    return Outcome.of(name, peak > 0.1 and near > 0.5, f"peak {peak}, share {near} near {SPRING_HZ} Hz")
