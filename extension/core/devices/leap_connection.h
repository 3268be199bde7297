#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace steadyhand {

// What a client of a Leap or Ultraleap service sends, and when it connects again. The messages that it
// receives are in leap_protocol.h. Ultraleap's bridge compares them byte for byte and accepts at most 31
// bytes.

/// Asks for frames while another client has the focus.
inline constexpr std::string_view LEAP_BACKGROUND = R"({"background":true})";
/// Takes the focus from other clients.
inline constexpr std::string_view LEAP_FOCUSED = R"({"focused":true})";
inline constexpr std::string_view LEAP_HMD_ON = R"({"optimizeHMD":true})";
inline constexpr std::string_view LEAP_HMD_OFF = R"({"optimizeHMD":false})";
/// Only the bridge supports these two.
inline constexpr std::string_view LEAP_SCREENTOP_ON = R"({"optimizeScreentop":true})";
inline constexpr std::string_view LEAP_SCREENTOP_OFF = R"({"optimizeScreentop":false})";

/// Where the device is mounted. It determines the device's axes in the scene, and what the service optimises
/// for.
enum class LeapMounting : std::uint8_t {
	DESKTOP,  ///< on a desk, faces up
	HMD,      ///< on the front of a headset, faces forward
	SCREENTOP ///< hangs upside down at the top edge of a screen
};

/// What a client sends after each version message, in the order of Leap's own client. A service keeps these
/// settings only for the connection.
[[nodiscard]] std::array<std::string_view, 3> leap_greeting(LeapMounting mounting);

/// Leap's own client asks for version 6 first. In earlier versions hands have no side and no joints:
/// parse_leap_message() skips all hands, and the user needs a newer service.
inline constexpr int LEAP_VERSION_WANTED = 6;

/// The path of the WebSocket's URL, as "/v6.json".
[[nodiscard]] std::string leap_path(int version);

/// The version to ask for after a connection has ended: one less if the service refused the version (close
/// code 1001 before any version message). Empty if the client keeps `requested`, or if it was version 1.
[[nodiscard]] std::optional<int> next_version(int requested, int close_code, bool got_version);

/// Seconds to wait before attempt number `attempt` to connect again, from 0: 0.5 s, doubled each time, 8 s at
/// most. The client finds a new service soon. Attempts without a service cost almost nothing.
[[nodiscard]] double reconnect_delay_s(int attempt);

} // namespace steadyhand
