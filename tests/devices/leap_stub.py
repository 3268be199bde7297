#!/usr/bin/env python3
"""A stand-in for the Leap Motion service: a WebSocket server on 127.0.0.1 that plays a scenario.

    leap_stub.py --scenario play --messages drag.jsonl [--port 0] [--speed 1] [--dialect orion] [--log FILE]

The first line of standard output is the port. Messages are JSON lines, as of make_leap_messages.py, each sent byte for
byte at the pace of its `timestamp`. Time begins with the first client that is due frames, and goes on without one: what
is due meanwhile is lost. The original service (orion) sends frames to clients that ask for background or focus, the
bridge to all. After the last frame the connection stays open. The stub ends after --seconds, or by a signal.

The log has one JSON object a line: {"t": s, "client": 1, "what": "open" | "text" | "close" | "end", "text": "..."};
`text` is the path of the URL, the message, the close code, or the bytes that were sent.
"""

import argparse
import base64
import contextlib
import hashlib
import itertools
import json
import random
import re
import socket
import struct
import sys
import threading
import time
from pathlib import Path

from leap_scenarios import SCENARIOS, Step, read_messages

MAGIC = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"  # RFC 6455 1.3
CONTINUATION, TEXT, BINARY, CLOSE, PING, PONG = 0x0, 0x1, 0x2, 0x8, 0x9, 0xA
GOING_AWAY = 1001
NEWEST_OLD_VERSION = 5
LARGEST_FROM_CLIENT = 125  # bytes: what clients send is shorter, and the bridge takes 31


class Ended(Exception):
    """The connection is over."""


class Log:
    def __init__(self, path: Path | None) -> None:
        self.file = path.open("w", encoding="utf-8") if path else None
        self.lock = threading.Lock()
        self.start_s = time.monotonic()

    def write(self, client: int, what: str, text: str) -> None:
        if self.file:
            with self.lock:
                entry = {"t": round(time.monotonic() - self.start_s, 6), "client": client, "what": what, "text": text}
                self.file.write(json.dumps(entry) + "\n")
                self.file.flush()


class Player:
    """The one playback that all clients see. Speed 0: every message is due at once."""

    def __init__(self, steps: list[Step], speed: float) -> None:
        self.steps = steps
        self.speed = speed
        self.lock = threading.Lock()
        self.start_s: float | None = None
        self.is_dropped = False

    def due_s(self, step: Step) -> float:
        return step[0] / self.speed if self.speed > 0.0 else 0.0

    def begin(self) -> float:
        with self.lock:
            if self.start_s is None:
                self.start_s = time.monotonic()
            return self.start_s

    def first_to_send(self) -> int:
        """The first step that is not over; with no pace, what follows the drop."""
        if self.is_dropped and self.speed <= 0.0:
            return next(i for i, step in enumerate(self.steps) if step[1] == "drop") + 1
        now_s = time.monotonic() - self.begin()
        return next((i for i, step in enumerate(self.steps) if self.due_s(step) >= now_s - 0.05), len(self.steps))


