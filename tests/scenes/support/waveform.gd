extends RefCounted
## Measures of a sampled vibration.


## Amplitude of the component at `frequency_hz`, by Goertzel's recursion (1958, DOI
## 10.2307/2310304). Exact where the samples hold whole periods.
static func amplitude_at(samples: PackedFloat32Array, rate_hz: float, frequency_hz: float) -> float:
	var step := TAU * frequency_hz / rate_hz
	var factor := 2.0 * cos(step)
	var last := 0.0
	var before := 0.0
	for sample in samples:
		var next := sample + factor * last - before
		before = last
		last = next
	var power := last * last + before * before - factor * last * before
	return 2.0 * sqrt(maxf(power, 0.0)) / samples.size()


static func peak(samples: PackedFloat32Array) -> float:
	var highest := 0.0
	for sample in samples:
		highest = maxf(highest, absf(sample))
	return highest


## Greatest step from a sample to the next.
static func greatest_step(samples: PackedFloat32Array) -> float:
	var greatest := 0.0
	for i in range(1, samples.size()):
		greatest = maxf(greatest, absf(samples[i] - samples[i - 1]))
	return greatest


## The channel of a mono 16-bit PCM file. Empty: another format.
static func read_wav(path: String, expected_rate_hz: int) -> PackedFloat32Array:
	var samples := PackedFloat32Array()
	var bytes := FileAccess.get_file_as_bytes(path)
	if (
		bytes.size() < 44
		or bytes.slice(0, 4).get_string_from_ascii() != "RIFF"
		or bytes.slice(8, 16).get_string_from_ascii() != "WAVEfmt "
		or bytes.decode_u16(22) != 1
		or bytes.decode_u32(24) != expected_rate_hz
		or bytes.decode_u16(34) != 16
		or bytes.decode_u32(40) != bytes.size() - 44
	):
		return samples
	for place in range(44, bytes.size(), 2):
		samples.append(bytes.decode_s16(place) / 32768.0)
	return samples
