#include "haptics/device_profile.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double MOST_GAIN = 4.0;

} // namespace

double response_at(std::span<const DeviceProfile::Point> response, double frequency_hz) {
	if (response.empty()) {
		return 1.0;
	}
	const auto above = std::find_if(response.begin(), response.end(),
			[frequency_hz](const DeviceProfile::Point &point) { return point.frequency_hz > frequency_hz; });
	if (above == response.begin()) {
		return above->response;
	}
	const DeviceProfile::Point &below = *(above - 1);
	if (above == response.end()) {
		return below.response;
	}
	const double share =
			std::log(frequency_hz / below.frequency_hz) / std::log(above->frequency_hz / below.frequency_hz);
	return below.response + share * (above->response - below.response);
}

Effect adapted(const Effect &effect, const DeviceProfile &device) {
	Effect driven = effect;
	if (device.resonance_hz > 0.0) {
		driven.frequency_hz = device.resonance_hz;
		driven.frequency_table = {};
	}
	double best = 0.0;
	for (const DeviceProfile::Point &point : device.response) {
		best = std::max(best, point.response);
	}
	if (best > 0.0) {
		const double share = response_at(device.response, driven.frequency_hz) / best;
		driven.gain *= 1.0 / std::max(share, 1.0 / MOST_GAIN);
	}
	driven.most = std::min(effect.most, device.most);
	return driven;
}

} // namespace steadyhand
