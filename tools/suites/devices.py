"""LibertyDevice on a simulated Liberty, which umockdev adds to the USB of the program under test.

The probe prints an event a line; the simulator prints the commands that it received. The sanitized probes run the
cases, so that a leak, an overflow or a race fails them too. Without umockdev the cases are skipped.
"""

import math
import os
import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise

from suites import scenes
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

BUILDS = {"plain": "", "address": "address,undefined", "thread": "thread"}
KILL_S = 30
PATIENCE_S = 20.0  # for a part of the stream; it comes within some seconds
# The thread sanitizer's symbolizer crashes under umockdev's preload: addr2line reads the offsets of a report.
SANITIZERS = {"UBSAN_OPTIONS": "print_stacktrace=1", "TSAN_OPTIONS": "symbolize=0"}
UNPLUG = ["--unplug-after", "1.0", "--replug-after", "1.0"]
GODOT_CASES = {
    "drag": [],
    "unplug": UNPLUG,
    "missing": ["--no-device"],
    "firmware": ["--firmware-missing"],
    "permission": ["--no-permission"],
}
WORKERS = 4  # the programs wait most of the time
RATE_HZ = 240
COMMANDS = "(empty) P F1 ^U0 U1 R4 H*,1.0000,0.0000,0.0000 X0,1,0,0 Y0,1,0,0 @B0 O*,8,9,11,3,7 Q0 C P"
TREMOR_M = 1e-4  # the simulated tremor in three axes, and the rounding of the records


@dataclass
class Record:
    station: int
    host_s: float
    device_s: float
    lost: int
    is_tracked: bool
    is_mirrored: bool
    position_m: tuple[float, float, float]

    @classmethod
    def of(cls, text: str) -> "Record":
        station, host_s, device_s, lost, tracked, mirrored, x, y, z = text.split()
        times = float(host_s), float(device_s)
        return cls(int(station), *times, int(lost), tracked == "1", mirrored == "1", (float(x), float(y), float(z)))


@dataclass
class Session:
    """What the probe and the simulator printed."""

    records: list[Record] = field(default_factory=list)
    events: list[tuple[str, float, str]] = field(default_factory=list)  # kind, host time, text
    commands: str = ""
    overloads: int = 0  # frames that the computer fetched too late

    def texts(self, kind: str) -> list[str]:
        return [text for this, _, text in self.events if this == kind]

    def of_station(self, station: int) -> list[Record]:
        return [record for record in self.records if record.station == station]


@dataclass
class Case:
    name: str
    build: str
    seconds: float
    options: list[str]
    check: Callable[[Session], list[str]]  # the faults that it finds
    environment: dict[str, str] = field(default_factory=dict)
    connection: int = 0  # 0: it runs for `seconds`; else until `seconds` of this connection's stream have come


def outcomes() -> Iterator[Outcome]:
    has_headers = run(["pkg-config", "--exists", "umockdev-1.0", "gio-2.0"])[0] == 0
    if shutil.which("umockdev-wrapper") is None or not has_headers:
        yield from (Outcome(f"devices/{case.name}", skipped=1) for case in CASES)
        return
    for build, sanitizers in BUILDS.items():
        status, output = scons("device_programs", f"sanitize={sanitizers}")
        if status != 0:
            yield Outcome.of(f"devices/{build} builds", False, output)
            return
    with ThreadPoolExecutor(WORKERS) as pool:
        yield from pool.map(run_case, CASES)
        yield from pool.map(run_godot, GODOT_CASES.items())


def run_godot(case: tuple[str, list[str]]) -> Outcome:
    """The scene test of LibertySource, in an engine started by the simulator."""
    name, options = case
    script = "liberty_faults" if options else "liberty_source"
    simulator = ["umockdev-wrapper", ROOT / "build/devices/liberty_sim", *options]
    path = ROOT / f"tests/devices/{script}.gd"
    return scenes.run_script(os.environ["GODOT"], path, simulator, [name], f"devices/LibertySource: {name}")


