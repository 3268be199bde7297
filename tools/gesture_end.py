"""Where a gesture ends, for tools that look at curves."""

# Of the amplitude; END_LEVEL of extension/core/gesture/task.h, which the lint suite compares it with.
END_LEVEL = 0.95
