"""Detects frames that a frozen tracker repeats while the hand moves: they are no measurements."""

HELD_S = 0.03  # two frames of a slow camera may be equal for this time
MOVING = 0.1  # amplitudes a second


class FrozenFrames:
    def __init__(self) -> None:
        self.value = None
        self.changed_s = 0.0
        self.speed = 0.0

    def is_frozen(self, t_s: float, value: float) -> bool:
        """Whether this frame has had the same value for HELD_S, to the last bit, since a hand that moved."""
        if value == self.value:
            return self.speed > MOVING and t_s - self.changed_s > HELD_S
        if self.value is not None:
            self.speed = abs(value - self.value) / (t_s - self.changed_s)
        self.value, self.changed_s = value, t_s
        return False
