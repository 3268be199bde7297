#include "devices/liberty_clock.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

TEST_CASE("Liberty clock: time is the frame count divided by the rate") {
	LibertyClock clock(240.0);
	CHECK(clock.update(3000, 0.0).time_s == doctest::Approx(12.5));
	CHECK(clock.update(3001, 0.004).time_s == doctest::Approx(3001.0 / 240.0));
	LibertyClock slower(120.0);
	CHECK(slower.update(3000, 0.0).time_s == doctest::Approx(25.0));
}

TEST_CASE("Liberty clock: stations of one cycle get one time") {
	LibertyClock clock(240.0);
	const double time_s = clock.update(10, 0.0).time_s;
	const LibertyClock::Answer again = clock.update(10, 0.001);
	CHECK(again.time_s == time_s);
	CHECK(again.lost == 0);
	CHECK_FALSE(again.has_restarted);
}

TEST_CASE("Liberty clock: the count rolls over without a gap") {
	LibertyClock clock(240.0);
	const double before_s = clock.update(0xFFFFFFFEU, 0.0).time_s;
	static_cast<void>(clock.update(0xFFFFFFFFU, 1.0 / 240.0));
	const LibertyClock::Answer zero = clock.update(0, 2.0 / 240.0);
	CHECK(zero.time_s - before_s == doctest::Approx(2.0 / 240.0).epsilon(1e-6));
	CHECK(zero.lost == 0);
	CHECK_FALSE(zero.has_restarted);
	CHECK(clock.update(5, 0.04).lost == 4);
}

TEST_CASE("Liberty clock: a skipped frame is reported as lost") {
	LibertyClock clock(240.0);
	static_cast<void>(clock.update(100, 0.0));
	CHECK(clock.update(101, 0.004).lost == 0);
	const LibertyClock::Answer later = clock.update(149, 0.2);
	CHECK(later.lost == 47);
	CHECK(later.time_s == doctest::Approx(149.0 / 240.0));
}

TEST_CASE("Liberty clock: a count that goes back does not turn time back") {
	LibertyClock clock(240.0);
	const double before_s = clock.update(100000, 10.0).time_s;
	const LibertyClock::Answer restarted = clock.update(3, 10.5);
	CHECK(restarted.has_restarted);
	CHECK(restarted.lost == 0);
	CHECK(restarted.time_s == doctest::Approx(before_s + 0.5));
	CHECK(clock.update(4, 10.504).time_s == doctest::Approx(restarted.time_s + 1.0 / 240.0));
}

TEST_CASE("Liberty clock: 10 Hz in place of 240 is a fault after 2 s") {
	LibertyClock clock(240.0);
	double fault_s = -1.0;
	int faults = 0;
	for (std::uint32_t i = 0; i < 100; ++i) {
		if (clock.update(i, 0.1 * i).has_rate_fault) {
			++faults;
			fault_s = 0.1 * i;
		}
	}
	CHECK(faults == 1);
	CHECK(fault_s == doctest::Approx(2.0).epsilon(0.051));
	CHECK(clock.measured_rate_hz() == doctest::Approx(10.0));
	CHECK(clock.rate_fault_text() ==
			"Liberty: 10 frames a second arrive, must be 240. Plug the tracker into a USB port of the "
			"computer "
			"itself, close other programs, then switch the tracker off and on.");
}

TEST_CASE("Liberty clock: late and bunched arrivals at the right rate are no fault") {
	LibertyClock clock(240.0);
	for (std::uint32_t i = 0; i < 240 * 20; ++i) {
		// Frames come in bunches of five, each 20 ms late at the most.
		const double host_s = std::floor(i / 5.0) * 5.0 / 240.0 + 0.02;
		CHECK_FALSE(clock.update(i, host_s).has_rate_fault);
	}
	CHECK(clock.measured_rate_hz() == doctest::Approx(240.0).epsilon(0.02));
}

TEST_CASE("Liberty clock: a deviation of 5 percent is the limit") {
	for (const double rate_hz : { 225.0, 231.0, 249.0, 255.0 }) {
		LibertyClock clock(240.0);
		for (std::uint32_t i = 0; i < 1200; ++i) {
			static_cast<void>(clock.update(i, i / rate_hz));
		}
		CHECK(clock.rate_fault() == (std::abs(rate_hz / 240.0 - 1.0) > 0.05));
	}
}

TEST_CASE("Liberty clock: a count at another rate keeps the host's pace after 2 s") {
	for (const double count_hz : { 10.0, 120.0, 480.0 }) {
		LibertyClock clock(240.0);
		double from_s = 0.0, to_s = 0.0, last_s = -1.0;
		for (std::uint32_t i = 0; i < 20.0 * count_hz; ++i) {
			const double host_s = i / count_hz;
			const double time_s = clock.update(i, host_s).time_s;
			CHECK(time_s > last_s);
			last_s = time_s;
			from_s = host_s < 3.0 ? time_s - host_s : from_s;
			to_s = time_s - host_s;
		}
		CHECK(to_s == doctest::Approx(from_s).epsilon(0.01));
	}
}

TEST_CASE("Liberty clock: lost frames change the arrival rate but not the time") {
	LibertyClock clock(240.0);
	for (std::uint32_t i = 0; i < 2400; i += 2) {
		CHECK(clock.update(i, i / 240.0).time_s == doctest::Approx(i / 240.0));
	}
	CHECK(clock.rate_fault());
	CHECK(clock.measured_rate_hz() == doctest::Approx(120.0).epsilon(0.01));
}
