"""Shows the progress of a long run: one moving line on a terminal, else a line for every 10 %."""

import sys

BAR = 30


class Progress:
    def __init__(self, label: str) -> None:
        self.label = label
        self.shown = 0

    def show(self, done: float) -> None:
        """done: 0..1."""
        moves = sys.stdout.isatty()
        step = int(done * (100 if moves else 10) + 1e-9)
        if step <= self.shown:
            return
        self.shown = step
        if not moves:
            print(f"  {self.label}: {10 * step} %", flush=True)
            return
        filled = BAR * step // 100
        end = "\n" if step == 100 else ""
        print(f"\r  {self.label}  {'#' * filled}{'-' * (BAR - filled)} {step:3} %", end=end, flush=True)
