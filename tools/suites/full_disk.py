"""Files on a full disk: no incomplete file looks complete, and earlier files stay.

A limit of the file size simulates the disk. It is reached after 8192 bytes. The rest is smaller than a buffer, so
that the engine reports no error.
"""

import csv
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run

LIMITED = ["bash", "-c", "trap '' XFSZ; ulimit -f 8; exec \"$@\"", "limited"]

SCRIPT = """extends SceneTree

const Participant := preload("res://scripts/participant.gd")
const TrialLog := preload("res://scripts/trial_log.gd")

var _folder := OS.get_cmdline_user_args()[0]


func _initialize() -> void:
	var model := load("res://addons/steadyhand/models/tap.gesture")
	print("model refused: ", ResourceSaver.save(model, _folder.path_join("tap.gesture")) != OK)
	print("positions refused: ", _keep("x".repeat(8500)) != OK)
	_record()
	_vibrate.call_deferred()
	var log := TrialLog.new(_folder, {trial = "a", gesture = "tap", position = "", participant = ""})
	var hmm := GestureHMM.new()
	for i in 160:
		log.add(0.5 * i, "measured", hmm, 0.0)
	hmm.free()


func _keep(gesture: String) -> Error:
	var place := {position = Vector3.ZERO, seconds = 1.0, lost_share = 0.0, noise = 0.0}
	return Participant.new("ann", _folder).keep(gesture, {contrast = 1.0, stable = place, unstable = place})


func _record() -> void:
	var tracker := HandTracker.new()
	tracker.source = ScriptSource.new()
	tracker.start()
	tracker.start_recording(_folder.path_join("frames.csv"))
	for i in 400:
		tracker.push_frame(0.1 * i, {HandTracker.JOINT_INDEX: Vector3(0.1, 0.2, 0.001 * i)})
	tracker.free()


func _vibrate() -> void:
	var tracker := HandTracker.new()
	tracker.source = SyntheticSource.new()
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	var hmm := GestureHMM.new()
	hmm.tracker = tracker
	var synth := HapticSynth.new()
	synth.gesture_hmm = hmm
	synth.wav_sample_rate = 8000
	synth.wav_path = _folder.path_join("short.wav")
	for node: Node in [tracker, hmm, synth]:
		root.add_child(node)
	tracker.start()
	tracker.advance(0.6)
	synth.stop_wav()
	quit()
"""

# Vibration on a disk that is full for a while: 96 kB a second, written 64 KiB at a time.
VIBRATION_SCRIPT = """extends SceneTree

var _tracker := HandTracker.new()
var _synth := HapticSynth.new()


func _initialize() -> void:
	_play.call_deferred()


func _play() -> void:
	_tracker.source = SyntheticSource.new()
	_tracker.update_mode = HandTracker.UPDATE_MANUAL
	_synth.gesture_hmm = GestureHMM.new()
	_synth.gesture_hmm.tracker = _tracker
	_synth.wav_path = OS.get_cmdline_user_args()[0]
	for node: Node in [_tracker, _synth.gesture_hmm, _synth]:
		root.add_child(node)
	_tracker.start()
	_tracker.advance(2.0)
	_limit("150001")
	_tracker.advance(2.0)
	_limit("unlimited")
	_tracker.advance(2.0)
	_synth.stop_wav()
	quit()


func _limit(bytes: String) -> void:
	OS.execute("prlimit", ["--pid", str(OS.get_process_id()), "--fsize=%s:unlimited" % bytes])
"""

