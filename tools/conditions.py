"""Names of the compared conditions for people. Files have the keys: docs/formats.md."""

TITLES = {
    "measured": "measured",
    "average": "moving average",
    "one_euro": "One Euro filter",
    "kalman": "Kalman filter",
    "synthesised": "synthesised",
}