def run_case(case: Case) -> Outcome:
    variant = ".".join(["template_debug", *filter(None, [BUILDS[case.build].replace(",", "_")])])
    simulator = ["umockdev-wrapper", ROOT / "build/devices/liberty_sim", "--print-commands", *case.options]
    ends = [PATIENCE_S, case.seconds, case.connection] if case.connection else [case.seconds]
    command = [*simulator, ROOT / "build" / variant / "liberty_probe", *ends]
    status, output = run(command, kill_s=KILL_S, **SANITIZERS, **case.environment)
    session, strange = read(output)
    faults = [f"exit status {status}"] if status != 0 else []
    faults += [f"unexpected line: {line}" for line in strange]
    faults += case.check(session) if not faults else []
    shown = [line for line in output.splitlines() if not line.startswith("record ")]
    text = "\n".join([*shown, f"{len(session.records)} records", *(f"-> {fault}" for fault in faults)])
    return Outcome.of(f"devices/{case.name} ({case.build})", not faults, text)


def read(output: str) -> tuple[Session, list[str]]:
    """The session, and other lines, such as those of a sanitizer."""
    session, strange = Session(), []
    for line in output.splitlines():
        kind, _, rest = line.partition(" ")
        try:
            if kind == "record":
                session.records.append(Record.of(rest))
            elif kind in ("connected", "warning", "note", "failure"):
                host_s, _, text = rest.partition(" ")
                session.events.append((kind, float(host_s), text))
            elif kind == "commands":
                session.commands = rest
            elif kind == "overloads":
                session.overloads = int(rest)
            elif line != "end 0 dropped":
                strange.append(line)
        except ValueError:
            strange.append(line)
    return session, strange


def expected_m(t_s: float, station: int) -> tuple[float, float, float]:
    """The simulated fingertip: 1.0 s of rest, 20 cm in 0.8 s (Flash & Hogan 1985), 1.2 s of rest, 0.8 s back."""
    t = math.fmod(t_s, 3.8)
    phase = min(max((t - 1.0) / 0.8, 0.0), 1.0) - min(max((t - 3.0) / 0.8, 0.0), 1.0)
    path = 10 * phase**3 - 15 * phase**4 + 6 * phase**5
    return 0.2 * path, 0.25 + 0.1 * (station - 1), -0.3


def stream_faults(session: Session, records: list[Record], seconds: float) -> list[str]:
    """Faults of one station's unbroken stream that must last so long, on the tracker's clock."""
    faults = []
    if not records or records[-1].device_s - records[0].device_s < seconds:
        return [f"{len(records)} records, {records[:1]} to {records[-1:]}, must last {seconds} s"]
    for before, after in pairwise(records):
        frames = (after.device_s - before.device_s) * RATE_HZ
        if abs(frames - 1 - after.lost) > 0.01:
            faults.append(f"{frames:.3f} frames at {after.device_s} s, {after.lost} lost")
    lost = sum(record.lost for record in records[1:])
    if lost > session.overloads:
        faults.append(f"{lost} frames lost, the computer fetched {session.overloads} too late")
    # A busy computer only delays records: the least delay of each half compares the clocks.
    delays_s = [record.host_s - record.device_s for record in records]
    middle = len(records) // 2
    drift_s = min(delays_s[middle:]) - min(delays_s[:middle])
    if abs(drift_s) > 0.1:
        faults.append(f"the clocks differ by {drift_s} s")
    for record in records:
        off_m = math.dist(record.position_m, expected_m(record.device_s, record.station))
        if off_m > TREMOR_M or not record.is_tracked:
            faults.append(f"station {record.station} at {record.device_s} s: {record.position_m}")
    return faults[:5]


def only(session: Session, kind: str, wanted: list[str]) -> list[str]:
    """Faults if the texts of a kind differ from these; "..." at the end stands for any rest."""
    found = session.texts(kind)
    same = len(found) == len(wanted) and all(
        text.startswith(want.removesuffix("...")) if want.endswith("...") else text == want
        for text, want in zip(found, wanted, strict=True)
    )
    return [] if same else [f"{kind}: {found}, must be {wanted}"]


def streams(session: Session, seconds: float, stations: int = 1) -> list[str]:
    names = ", ".join(str(station) for station in range(1, stations + 1))
    faults = only(session, "connected", [f"Liberty: 240 Hz, stations {names}."])
    faults += only(session, "failure", []) + only(session, "warning", []) + only(session, "note", [])
    if session.commands != COMMANDS:
        faults.append(f"commands: {session.commands}")
    for station in range(1, stations + 1):
        faults += stream_faults(session, session.of_station(station), seconds)
    return faults


