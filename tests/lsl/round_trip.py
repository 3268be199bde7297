"""round_trip.py GODOT: what LslOutlet sends is received by pylsl, the layer's own Python package."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
WAIT_S = 20
WANTED = 50
# Nothing outside this machine hears of it.
CONFIGURATION = "[multicast]\nResolveScope = machine\n[lab]\nKnownPeers = {127.0.0.1}\n[log]\nlevel = -2\n"


def main(godot: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        configuration = Path(folder) / "lsl_api.cfg"
        configuration.write_text(CONFIGURATION)
        os.environ["LSLAPICFG"] = str(configuration)
        import pylsl  # reads the environment

        library = Path(pylsl.__file__).parent / "lib/liblsl.so"
        command = [godot, "--headless", "--path", HERE.parents[1] / "demo_project", "--script", HERE / "sender.gd"]
        sender = subprocess.Popen(command, env={**os.environ, "STEADYHAND_LSL": str(library)})
        try:
            check_frames(received(pylsl, "SteadyHand"))
            check_events(received(pylsl, "SteadyHand events"))
        finally:
            sender.kill()
            sender.wait()


def received(pylsl, name: str):
    """The stream's description, WANTED samples and their times."""
    found = pylsl.resolve_byprop("name", name, timeout=WAIT_S)
    assert found, f"no stream {name!r} in {WAIT_S} s"
    inlet = pylsl.StreamInlet(found[0])
    got = [inlet.pull_sample(timeout=WAIT_S) for _ in range(WANTED)]
    return inlet.info(WAIT_S), [sample for sample, _ in got], [time_s for _, time_s in got]


def check_frames(stream) -> None:
    info, samples, times_s = stream
    assert info.type() == "MoCap" and info.nominal_srate() == 0.0
    labels = info.get_channel_labels()
    assert labels[-1] == "confidence" and len(labels) == 22, labels
    frames = np.array(samples)
    index = labels.index("index_x")
    assert np.allclose(np.diff(frames[:, index]), 0.001, atol=1e-6), "a frame is missing or changed"
    assert np.all(frames[:, [index + 1, index + 2, 21]] == [0.5, -0.25, 0.75])
    assert np.all(np.isnan(np.delete(frames, [index, index + 1, index + 2, 21], axis=1))), "untracked joints"
    assert np.all(np.diff(times_s) > 0), times_s


def check_events(stream) -> None:
    info, samples, times_s = stream
    assert info.type() == "Markers"
    first = int(samples[0][0].split()[1])
    assert [one[0] for one in samples] == [f"höher {first + i}" for i in range(WANTED)], samples
    assert np.all(np.diff(times_s) > 0), times_s


main(sys.argv[1])
