// A device's clock, mapped to that of the host.

#include "base/random.h"
#include "devices/device_clock.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double OFFSET_S = 5000.0; ///< of the host's clock to the device's, for a sample without delay

struct Sample {
	double true_s; ///< on the host's clock
	double device_s;
	double arrival_s;
};

/// `count` samples, of which `burst` arrive at a time; each delivery waits for an exponential delay.
std::vector<Sample> bursts(
		Random &random, int count, double rate_hz, int burst, double delay_s, double drift = 0.0) {
	std::vector<Sample> samples;
	double arrival_s = 0.0;
	for (int i = 0; i < count; ++i) {
		const double t_s = i / rate_hz;
		if (i % burst == 0) {
			const double whole_s = (i + burst - 1) / rate_hz;
			arrival_s = std::max(arrival_s, whole_s + random.waiting_time(1.0 / delay_s));
		}
		samples.push_back({ t_s + OFFSET_S, t_s * (1.0 + drift), arrival_s + OFFSET_S });
	}
	return samples;
}

/// Largest |mapped - true| after `from_s` of samples, s. Checks what always holds.
double largest_error_s(const std::vector<Sample> &samples, double from_s, DeviceClock clock = {}) {
	double largest_s = 0.0;
	double last_s = -1e9;
	for (const Sample &sample : samples) {
		const DeviceClock::Stamp stamp = clock.map(sample.device_s, sample.arrival_s);
		CHECK_FALSE(stamp.restarted);
		CHECK(stamp.host_s >= last_s);
		CHECK(stamp.host_s <= sample.arrival_s);
		last_s = stamp.host_s;
		if (sample.true_s - samples.front().true_s >= from_s) {
			largest_s = std::max(largest_s, std::abs(stamp.host_s - sample.true_s));
		}
	}
	return largest_s;
}

/// A steady stream at 100 Hz of constant delay, from `device_s` and `arrival_s` on.
struct Stream {
	DeviceClock clock;
	double device_s = 100.0;
	double arrival_s = 7.0;
	double last_s = 7.0;
	int restarts = 0;

	DeviceClock::Stamp step(double device_step_s = 0.01, double arrival_step_s = 0.01) {
		device_s += device_step_s;
		arrival_s += arrival_step_s;
		const DeviceClock::Stamp stamp = clock.map(device_s, arrival_s);
		CHECK(stamp.host_s >= last_s);
		CHECK(stamp.host_s <= arrival_s);
		last_s = stamp.host_s;
		restarts += stamp.restarted ? 1 : 0;
		return stamp;
	}
	void run(int count) {
		for (int i = 0; i < count; ++i) {
			step();
		}
	}
};

} // namespace

TEST_CASE("samples in bursts of three at 110 Hz map within 1.5 ms after 2 s") {
	for (std::uint64_t seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		Random random(seed);
		CHECK(largest_error_s(bursts(random, 2200, 110.0, 3, 0.004), 2.0) < 1.5e-3);
	}
}

TEST_CASE("a Liberty at 240 Hz, read eight frames at a time, maps within 1.5 ms after 2 s") {
	Random random(3);
	CHECK(largest_error_s(bursts(random, 4800, 240.0, 8, 0.004), 2.0) < 1.5e-3);
}

TEST_CASE("a drift of 200 ppm adds at most 1 ms of error over 60 s") {
	for (const double drift : { -200e-6, 200e-6 }) {
		CAPTURE(drift);
		Random random(5);
		CHECK(largest_error_s(bursts(random, 6600, 110.0, 3, 0.003, drift), 2.0) < 1.5e-3);
	}
}

TEST_CASE("a first sample that is 50 ms late costs nothing after 0.2 s") {
	Random random(8);
	std::vector<Sample> samples = bursts(random, 110, 110.0, 1, 1e-5);
	for (Sample &sample : samples) {
		sample.arrival_s = std::max(sample.arrival_s, samples.front().true_s + 0.05);
	}
	CHECK(largest_error_s(samples, 0.2) < 2e-4);
}

TEST_CASE("samples that wait for 1.5 s and come at once keep their stamps") {
	Random random(9);
	std::vector<Sample> samples = bursts(random, 1100, 110.0, 1, 1e-4);
	for (Sample &sample : samples) {
		if (sample.true_s > OFFSET_S + 3.0) {
			sample.arrival_s = std::max(sample.arrival_s, OFFSET_S + 4.5);
		}
	}
	CHECK(largest_error_s(samples, 2.0) < 1.5e-3);
}