def comes_back(session: Session) -> list[str]:
    connected = "Liberty: 240 Hz, stations 1."
    faults = only(session, "connected", [connected, connected])
    faults += only(session, "failure", ["Liberty: the connection was lost. Check the USB cable..."])
    if faults:
        return faults
    again_s = [host_s for kind, host_s, _ in session.events if kind == "connected"][1]
    before = [record for record in session.records if record.host_s < again_s]
    after = [record for record in session.records if record.host_s >= again_s]
    return stream_faults(session, before, 0.9) + stream_faults(session, after, 0.9)


def fails(session: Session, text: str) -> list[str]:
    return only(session, "failure", [text]) + only(session, "connected", [])


def is_slow(session: Session) -> list[str]:
    faults = only(session, "warning", ["Liberty: 10 frames a second arrive, must be 240. Plug..."])
    connected_s, warned_s = (host_s for kind, host_s, _ in session.events if kind in ("connected", "warning"))
    if not 1.9 < warned_s - connected_s < 2.5:
        faults.append(f"warned after {warned_s - connected_s} s")
    return faults


def flips(session: Session) -> list[str]:
    faults = only(session, "warning", ["Liberty station 1: the sensor left the hemisphere of the source. Place..."])
    mirrored = [record.device_s for record in session.records if record.is_mirrored]
    if not mirrored or not (1.39 < mirrored[0] < 1.42 and 2.38 < mirrored[-1] < 2.41):
        faults.append(f"mirrored from {mirrored[:1]} to {mirrored[-1:]} s")
    return faults + stream_faults(session, session.records, 2.5)


NO_LIBUSB = {"STEADYHAND_LIBUSB": "/none/libusb.so"}
CASES = [
    Case("unplugged and plugged in again, it streams again", "address", 1.0, UNPLUG, comes_back, connection=2),
    Case("unplugging is no race", "thread", 1.0, UNPLUG, comes_back, connection=2),
    Case("a tracker without answers fails", "address", 5.5, ["--silent"],
         partial(fails, text="Liberty: cannot read which sensors are plugged in: the tracker does not answer. Switch "
                 "it off and on and wait 10 s.")),
    Case("10 Hz in place of 240 warns", "address", 3.8, ["--rate", "10"], is_slow),
    Case("mirror images are mirrored back", "address", 2.7, ["--flip"], flips, connection=1),
    Case("240 Hz come with times and positions", "address", 2.6, [], partial(streams, seconds=2.5), connection=1),
    Case("streaming is no race", "thread", 1.3, [], partial(streams, seconds=1.2), connection=1),
    Case("split transfers and garbage of three stations", "plain", 1.3,
         ["--split", "--garbage", "--stations", "3"], partial(streams, seconds=1.2, stations=3), connection=1),
    Case("a stream that a crash left is stopped first", "address", 1.1,
         ["--streaming", "--split"], partial(streams, seconds=1.0), connection=1),
    Case("a refused setting is a warning", "address", 2.0, ["--refuse", "H"],
         lambda session: only(session, "warning", [
             "Liberty: cannot set the hemisphere: command 'H' failed with error 3: invalid parameter. The tracker says "
             '"Invalid Parameter"....']) + only(session, "connected", ["Liberty: 240 Hz, stations 1."])),
    Case("no sensor is a warning", "address", 2.0, ["--stations", "0"],
         lambda session: only(session, "warning", ["Liberty: no sensor is plugged in. Plug one..."])),
    Case("a stop while it starts ends at once", "thread", 0.4, [], lambda session: only(session, "failure", [])),
    Case("missing firmware fails", "address", 1.3, ["--firmware-missing"],
         partial(fails, text="Liberty: the tracker has no firmware (USB id 0f44:ff21). Load...")),
    Case("no permission fails", "address", 1.3, ["--no-permission"],
         partial(fails, text="Liberty: no permission to open the tracker (USB id 0f44:ff20). Add the udev rule...")),
    Case("a busy tracker fails", "address", 1.3, ["--busy"],
         partial(fails, text="Liberty: another program uses the tracker (USB id 0f44:ff20). Close it.")),
    Case("no tracker fails", "address", 1.3, ["--no-device"],
         partial(fails, text="Liberty: no tracker was found. Plug in...")),
    Case("no libusb fails", "address", 0.2, ["--no-device"],
         partial(fails, text="Liberty: cannot load libusb-1.0 (/none/libusb.so..."), NO_LIBUSB),
]  # fmt: skip