class Client:
    def __init__(self, sock: socket.socket, number: int, stub: "Stub") -> None:
        self.sock = sock
        self.number = number
        self.stub = stub
        self.lock = threading.Lock()  # of what is sent
        self.wants_frames = threading.Event()
        self.is_over = threading.Event()
        self.random = random.Random(number)
        self.sent = 0  # bytes of messages
        self.has_closed = False

    def run(self) -> None:
        try:
            path = self.shake_hands()
            self.stub.log.write(self.number, "open", path)
            if self.greet(path):
                threading.Thread(target=self.listen, daemon=True).start()
                self.play()
            else:
                self.listen()
        except (Ended, OSError):
            pass
        finally:
            self.is_over.set()
            self.stub.log.write(self.number, "end", str(self.sent))
            with contextlib.suppress(OSError):
                self.sock.shutdown(socket.SHUT_RDWR)  # close() alone waits for the listening thread
            self.sock.close()

    def shake_hands(self) -> str:
        request = b""
        while b"\r\n\r\n" not in request:
            part = self.sock.recv(4096)
            if not part or len(request) > 65536:
                raise Ended
            request += part
        path = re.match(rb"GET (\S+) HTTP/1\.1\r\n", request)
        key = re.search(rb"\r\nsec-websocket-key:[ \t]*(\S+)[ \t]*\r\n", request, re.IGNORECASE)
        if not path or not key or (self.stub.dialect == "bridge" and path[1] != b"/v6.json"):
            self.sock.sendall(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
            raise Ended
        accept = base64.b64encode(hashlib.sha1(key[1] + MAGIC).digest())
        self.sock.sendall(
            b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Accept: " + accept + b"\r\n\r\n"
        )
        return path[1].decode("ascii", "replace")

    def greet(self, path: str) -> bool:
        """The version message and the device event. False where the version is refused."""
        named = re.fullmatch(r"/v(\d+)\.json", path)
        version = int(named[1]) if named else 1
        if self.stub.scenario == "old" and version > NEWEST_OLD_VERSION:
            self.send(CLOSE, struct.pack(">H", GOING_AWAY))
            self.has_closed = True
            return False
        is_bridge = self.stub.dialect == "bridge"
        about = {"version": version} if is_bridge else {"serviceVersion": "4.1.0+52211", "version": version}
        device = {
            "id": 42 if is_bridge else "LP95597022824",
            "type": "peripheral" if is_bridge else "Peripheral",
            "attached": True,
            "streaming": True,
        }
        event = {"event": {"type": "deviceEvent", "state": device}}
        for message in (about, event):
            self.send(TEXT, json.dumps(message, separators=(",", ":")).encode())
        if is_bridge:
            self.wants_frames.set()
        return True

    def play(self) -> None:
        player = self.stub.player
        while not self.wants_frames.wait(0.05):
            if self.is_over.is_set():
                return
        start_s = player.begin()
        for step in player.steps[player.first_to_send() :]:
            if self.is_over.wait(max(0.0, start_s + player.due_s(step) - time.monotonic())):
                return
            _, action, data = step
            if action == "drop":
                if not player.is_dropped:
                    player.is_dropped = True
                    return
            elif action == "split":
                self.send_split(data)
            else:
                self.send(TEXT if action == "text" else BINARY, data)
        self.is_over.wait()

    def send(self, opcode: int, data: bytes) -> None:
        with self.lock:
            self.sock.sendall(frame(opcode, data))
        self.sent += len(data)

    def send_split(self, data: bytes) -> None:
        """Up to four fragments, a ping before some, in TCP writes that end anywhere.

        Not among them: Godot 4.6 takes a ping's payload there for a part of the message.
        """
        cuts = sorted(self.random.randrange(len(data) + 1) for _ in range(self.random.randrange(4)))
        parts = [data[begin:end] for begin, end in itertools.pairwise([0, *cuts, len(data)])]
        stream = b""
        if self.random.random() < 0.1:
            stream += frame(PING, b"?")
        for i, part in enumerate(parts):
            stream += frame(CONTINUATION if i else TEXT, part, is_last=i == len(parts) - 1)
        ends = sorted(self.random.randrange(len(stream)) for _ in range(self.random.randrange(6)))
        with self.lock:
            for begin, end in itertools.pairwise([0, *ends, len(stream)]):
                self.sock.sendall(stream[begin:end])
                if self.random.random() < 0.2:
                    time.sleep(0.0005)  # lets the part go as a packet of its own
        self.sent += len(data)

    def listen(self) -> None:
        try:
            while True:
                self.take(*self.receive())
        except (Ended, OSError):
            self.is_over.set()

    def take(self, opcode: int, data: bytes) -> None:
        if opcode == TEXT:
            text = data.decode("utf-8", "replace")
            self.stub.log.write(self.number, "text", text)
            if text in ('{"background":true}', '{"focused":true}'):
                self.wants_frames.set()
        elif opcode == PING:
            self.send(PONG, data)
        elif opcode == CLOSE:
            self.stub.log.write(self.number, "close", str(struct.unpack(">H", data[:2])[0] if len(data) > 1 else 1005))
            if not self.has_closed:
                self.send(CLOSE, data[:2])
            raise Ended

    def receive(self) -> tuple[int, bytes]:
        """One frame. Clients must mask theirs; fragments and long ones are faults here."""
        head = self.read(2)
        size = head[1] & 0x7F
        if not head[0] & 0x80 or not head[1] & 0x80 or size > LARGEST_FROM_CLIENT:
            self.stub.log.write(self.number, "text", f"bad frame {head.hex()}")
            self.send(CLOSE, struct.pack(">H", 1002))
            raise Ended
        mask = self.read(4)
        data = self.read(size)
        return head[0] & 0x0F, bytes(byte ^ mask[i % 4] for i, byte in enumerate(data))

    def read(self, size: int) -> bytes:
        data = b""
        while len(data) < size:
            part = self.sock.recv(size - len(data))
            if not part:
                raise Ended
            data += part
        return data


def frame(opcode: int, data: bytes, is_last: bool = True) -> bytes:
    """A frame as servers send it, without a mask (RFC 6455 5.2)."""
    head = bytes([opcode | (0x80 if is_last else 0)])
    if len(data) < 126:
        return head + bytes([len(data)]) + data
    if len(data) < 65536:
        return head + struct.pack(">BH", 126, len(data)) + data
    return head + struct.pack(">BQ", 127, len(data)) + data


class Stub:
    def __init__(self, scenario: str, messages: Path, speed: float, dialect: str, log: Path | None) -> None:
        self.scenario = scenario
        self.dialect = dialect
        self.log = Log(log)
        self.player = Player(list(SCENARIOS[scenario](read_messages(messages))), speed)

    def serve(self, port: int, seconds: float) -> None:
        listener = socket.create_server(("127.0.0.1", port))
        print(listener.getsockname()[1], flush=True)
        end_s = time.monotonic() + seconds
        for number in itertools.count(1):
            listener.settimeout(max(0.001, end_s - time.monotonic()))
            try:
                sock, _ = listener.accept()
            except TimeoutError:
                return
            sock.settimeout(None)
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            threading.Thread(target=Client(sock, number, self).run, daemon=True).start()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenario", choices=SCENARIOS, default="play")
    parser.add_argument("--messages", type=Path, required=True, help="JSON lines, one frame each")
    parser.add_argument("--port", type=int, default=0, help="0: any that is free")
    parser.add_argument("--speed", type=float, default=1.0, help="2: twice as fast; 0: without waiting")
    parser.add_argument("--dialect", choices=("orion", "bridge"), default="orion")
    parser.add_argument("--log", type=Path, help="what clients send")
    parser.add_argument("--seconds", type=float, default=120.0, help="after that the stub ends")
    chosen = parser.parse_args()
    try:
        Stub(chosen.scenario, chosen.messages, chosen.speed, chosen.dialect, chosen.log).serve(
            chosen.port, chosen.seconds
        )
    except KeyboardInterrupt:
        sys.exit(0)


if __name__ == "__main__":
    main()