TEST_CASE("a clock that is set starts anew, and says so once") {
	for (const double jump_s : { 200000.0, -200000.0, -10.0, 10.0 }) {
		CAPTURE(jump_s);
		Stream stream;
		stream.run(300);
		CHECK(stream.restarts == 0);
		const DeviceClock::Stamp stamp = stream.step(jump_s);
		CHECK(stamp.restarted);
		CHECK(stamp.host_s == doctest::Approx(stream.arrival_s).epsilon(1e-12));
		stream.run(1000);
		CHECK(stream.restarts == 1);
		CHECK(std::abs(stream.last_s - stream.arrival_s) < 1e-9);
	}
}

TEST_CASE("samples that stay 0.5 s late for a window of 5 s start the clock anew") {
	Stream stream;
	stream.run(300);
	stream.step(0.01, 0.51);
	stream.run(400);
	CHECK(stream.restarts == 0);
	CHECK(stream.arrival_s - stream.last_s == doctest::Approx(0.5).epsilon(0.02));
	stream.run(150);
	CHECK(stream.restarts == 1);
	CHECK(std::abs(stream.last_s - stream.arrival_s) < 1e-9);
}

TEST_CASE("after 6 s without a sample the next one sets the offset") {
	Stream stream;
	stream.run(300);
	const DeviceClock::Stamp stamp = stream.step(6.0, 6.2);
	CHECK_FALSE(stamp.restarted);
	CHECK(std::abs(stamp.host_s - stream.arrival_s) < 1e-9);
}

TEST_CASE("a sample that comes 20 ms out of order repeats the last stamp") {
	Stream stream;
	stream.run(300);
	const double last_s = stream.last_s;
	CHECK(stream.step(-0.02, 0.001).host_s == last_s);
	CHECK(stream.step(0.03, 0.009).host_s > last_s);
	stream.run(10);
	CHECK(stream.restarts == 0);
	CHECK(std::abs(stream.last_s - stream.arrival_s) < 1e-9);
}

TEST_CASE("small steps back that sum up to more than 0.1 s start the clock anew") {
	Stream stream;
	stream.run(300);
	for (int i = 0; i < 6; ++i) {
		CHECK(stream.restarts == 0);
		stream.step(-0.02, 0.001);
	}
	CHECK(stream.restarts == 1);
}

TEST_CASE("a delay that grows by 5 ms for good is followed at 1 ms/s") {
	Stream stream;
	stream.run(300);
	stream.step(0.01, 0.015);
	double last_s = stream.last_s;
	for (int i = 0; i < 1200; ++i) {
		const double host_s = stream.step().host_s;
		CHECK(host_s - last_s >= 0.0099999);
		CHECK(host_s - last_s <= 0.0100101);
		last_s = host_s;
	}
	CHECK(stream.restarts == 0);
	CHECK(std::abs(stream.last_s - stream.arrival_s) < 1e-9);
}

TEST_CASE("numbers that are no times leave the clock as it was") {
	constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
	constexpr double INFINITE = std::numeric_limits<double>::infinity();
	Stream stream;
	CHECK(stream.clock.map(NOT_A_NUMBER, NOT_A_NUMBER).host_s == 0.0);
	stream.run(300);
	const double last_s = stream.last_s;
	for (const double wrong : { NOT_A_NUMBER, INFINITE, -INFINITE, 1e300 }) {
		CAPTURE(wrong);
		CHECK(stream.clock.map(stream.device_s, wrong).host_s == last_s);
		const DeviceClock::Stamp stamp = stream.clock.map(wrong, stream.arrival_s);
		CHECK(stamp.host_s == stream.arrival_s);
		CHECK_FALSE(stamp.restarted);
	}
	stream.run(10);
	CHECK(stream.restarts == 0);
	CHECK(std::abs(stream.last_s - stream.arrival_s) < 1e-9);
	// A long time of no usable stamp must not take long to catch up with.
	stream.clock.map(NOT_A_NUMBER, 9e8);
	CHECK(stream.clock.map(stream.device_s + 0.01, 9e8 + 0.01).host_s == 9e8 + 0.01);
}

TEST_CASE("any numbers give stamps that never decrease nor pass their arrival") {
	Random random(11);
	DeviceClock clock;
	double arrival_s = 0.0;
	double last_s = -1e9;
	for (int i = 0; i < 100000; ++i) {
		const double device_s = random.chance(0.5) ? i * 0.01 : std::pow(10.0, random.uniform(-3.0, 12.0));
		arrival_s += random.chance(0.01) ? random.uniform(0.0, 20.0) : random.uniform(0.0, 0.02);
		const double host_s = clock.map(random.chance(0.5) ? device_s : -device_s, arrival_s).host_s;
		REQUIRE(host_s >= last_s);
		REQUIRE(host_s <= arrival_s);
		last_s = host_s;
	}
}