# The limit falls into the middle of a row, and is lifted later: a disk that is full for a while.
SESSION_SCRIPT = """extends SceneTree

const EACH := 15

var _session := StudySession.new()
var _signals := 0


func _initialize() -> void:
	var protocol := StudyProtocol.new()
	protocol.gestures = ["tap"]
	protocol.practice_trials = 0
	_session.start(OS.get_cmdline_user_args()[0], "ann", protocol, "person")
	_session.trouble.connect(func(_message: String) -> void: _signals += 1)
	_make("before")
	var path := _session.folder.path_join("trials.csv")
	_limit(str(FileAccess.get_file_as_bytes(path).size() + 250))
	_make("while full")
	var text := FileAccess.get_file_as_string(path)
	print("while full: whole rows ", text.ends_with("\\n"), ", at least those before ", text.count("\\n") > EACH)
	_limit("unlimited")
	_make("after")
	print("signals ", _signals)
	quit()


func _make(when: String) -> void:
	var written := 0
	for i in EACH:
		var trial: int = _session.next_trial()["trial"]
		_session.add_event(0.1 * trial, "target_shown", "tap", trial)
		_session.add_file(_session.trial_path(trial, "motion"), "t\\n%d\\n" % trial)
		if _session.finish_trial(trial, {recognised = "tap"}) == OK:
			written += 1
	print(when, ": written at once ", written)


func _limit(bytes: String) -> void:
	OS.execute("prlimit", ["--pid", str(OS.get_process_id()), "--fsize=%s:unlimited" % bytes])
"""


def outcomes() -> Iterator[Outcome]:
    with tempfile.TemporaryDirectory(prefix="steadyhand_full_disk") as folder:
        yield from files(Path(folder))
        yield from picture(Path(folder))
        yield from evaluation(Path(folder))
        yield from study(Path(folder))
        yield from session(Path(folder))
        yield from vibration(Path(folder))


def godot(script: Path | str, *arguments: Path | str) -> list:
    return [os.environ["GODOT"], "--headless", "--path", ROOT / "demo_project", "--script", script, "--", *arguments]


def files(folder: Path) -> Iterator[Outcome]:
    """Files of a program with the add-on and of a study."""
    script = folder / "write.gd"
    script.write_text(SCRIPT)
    for name in ("tap.gesture", "ann.json"):
        (folder / name).write_text("{}")
    _, output = run([*LIMITED, *godot(script, folder)], kill_s=60)
    for what, name in (("model", "tap.gesture"), ("positions", "ann.json")):
        good = f"{what} refused: true" in output and (folder / name).read_text() == "{}"
        yield Outcome.of(f"command/full disk: {name} stays as it was", good, output)
        yield Outcome.of(f"command/full disk: no incomplete {name}", not (folder / f"{name}.part").exists(), output)
    for name in ("frames.csv", "short.wav", "a.log.csv"):
        written = (folder / name).read_bytes()
        # A cut track has whole rows.
        full = 8000 < len(written) <= 8192 and written.endswith(b"\n") if name == "frames.csv" else len(written) == 8192
        good = full and output.count(f"{folder / name}: ") == 1
        yield Outcome.of(f"command/full disk: one message that {name} is cut", good, output)
    yield Outcome.of(
        "command/full disk: short.wav has the right length in its header", is_whole_wav(folder / "short.wav"), output
    )


def is_whole_wav(path: Path) -> bool:
    """Whether the header (RIFF WAVE, 44 bytes, 16-bit mono) counts the whole samples that are there."""
    written = path.read_bytes()
    return int.from_bytes(written[40:44], "little") == (len(written) - 44) // 2 * 2 > 0


def vibration(folder: Path) -> Iterator[Outcome]:
    """A WAV file on a disk that is full for a while."""
    if shutil.which("prlimit") is None:
        yield Outcome("command/full disk: vibration, prlimit is not installed", skipped=1)
        return
    script, wav = folder / "vibrate.gd", folder / "v.wav"
    script.write_text(VIBRATION_SCRIPT)
    _, output = run(["bash", "-c", "trap '' XFSZ; exec \"$@\"", "limited", *godot(script, wav)], kill_s=60)
    good = is_whole_wav(wav) and wav.stat().st_size <= 150_001
    yield Outcome.of("command/full disk: a vibration has a right header and ends where the disk was full", good, output)
    yield Outcome.of(
        "command/full disk: one message about the vibration",
        output.count("the vibration cannot be written") == 1,
        output,
    )


