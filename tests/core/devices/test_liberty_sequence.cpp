#include "devices/liberty_sequence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace steadyhand;

namespace {

std::vector<std::string> written(const std::vector<LibertyStep> &steps) {
	std::vector<std::string> bytes;
	for (const LibertyStep &step : steps) {
		bytes.push_back(step.bytes);
	}
	return bytes;
}

} // namespace

TEST_CASE("Liberty: the start-up writes these commands in this order") {
	const std::vector<std::string> expected = { "\rp", "f1\r", std::string("\x15") + "0\r", "U1\r", "R4\r",
		"h*,1.0000,0.0000,0.0000\r", "X0,1,0,0\r", "Y0,1,0,0\r", "@B0\r", "O*,8,9,11,3,7\r", "Q0\r", "c\r" };
	CHECK(written(liberty_start_steps({})) == expected);
	CHECK(written(liberty_stop_steps()) == std::vector<std::string>{ "p" });
}

TEST_CASE("Liberty: settings change their commands alone") {
	LibertySettings settings;
	settings.rate_hz = 120;
	settings.hemisphere = Eigen::Vector3d(0.0, -3.0, 4.0);
	settings.filters_off = false;
	const std::vector<std::string> bytes = written(liberty_start_steps(settings));
	CHECK(std::count(bytes.begin(), bytes.end(), "R3\r") == 1);
	CHECK(std::count(bytes.begin(), bytes.end(), "h*,0.0000,-0.6000,0.8000\r") == 1);
	CHECK(bytes.size() == 10);
	settings.hemisphere.setZero();
	const std::vector<std::string> tracking = written(liberty_start_steps(settings));
	CHECK(std::count(tracking.begin(), tracking.end(), "h*,0.0000,0.0000,0.0000\r") == 1);
}

TEST_CASE("Liberty: each step ends, and says what it is for") {
	for (const LibertyStep &step : liberty_start_steps({})) {
		CHECK(step.timeout_s > 0.0);
		CHECK(step.timeout_s <= 3.0);
		CHECK_FALSE(step.aim.empty());
	}
}

TEST_CASE("Liberty: settings that cannot be used are refused") {
	CHECK_FALSE(check(LibertySettings()).has_value());
	LibertySettings settings;
	settings.rate_hz = 60;
	REQUIRE(check(settings).has_value());
	CHECK(check(settings)->message == "Liberty: the rate must be 120 or 240 Hz, is 60.");
	settings = LibertySettings();
	settings.hemisphere.x() = std::numeric_limits<double>::quiet_NaN();
	CHECK(check(settings).has_value());
}
