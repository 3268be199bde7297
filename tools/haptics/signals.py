"""Spectra, envelopes, onsets and steps of sampled vibration."""

import wave
from pathlib import Path

import numpy as np
from scipy import signal


def read_wav(path: Path) -> np.ndarray:
    """Samples of a mono 16-bit file, -1..1."""
    with wave.open(str(path)) as file:
        return np.frombuffer(file.readframes(file.getnframes()), "<i2") / 32767.0


def read_floats(path: Path) -> np.ndarray:
    """Left and right, frames x 2."""
    return np.fromfile(path, "<f4").reshape(-1, 2).astype(float)


def peak_frequency(samples: np.ndarray, rate_hz: float) -> float:
    """Frequency of the spectrum's highest line (Hz), interpolated in a zero-padded spectrum."""
    padded = 1 << (len(samples) - 1).bit_length() + 3
    power = np.abs(np.fft.rfft(samples * signal.windows.hann(len(samples), sym=False), padded)) ** 2
    top = int(np.clip(np.argmax(power), 1, len(power) - 2))
    left, middle, right = np.log(power[top - 1 : top + 2])
    return (top + 0.5 * (left - right) / (left - 2.0 * middle + right)) * rate_hz / padded


def amplitude_at(samples: np.ndarray, rate_hz: float, frequency_hz: float) -> float:
    """Amplitude of the sine at frequency_hz, by least squares."""
    phase = 2.0 * np.pi * frequency_hz * np.arange(len(samples)) / rate_hz
    both = np.linalg.lstsq(np.column_stack([np.sin(phase), np.cos(phase)]), samples, rcond=None)[0]
    return float(np.hypot(*both))


def envelope(samples: np.ndarray, rate_hz: float, carrier_hz: float) -> np.ndarray:
    """Amplitude of a carrier by its analytic signal (Hilbert). No delay: filtered both ways, +-60 Hz."""
    band = signal.butter(2, [carrier_hz - 60.0, carrier_hz + 60.0], "bandpass", fs=rate_hz, output="sos")
    return np.abs(signal.hilbert(signal.sosfiltfilt(band, samples)))


def onset(samples: np.ndarray) -> int | None:
    """Number of the first sample that is not silent."""
    heard = np.flatnonzero(np.abs(samples) > 1e-3)
    return int(heard[0]) if len(heard) else None


def step_share(samples: np.ndarray, rate_hz: float, frequency_hz: float) -> float:
    """The largest step between two samples, relative to the largest step of a sine with the samples' peak."""
    bound = 2.0 * np.sin(np.pi * frequency_hz / rate_hz) * np.max(np.abs(samples))
    return float(np.max(np.abs(np.diff(samples))) / bound)


def delay_and_error(
    reference: np.ndarray, curve: np.ndarray, rate_hz: float, most_s: float
) -> tuple[float, float, float]:
    """Delay of the curve (s, positive: late), and its RMS difference at that delay and without a delay."""
    most = round(most_s * rate_hz)
    middle = reference[most:-most]
    errors = [
        np.sqrt(np.mean((curve[most + lag : len(curve) - most + lag] - middle) ** 2)) for lag in range(-most, most + 1)
    ]
    best = int(np.argmin(errors))
    return (best - most) / rate_hz, float(errors[best]), float(errors[most])
