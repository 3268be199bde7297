#include "devices/leap_connection.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

std::array<std::string_view, 3> leap_greeting(LeapMounting mounting) {
	switch (mounting) {
		case LeapMounting::HMD:
			return { LEAP_BACKGROUND, LEAP_HMD_ON, LEAP_FOCUSED };
		case LeapMounting::SCREENTOP:
			return { LEAP_BACKGROUND, LEAP_SCREENTOP_ON, LEAP_FOCUSED };
		case LeapMounting::DESKTOP:
			break;
	}
	return { LEAP_BACKGROUND, LEAP_HMD_OFF, LEAP_FOCUSED };
}

std::string leap_path(int version) {
	return "/v" + std::to_string(version) + ".json";
}

std::optional<int> next_version(int requested, int close_code, bool got_version) {
	constexpr int GOING_AWAY = 1001; // RFC 6455 7.4.1
	if (got_version || close_code != GOING_AWAY || requested <= 1) {
		return std::nullopt;
	}
	return requested - 1;
}

double reconnect_delay_s(int attempt) {
	constexpr double FIRST_S = 0.5; // Leap's own client waits this long before each attempt
	constexpr double LONGEST_S = 8.0;
	return std::min(LONGEST_S, std::ldexp(FIRST_S, std::clamp(attempt, 0, 10)));
}

} // namespace steadyhand
