#include "haptics/device_profile.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

DeviceProfile peaked() {
	DeviceProfile device;
	device.response = { { 50.0, 0.1 }, { 100.0, 1.0 }, { 400.0, 0.5 } };
	return device;
}

} // namespace

TEST_CASE("a response is straight over the logarithm of the frequency, and held beyond its ends") {
	const DeviceProfile device = peaked();
	CHECK(response_at(device.response, 100.0) == test::near(1.0));
	CHECK(response_at(device.response, 200.0) == test::near(0.75));
	CHECK(response_at(device.response, std::sqrt(5000.0)) == test::near(0.55));
	CHECK(response_at(device.response, 1.0) == 0.1);
	CHECK(response_at(device.response, 1e6) == 0.5);
	CHECK(response_at({}, 100.0) == 1.0);
}

TEST_CASE("an effect is driven to feel alike, by at most 12 dB, and held to what the device bears") {
	DeviceProfile device = peaked();
	device.most = 0.7;
	Effect effect = spring_effect();
	effect.gain = 0.2;
	for (const double frequency_hz : { 100.0, 150.0, 200.0, 400.0 }) {
		effect.frequency_hz = frequency_hz;
		const Effect driven = adapted(effect, device);
		CHECK(driven.gain * response_at(device.response, frequency_hz) == test::near(0.2));
		CHECK(driven.most == 0.7);
		CHECK(driven.frequency_hz == frequency_hz);
	}
	effect.frequency_hz = 50.0;
	CHECK(adapted(effect, device).gain == test::near(0.8));
	device.resonance_hz = 100.0;
	const Effect moved = adapted(effect, device);
	CHECK(moved.frequency_hz == 100.0);
	CHECK(moved.gain == test::near(0.2));
	device.response = { { 100.0, 0.0 } };
	CHECK(adapted(effect, device).gain == test::near(0.2));
}
