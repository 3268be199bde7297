"""What the stub of a Leap service sends, and when: each scenario turns messages into steps.

A message is (time in s on the service's clock, bytes of a line). A step is (time in s, action, bytes):

    text    one text message            binary  one binary message
    split   a text message in fragments, its bytes in TCP writes that end anywhere
    drop    the TCP connection ends without a close frame
"""

import json
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

Message = tuple[float, bytes]
Step = tuple[float, str, bytes]

DROP_AFTER = 50  # frames
STALL_S = 1.5
LOST_S = 0.6
SWAPPED_FRAMES = 6
BIG_BYTES = 10_000_000
POSITIONS = ("tipPosition", "btipPosition", "dipPosition", "pipPosition", "mcpPosition", "carpPosition")
HAND_POSITIONS = ("palmPosition", "wrist", "elbow")
APART_MM = 300.0  # between the palms of the hands, where the messages have one hand only


def read_messages(path: Path) -> list[Message]:
    """One for each line; times from the first `timestamp`."""
    lines = [line for line in path.read_bytes().split(b"\n") if line]
    stamps = [json.loads(line)["timestamp"] * 1e-6 for line in lines]
    return [(stamp - stamps[0], line) for stamp, line in zip(stamps, lines, strict=True)]


def play(messages: list[Message]) -> Iterator[Step]:
    for t_s, line in messages:
        yield t_s, "text", line


def bursts(messages: list[Message]) -> Iterator[Step]:
    """Three at a time, when the third is due."""
    for i in range(0, len(messages), 3):
        group = messages[i : i + 3]
        for _, line in group:
            yield group[-1][0], "text", line


def split(messages: list[Message]) -> Iterator[Step]:
    for t_s, line in messages:
        yield t_s, "split", line


def invalid(messages: list[Message]) -> Iterator[Step]:
    """Before every fifth frame something that is none, once 10 MB of it."""
    faults = [
        ("text", b"undefined"),
        ("text", messages[0][1][: len(messages[0][1]) // 2]),
        ("binary", bytes(range(256))),
        ("text", b'{"id":"1","timestamp":null,"hands":{}}'),
        ("text", b"[" * 10_000),
        ("text", b""),
    ]
    big_at = len(messages) // 2
    for i, (t_s, line) in enumerate(messages):
        if i == big_at:
            yield t_s, "text", b'{"a":"' + b"x" * (BIG_BYTES - 8) + b'"}'
        elif i % 5 == 4:
            yield (t_s, *faults[i // 5 % len(faults)])
        yield t_s, "text", line


def drop(messages: list[Message]) -> Iterator[Step]:
    """Ends the connection once. Frames that are due before the client is back are lost."""
    for i, (t_s, line) in enumerate(messages):
        if i == DROP_AFTER:
            yield t_s, "drop", b""
        yield t_s, "text", line


def stall(messages: list[Message]) -> Iterator[Step]:
    """The frames of 1.5 s in the middle are not sent."""
    middle_s = messages[-1][0] / 2.0
    for t_s, line in messages:
        if abs(t_s - middle_s) >= STALL_S / 2.0:
            yield t_s, "text", line


def changed(line: bytes, change: Callable[[dict], None]) -> bytes:
    frame = json.loads(line)
    change(frame)
    return json.dumps(frame, separators=(",", ":")).encode()


def with_next_id(frame: dict) -> None:
    for hand in frame["hands"]:
        hand["id"] += 1
    for pointable in frame["pointables"]:
        pointable["handId"] += 1
        pointable["id"] += 10


def without_hands(frame: dict) -> None:
    frame["hands"] = []
    frame["pointables"] = []


def lost(messages: list[Message]) -> Iterator[Step]:
    """No hand for 0.6 s in the middle, then the same one under another id."""
    middle_s = messages[-1][0] / 2.0
    for t_s, line in messages:
        if t_s < middle_s - LOST_S / 2.0:
            yield t_s, "text", line
        else:
            is_back = t_s >= middle_s + LOST_S / 2.0
            yield t_s, "text", changed(line, with_next_id if is_back else without_hands)


def positions_of(frame: dict, hand: dict) -> Iterator[list[float]]:
    """Each position of the hand, to be changed in place."""
    yield from (hand[name] for name in HAND_POSITIONS if name in hand)
    for pointable in frame["pointables"]:
        if pointable["handId"] == hand["id"]:
            yield from (pointable[name] for name in POSITIONS if name in pointable)


def hand_of_side(frame: dict, side: str) -> dict | None:
    return next((hand for hand in frame["hands"] if hand["type"] == side), None)


def add_left_hand(frame: dict) -> None:
    """A copy of the right hand to its left; its fingers are as in a mirror."""
    right = hand_of_side(frame, "right")
    if right is None or hand_of_side(frame, "left") is not None:
        return
    left = json.loads(json.dumps(right)) | {"id": right["id"] + 100, "type": "left"}
    of_right = [pointable for pointable in frame["pointables"] if pointable["handId"] == right["id"]]
    copies = json.loads(json.dumps(of_right))
    for pointable in copies:
        pointable["handId"] = left["id"]
        pointable["id"] = left["id"] * 10 + pointable["type"]
        pointable.pop("bases", None)
    frame["hands"].append(left)
    frame["pointables"] += copies
    middle_mm = right["palmPosition"][0] - APART_MM / 2.0
    for position in positions_of(frame, left):
        position[0] = 2.0 * middle_mm - position[0]


def right_at_left(frame: dict) -> None:
    right, left = hand_of_side(frame, "right"), hand_of_side(frame, "left")
    if right is None or left is None:
        return
    shift = [there - here for there, here in zip(left["palmPosition"], right["palmPosition"], strict=True)]
    for position in positions_of(frame, right):
        position[:] = [here + by for here, by in zip(position, shift, strict=True)]
    frame["hands"] = [right]
    frame["pointables"] = [pointable for pointable in frame["pointables"] if pointable["handId"] == right["id"]]


def swap(messages: list[Message]) -> Iterator[Step]:
    """Two hands; in six frames from the middle the right hand is where the left was, which is gone.

    A left hand is added to messages that have none.
    """

    def change(frame: dict, is_swapped: bool) -> None:
        add_left_hand(frame)
        if is_swapped:
            right_at_left(frame)

    first = len(messages) // 2
    for i, (t_s, line) in enumerate(messages):
        is_swapped = first <= i < first + SWAPPED_FRAMES
        yield t_s, "text", changed(line, lambda frame, is_swapped=is_swapped: change(frame, is_swapped))


SCENARIOS: dict[str, Callable[[list[Message]], Iterable[Step]]] = {
    "play": play,
    "bursts": bursts,
    "split": split,
    "invalid": invalid,
    "drop": drop,
    "stall": stall,
    "old": play,  # the server refuses newer versions
    "lost": lost,
    "swap": swap,
}
