#!/usr/bin/env python3
"""Checks the stub of the Leap service with a WebSocket client of its own. Prints one line a check; exit status 1 where
one fails.
"""

import base64
import hashlib
import itertools
import json
import os
import socket
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from make_leap_messages import messages, synthetic_drag

HERE = Path(__file__).parent
failures = 0


def check(name: str, is_right: bool, seen: object = "") -> None:
    global failures
    failures += 0 if is_right else 1
    print(f"{'ok  ' if is_right else 'FAIL'} {name} {'' if is_right else seen}")


class Client:
    """Connects, sends the greeting, and reads messages; what is wrong with the protocol raises."""

    def __init__(self, port: int, path: str = "/v6.json", greets: bool = True) -> None:
        self.sock = socket.create_connection(("127.0.0.1", port), timeout=10.0)
        self.buffer = b""
        self.close_code: int | None = None
        self.pings = self.fragments = 0
        key = base64.b64encode(os.urandom(16))
        request = f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        self.sock.sendall(request.encode() + b"Sec-WebSocket-Key: " + key + b"\r\nSec-WebSocket-Version: 13\r\n\r\n")
        while b"\r\n\r\n" not in self.buffer:
            self.fill()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        self.status = int(head.split()[1])
        accept = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())
        assert self.status != 101 or b"Sec-WebSocket-Accept: " + accept in head
        if greets and self.status == 101:
            for text in (b'{"background":true}', b'{"optimizeHMD":false}', b'{"focused":true}'):
                self.send(1, text)

    def fill(self) -> None:
        part = self.sock.recv(1 << 20)
        if not part:
            raise EOFError
        self.buffer += part

    def take(self, size: int) -> bytes:
        while len(self.buffer) < size:
            self.fill()
        data, self.buffer = self.buffer[:size], self.buffer[size:]
        return data

    def send(self, opcode: int, data: bytes) -> None:
        mask = os.urandom(4)
        masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(data))
        self.sock.sendall(bytes([0x80 | opcode, 0x80 | len(data)]) + mask + masked)

    def read(self, is_silent_for_s: float = 0.7) -> Iterator[tuple[float, int, bytes]]:
        """Messages as (arrival s, opcode, bytes), until the connection ends or is silent for so long."""
        self.sock.settimeout(is_silent_for_s)
        opcode, whole = 0, b""
        try:
            while True:
                first, second = self.take(2)
                assert not second & 0x80 and not first & 0x70
                size = second
                if size == 126:
                    (size,) = struct.unpack(">H", self.take(2))
                elif size == 127:
                    (size,) = struct.unpack(">Q", self.take(8))
                data = self.take(size)
                kind = first & 0x0F
                if kind == 8:
                    (self.close_code,) = struct.unpack(">H", data)
                    self.send(8, data)
                    return
                if kind == 9:
                    self.pings += 1
                    continue
                assert (kind == 0) == (opcode != 0)
                self.fragments += 1
                opcode, whole = opcode or kind, whole + data
                if first & 0x80:
                    yield time.monotonic(), opcode, whole
                    opcode, whole = 0, b""
        except (EOFError, TimeoutError, ConnectionError):
            return


