"""The level at which a gesture ends, for tools that evaluate curves."""

# A fraction of the amplitude. The lint suite checks that it equals END_LEVEL of extension/core/gesture/task.h.
END_LEVEL = 0.95
