"""XRSource end to end: Godot in a session of Monado, an OpenXR runtime, whose simulated hands the test moves.

Monado's remote driver takes the hands' places on a TCP port of all interfaces: it runs in a network namespace of its
own. Xvfb is the screen, lavapipe the graphics card. Where one of them cannot be had the suite is skipped.
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
from pathlib import Path

from suites import scenes
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

TESTS = ROOT / "tests/openxr"
SCRIPT = TESTS / "xr_source.gd"
NAME = "openxr/xr_source"
KILL_S = 90
SET_UP_S = 600
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
    own_network = next((words for words in NAMESPACES if run([*words, "true"])[0] == 0), None)
    if own_network is None or shutil.which("Xvfb") is None:
        yield skipped("no Xvfb" if own_network else "no network namespace of its own")
        return
    status, output = run([ROOT / "tools/setup_openxr.sh"], kill_s=SET_UP_S)
    if status != 0:
        yield skipped(output)
        return
    in_root = output.splitlines()[-1]
    status, output = scons()
    if status == 0:
        status, output = run([ROOT / "tools/import_project.sh", os.environ["GODOT"], scenes.PROJECT])
    if status != 0:
        yield Outcome.of(f"{NAME}: the add-on is built and imported", False, output)
        return
    with tempfile.TemporaryDirectory(prefix="steadyhand_openxr") as folder:
        make_project(Path(folder))
        session = [*own_network, sys.executable, "-m", "suites.openxr", in_root, folder]
        status, output = run(session, kill_s=KILL_S, PYTHONPATH=str(ROOT / "tools"))
    yield scenes.outcome_of(NAME, SCRIPT, status, output)


def skipped(reason: str) -> Outcome:
    print(f"      {NAME}: {reason}", flush=True)
    return Outcome(NAME, skipped=1)


def make_project(folder: Path) -> None:
    """The tests' project settings, and the add-on as it was imported into the demo."""
    (folder / "project.godot").symlink_to(TESTS / "project.godot")
    (folder / "addons").symlink_to(scenes.PROJECT / "addons")
    (folder / ".godot").mkdir()
    shutil.copy(scenes.PROJECT / ".godot/extension_list.cfg", folder / ".godot")


def session(in_root: str, project: str) -> None:
    """Within the namespace: prints what Godot prints. Whoever is ended takes all that it started along."""
    die_with_parent()
    bring_up_loopback()
    with tempfile.TemporaryDirectory(prefix="steadyhand_openxr") as folder:
        environment = {**os.environ, "XDG_RUNTIME_DIR": folder, "XDG_CONFIG_HOME": folder, "XDG_DATA_HOME": folder}
        reading, writing = os.pipe()
        start(["Xvfb", "-displayfd", str(writing), "-screen", "0", "320x240x24"], environment, [writing])
        os.close(writing)
        environment["DISPLAY"] = ":" + os.read(reading, 16).decode().strip()
        monado = start([in_root, "monado-service"], {**environment, **MONADO})
        while not Path(folder, "monado_comp_ipc").is_socket():
            if monado.poll() is not None:
                sys.exit("Monado ended")
            time.sleep(0.05)
        options = "--rendering-method mobile --rendering-driver vulkan --audio-driver Dummy --xr-mode on"
        window = ["--no-header", "--resolution", "64x64"]
        command = [in_root, "godot", *options.split(), *window, "--path", project, "--script", str(SCRIPT)]
        godot = subprocess.run(command, env=environment, preexec_fn=die_with_parent, check=False)
    print(f"Godot ended with {godot.returncode}")


def start(command: list[str], environment: dict[str, str], descriptors: list[int] = ()) -> subprocess.Popen:
    log = Path(environment["XDG_RUNTIME_DIR"], Path(command[-1]).name + ".log")
    with log.open("w") as file:
        return subprocess.Popen(
            command,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=file,
            stderr=file,
            pass_fds=descriptors,
            preexec_fn=die_with_parent,
        )


def die_with_parent() -> None:
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def bring_up_loopback() -> None:
    with socket.socket() as any_socket:
        fcntl.ioctl(any_socket, SIOCSIFFLAGS, struct.pack("16sh14x", b"lo", IFF_UP_RUNNING))


if __name__ == "__main__":
    session(*sys.argv[1:])