def picture(folder: Path) -> Iterator[Outcome]:
    """The picture of a model that exists."""
    out, recordings = folder / "tap.png", folder / "tap.recordings.csv"
    out.write_text("as it was")
    recordings.write_text("a,1,0.99,0,0.5,1\n")
    draw = [sys.executable, "-m", "plots.model", ROOT / "models/tap.gesture", recordings, "--out", out]
    status, output = run([*LIMITED, *draw], PYTHONPATH=str(ROOT / "tools"))
    expected = f"{out}: the picture cannot be written: File too large\n"
    good = status == 1 and output == expected and out.read_text() == "as it was"
    yield Outcome.of("command/full disk: one line for a missing picture", good, output)
    yield Outcome.of("command/full disk: no incomplete file is left", not (folder / "tap.png.part").exists(), output)


def evaluation(folder: Path) -> Iterator[Outcome]:
    synthetic = ["--out", folder / "set", "--gestures", "tap", "--subjects", "1", "--trials", "1"]
    status, output = run(godot("res://tools/synthesise.gd", *synthetic))
    if status == 0:
        out = folder / "evaluation"
        command = godot("res://tools/evaluate.gd", "--trials", folder / "set", "--out", out)
        status, output = run([*LIMITED, *command])
        left = sorted(path.name for path in out.iterdir())
    good = status == 2 and ".curves.csv: is the disk full?" in output and not {"results.csv", "summary.json"} & {*left}
    yield Outcome.of("command/full disk: an evaluation fails, and leaves no table", good, f"{status}, {left}\n{output}")


def study(folder: Path) -> Iterator[Outcome]:
    """A study with so many participants that its table exceeds the limit."""
    logs, out = folder / "logs", folder / "means"
    for place in (logs, out):
        place.mkdir()
    header = "trial,gesture,position,condition,start_s,end_s,participant,amplitude_m,width_m,end_value_m,gesture_end_s"
    rows = [f"tap_{i},tap,stable,measured,{i},{i + 1},somebody {i},0.15,,0.15,{i + 1}" for i in range(300)]
    (logs / "trials.csv").write_text("\n".join([header, *rows, ""]))
    table = out / "throughput.csv"
    table.write_text("as it was")
    status, output = run([*LIMITED, "./steadyhand", "study", logs, "--out", out])
    good = status == 2 and f"cannot write to {out}: File too large" in output and table.read_text() == "as it was"
    yield Outcome.of("command/full disk: a study's table stays as it was", good, f"{status}\n{output}")
    yield Outcome.of(
        "command/full disk: no incomplete file is left", not (out / "throughput.csv.part").exists(), output
    )


def session(folder: Path) -> Iterator[Outcome]:
    """A study's session on a disk that is full for a while."""
    if shutil.which("prlimit") is None:
        yield Outcome("command/full disk: a session, prlimit is not installed", skipped=1)
        return
    script = folder / "session.gd"
    script.write_text(SESSION_SCRIPT)
    command = ["bash", "-c", "trap '' XFSZ; exec \"$@\"", "limited", *godot(script, folder / "sessions")]
    _, output = run(command, kill_s=60)
    good = "while full: whole rows true, at least those before true" in output and "after: written at once 15" in output
    yield Outcome.of("command/full disk: a session has whole rows while the disk is full", good, output)
    good = output.count("cannot be written. Is the disk full") == 1 and "signals 2" in output
    yield Outcome.of("command/full disk: a session reports the full disk once, and its end", good, output)
    files = folder / "sessions/sub-ann/ses-01"
    for name, column in (("trials.csv", "trial"), ("events.csv", "trial")):
        with (files / name).open(newline="") as file:
            numbers = [row[column] for row in csv.DictReader(file)]
        good = numbers == [str(number) for number in range(1, 46)]
        yield Outcome.of(f"command/full disk: every row of {name} is there once", good, f"{numbers}\n{output}")
    good = len(list(files.glob("trial_*.motion.csv"))) == 45 and not list(files.glob("*.part"))
    yield Outcome.of("command/full disk: every file of a trial is there", good, output)
