"""XRSource and the study end to end: Godot in a session of Monado, an OpenXR runtime, whose hands the test moves.

Monado's remote driver takes the hands' places on a TCP port of all interfaces: it runs in a network namespace of its
own. Xvfb is the screen, lavapipe the graphics card. Without one of them the suite is skipped.
"""

import ctypes
import fcntl
import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import IO

from suites import scenes
from suites.outcome import Outcome
from suites.process import ROOT, run

TESTS = ROOT / "tests/openxr"
NAME = "openxr"
STUDY = "study_scene"
KILL_S = 90
GODOT_S = 75
SERVER_S = 10
SET_UP_S = 600
DISPLAYS = range(90, 200)
NAMESPACES = (["unshare", "--net"], ["unshare", "--map-root-user", "--net"])
PR_SET_PDEATHSIG = 1
SIOCSIFFLAGS, IFF_UP_RUNNING = 0x8914, 0x41
MONADO = {
    "P_OVERRIDE_ACTIVE_CONFIG": "remote",
    "XRT_NO_STDIN": "1",
    "XRT_COMPOSITOR_FORCE_XCB": "1",
    "XRT_COMPOSITOR_SCALE_PERCENTAGE": "20",
    "XRT_COMPOSITOR_DEFAULT_FRAMERATE": "60",
}


def outcomes() -> Iterator[Outcome]:
    for program in ("Xvfb", "unshare"):
        if shutil.which(program) is None:
            yield skipped(f"no {program}")
            return
    own_network = next((words for words in NAMESPACES if run([*words, "true"])[0] == 0), None)
    if own_network is None:
        yield skipped("no network namespace can be made")
        return
    status, output = run([ROOT / "tools/setup_openxr.sh"], kill_s=SET_UP_S)
    if status != 0:
        yield skipped(output.strip().splitlines()[-1])
        return
    in_root = output.splitlines()[-1]
    status, output = scenes.build()
    if status != 0:
        yield Outcome.of(f"{NAME}: the add-on is built and imported", False, output)
        return
    with tempfile.TemporaryDirectory(prefix="steadyhand_openxr") as folder:
        make_project(Path(folder))
        for name, project in (("xr_source", folder), (STUDY, str(scenes.PROJECT))):
            session = [*own_network, sys.executable, "-m", "suites.openxr", in_root, project, name]
            status, output = run(session, kill_s=KILL_S, PYTHONPATH=str(ROOT / "tools"))
            yield scenes.outcome_of(f"{NAME}/{name}", TESTS / f"{name}.gd", status, output)


def skipped(reason: str) -> Outcome:
    return Outcome(f"{NAME}: {reason}", skipped=1)


def make_project(folder: Path) -> None:
    """The tests' project settings, and the add-on as it was imported into the demo."""
    (folder / "project.godot").symlink_to(TESTS / "project.godot")
    (folder / "addons").symlink_to(scenes.PROJECT / "addons")
    (folder / ".godot").mkdir()
    shutil.copy(scenes.PROJECT / ".godot/extension_list.cfg", folder / ".godot")


def session(in_root: str, project: str, name: str) -> None:
    """Runs in the namespace and prints Godot's output. The end of the session ends all its processes."""
    die_with_parent(signal.SIGKILL)
    bring_up_loopback()
    children: list[subprocess.Popen] = []
    with tempfile.TemporaryDirectory(prefix="steadyhand_openxr") as folder:
        environment = {**os.environ, "XDG_RUNTIME_DIR": folder, "XDG_CONFIG_HOME": folder, "XDG_DATA_HOME": folder}
        try:
            environment["DISPLAY"] = start_screen(children)
            start_monado(in_root, environment, children)
            options = "--rendering-method mobile --rendering-driver vulkan --audio-driver Dummy --xr-mode on"
            godot = [in_root, "godot", *options.split(), "--resolution", "64x64", "--path", project]
            godot += ["--script", TESTS / f"{name}.gd"]
            children.append(start(godot, environment, signal.SIGKILL, None))
            print(f"Godot ended with {children[-1].wait(GODOT_S)}")
        finally:
            for child in reversed(children):
                child.send_signal(signal.SIGTERM if child is children[0] else signal.SIGKILL)
                child.wait()


def start_screen(children: list[subprocess.Popen]) -> str:
    """Starts Xvfb and returns its name. Xvfb's own search misses servers of other network namespaces."""
    for number in DISPLAYS:
        lock, connection = Path(f"/tmp/.X{number}-lock"), Path(f"/tmp/.X11-unix/X{number}")
        if lock.exists() or connection.exists():
            continue
        command = ["Xvfb", f":{number}", "-screen", "0", "320x240x24"]
        children[:] = [start(command, os.environ, signal.SIGTERM)]  # it removes its lock
        if is_there(connection, children[0]):
            return f":{number}"
    raise RuntimeError("Xvfb does not start")


def start_monado(in_root: str, environment: dict[str, str], children: list[subprocess.Popen]) -> None:
    log = Path(environment["XDG_RUNTIME_DIR"], "monado.log")
    with log.open("w") as file:
        children.append(start([in_root, "monado-service"], {**environment, **MONADO}, signal.SIGKILL, file))
    if not is_there(log.with_name("monado_comp_ipc"), children[-1]):
        raise RuntimeError(f"Monado does not start\n{log.read_text()}")


def start(
    command: list, environment: dict[str, str], end_signal: int, output: IO | int | None = subprocess.DEVNULL
) -> subprocess.Popen:
    return subprocess.Popen(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=output,
        preexec_fn=partial(die_with_parent, end_signal),
    )


def is_there(connection: Path, server: subprocess.Popen) -> bool:
    until_s = time.monotonic() + SERVER_S
    while not connection.is_socket():
        if server.poll() is not None or time.monotonic() > until_s:
            return False
        time.sleep(0.05)
    return True


def die_with_parent(end_signal: int) -> None:
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, end_signal)


def bring_up_loopback() -> None:
    with socket.socket() as any_socket:
        fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sh14x", b"lo", IFF_UP_RUNNING))


if __name__ == "__main__":
    session(*sys.argv[1:])