class Stub:
    def __init__(self, folder: Path, lines: list[str], scenario: str, *options: str) -> None:
        (folder / "messages.jsonl").write_text("".join(f"{line}\n" for line in lines))
        self.log_path = folder / "log"
        files = ["--messages", str(folder / "messages.jsonl"), "--log", str(self.log_path)]
        command = [sys.executable, str(HERE / "leap_stub.py"), "--scenario", scenario, *files, *options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.port = int(self.process.stdout.readline())

    def __enter__(self) -> "Stub":
        return self

    def __exit__(self, *_: object) -> None:
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def log(self) -> list[dict]:
        return [json.loads(line) for line in self.log_path.read_text().splitlines()]


def frames_of(received: list[tuple[float, int, bytes]]) -> list[dict]:
    """Those that are JSON objects with hands."""
    frames = []
    for _, opcode, data in received:
        try:
            frame = json.loads(data) if opcode == 1 else None
        except (ValueError, RecursionError):
            continue
        if isinstance(frame, dict) and isinstance(frame.get("hands"), list):
            frames.append(frame)
    return frames


def check_play(folder: Path, lines: list[str]) -> None:
    with Stub(folder, lines, "play") as stub:
        client = Client(stub.port)
        received = list(client.read())
        texts = [data.decode() for _, _, data in received]
        check("play: version, device, then each line byte for byte", texts[2:] == lines, len(texts))
        check("play: version 6", json.loads(texts[0])["version"] == 6, texts[0])
        check("play: device event", json.loads(texts[1])["event"]["state"]["streaming"] is True, texts[1])
        took_s = received[-1][0] - received[2][0]
        check("play: takes as long as the timestamps say", abs(took_s - 3.0) < 0.1, took_s)
        client.send(8, struct.pack(">H", 1000))
        list(client.read())
        check("play: the close is answered", client.close_code == 1000, client.close_code)
        said = [(entry["what"], entry["text"]) for entry in stub.log() if entry["what"] != "end"]
        greeting = [("text", text) for text in ('{"background":true}', '{"optimizeHMD":false}', '{"focused":true}')]
        check("play: the log has what was sent", said == [("open", "/v6.json"), *greeting, ("close", "1000")], said)
    with Stub(folder, lines, "play", "--speed", "0") as stub:
        silent = list(Client(stub.port, greets=False).read())
        check("play: no frames for a client that does not ask", len(silent) == 2, len(silent))
    with Stub(folder, lines, "play", "--speed", "0", "--dialect", "bridge") as stub:
        check("play: the bridge sends to all", len(list(Client(stub.port, greets=False).read())) == len(lines) + 2)
        check("play: the bridge refuses other paths", Client(stub.port, "/v7.json").status == 404)


def check_deliveries(folder: Path, lines: list[str]) -> None:
    with Stub(folder, lines, "bursts") as stub:
        received = list(Client(stub.port).read())[2:]
        steps_s = [b[0] - a[0] for a, b in itertools.pairwise(received)]
        check("bursts: every line, three at a time", len(received) == len(lines), len(received))
        check("bursts: a third of the steps are long", abs(sum(s > 0.01 for s in steps_s) - len(lines) / 3) < 12)
    with Stub(folder, lines, "split", "--speed", "0") as stub:
        client = Client(stub.port)
        texts = [data.decode() for _, _, data in client.read()]
        check("split: every line, whole", texts[2:] == lines, len(texts))
        check("split: in fragments, with pings", client.fragments > 1.5 * len(lines) and client.pings > 5)
    with Stub(folder, lines, "invalid", "--speed", "0") as stub:
        received = list(Client(stub.port).read(2.0))
        frames = [frame for frame in frames_of(received) if isinstance(frame["id"], int)]
        check("invalid: every line among what is none", len(frames) == len(lines), len(frames))
        check("invalid: 10 MB, binary, undefined", max(len(data) for _, _, data in received) == 10_000_000)
        check("invalid: binary", any(opcode == 2 for _, opcode, _ in received))
        check("invalid: undefined", any(data == b"undefined" for _, _, data in received))


def check_connections(folder: Path, lines: list[str]) -> None:
    with Stub(folder, lines, "drop") as stub:
        first = list(Client(stub.port).read())
        check("drop: 50 frames, then the end", len(first) == 52, len(first))
        time.sleep(0.2)
        second = frames_of(list(Client(stub.port).read()))
        gap = second[0]["id"] - json.loads(first[-1][2])["id"]
        check("drop: goes on where the time is", 10 < gap < 120, gap)
        check("drop: to the end", second[-1]["id"] == json.loads(lines[-1])["id"])
    with Stub(folder, lines, "old", "--speed", "0") as stub:
        client = Client(stub.port)
        check("old: version 6 is refused with 1001", list(client.read()) == [] and client.close_code == 1001)
        received = list(Client(stub.port, "/v5.json").read())
        check("old: version 5 plays", len(received) == len(lines) + 2 and json.loads(received[0][2])["version"] == 5)


def check_hands(folder: Path, lines: list[str]) -> None:
    with Stub(folder, lines, "stall", "--speed", "0") as stub:
        stamps = [frame["timestamp"] for frame in frames_of(list(Client(stub.port).read()))]
        longest_s = max(b - a for a, b in itertools.pairwise(stamps)) * 1e-6
        check("stall: 1.5 s without frames", abs(longest_s - 1.5) < 0.02, longest_s)
    with Stub(folder, lines, "lost", "--speed", "0") as stub:
        frames = frames_of(list(Client(stub.port).read()))
        ids = [frame["hands"][0]["id"] if frame["hands"] else 0 for frame in frames]
        check("lost: no hand for 0.6 s", abs(ids.count(0) / 110.0 - 0.6) < 0.02, ids.count(0))
        check("lost: another id afterwards", list(dict.fromkeys(ids)) == [7, 0, 8], list(dict.fromkeys(ids)))
    with Stub(folder, lines, "swap", "--speed", "0") as stub:
        frames = frames_of(list(Client(stub.port).read()))
        single = [i for i, frame in enumerate(frames) if len(frame["hands"]) == 1]
        check("swap: six frames with one hand, the others with two", len(single) == 6, single)
        left = next(hand for hand in frames[single[0] - 1]["hands"] if hand["type"] == "left")
        right = frames[single[0]]["hands"][0]
        apart_mm = max(abs(a - b) for a, b in zip(left["palmPosition"], right["palmPosition"], strict=True))
        check("swap: the right hand is where the left was", right["type"] == "right" and apart_mm < 10.0, apart_mm)


def main() -> None:
    lines = list(messages(synthetic_drag()))
    with tempfile.TemporaryDirectory() as folder:
        for part in (check_play, check_deliveries, check_connections, check_hands):
            part(Path(folder), lines)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
