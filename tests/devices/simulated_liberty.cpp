#include "simulated_liberty.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <numbers>

namespace {

using Point = std::array<double, 3>;

constexpr char CONTROL_U = 0x15;

/// s. What the computer did not fetch for so long is lost, as the output buffer is off.
constexpr double OVERLOAD_S = 0.1;

/// Godot's axes, m: 1.0 s of rest, 20 cm to +x in 0.8 s along a minimum-jerk path, 1.2 s of rest, 0.8 s back.
Point fingertip_m(double t_s) {
	constexpr double REST_S = 1.0, MOVE_S = 0.8, DWELL_S = 1.2, LENGTH_M = 0.2, TREMOR_M = 5e-5;
	const double t = std::fmod(t_s, REST_S + MOVE_S + DWELL_S + MOVE_S);
	const double back_s = REST_S + MOVE_S + DWELL_S;
	const double phase = std::clamp((t < back_s ? t - REST_S : t - back_s) / MOVE_S, 0.0, 1.0);
	const double path = phase * phase * phase * (10.0 + phase * (6.0 * phase - 15.0));
	const double turn = 2.0 * std::numbers::pi * t_s;
	return { LENGTH_M * (t < back_s ? path : 1.0 - path) + TREMOR_M * std::sin(9.0 * turn),
		0.25 + TREMOR_M * std::sin(10.3 * turn + 1.0), -0.3 + TREMOR_M * std::sin(8.7 * turn + 2.0) };
}

void put_u32(std::string &r_bytes, std::uint32_t number) {
	for (int shift = 0; shift < 32; shift += 8) {
		r_bytes += static_cast<char>(number >> shift & 0xFFU);
	}
}

void put_float(std::string &r_bytes, double number) {
	put_u32(r_bytes, std::bit_cast<std::uint32_t>(static_cast<float>(number)));
}

std::string header(int station, char command, std::uint8_t code, std::size_t size) {
	return { 'L', 'Y', static_cast<char>(station), command, static_cast<char>(code), 0,
		static_cast<char>(size & 0xFFU), static_cast<char>(size >> 8U) };
}

} // namespace

SimulatedLiberty::SimulatedLiberty(const SimulatedFaults &faults, double now_s) :
		faults_(faults), is_streaming_(faults.streaming), epoch_s_(now_s) {}

void SimulatedLiberty::write(std::string_view bytes, double now_s) {
	for (const char byte : bytes) {
		const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(byte)));
		if (letter == 'P' && command_.empty()) { // the one command without a carriage return
			obey("P", now_s);
		} else if (byte == '\r') {
			obey(command_, now_s);
			command_.clear();
		} else {
			command_ += letter;
		}
	}
}

void SimulatedLiberty::obey(const std::string &command, double now_s) {
	commands_ += commands_.empty() ? "" : " ";
	for (const char letter : command.empty() ? "(empty)" : command) {
		commands_ +=
				letter < ' ' ? std::string{ '^', static_cast<char>(letter + 0x40) } : std::string{ letter };
	}
	if (faults_.silent) {
		return;
	}
	if (!command.empty() && command[0] == faults_.refused) {
		refuse(command[0], 3, "Invalid Parameter");
	} else if (command == "P") {
		if (!is_streaming_) {
			transfers_.push_back(frame());
		}
		is_streaming_ = false;
	} else if (command == "C") {
		is_streaming_ = true;
		count_ = first_count_ = static_cast<std::uint32_t>(std::ceil((now_s - epoch_s_) * rate_hz()));
		is_started_ = true;
		overloads_ = 0;
	} else if (command == "F1") {
		is_binary_ = true;
	} else if (command == "U1") {
		is_metric_ = true;
	} else if (command == "R3" || command == "R4") {
		set_rate_hz_ = command == "R3" ? 120.0 : 240.0;
	} else if (command == "Q0") {
		epoch_s_ = now_s;
	} else if (command == "O*,8,9,11,3,7") {
		has_output_list_ = true;
	} else if (command == std::string{ CONTROL_U, '0' } && is_binary_) {
		std::string answer = header(0, CONTROL_U, 0, 4);
		const std::uint32_t active = (1U << faults_.station_count) - 1U;
		put_u32(answer, (active | 0x8000U) << 16U | active); // the last station is detected, but switched off
		transfers_.push_back(answer);
	} else if (!command.starts_with("H*,") && command != "X0,1,0,0" && command != "Y0,1,0,0" &&
			command != "@B0") {
		refuse(command.empty() ? '\r' : command[0], 1, "Invalid Command");
	}
}

void SimulatedLiberty::refuse(char command, std::uint8_t code, std::string_view text) {
	transfers_.push_back(
			(is_binary_ ? header(0, command, code, text.size() + 2) : "") + std::string(text) + "\r\n");
}

/// The records of all stations at count_.
std::string SimulatedLiberty::frame() const {
	const double t_s = count_ / rate_hz();
	std::string bytes;
	for (int station = 1; station <= faults_.station_count; ++station) {
		Point tip_m = fingertip_m(t_s);
		tip_m[1] += 0.1 * (station - 1); // the others move beside it, 10 cm above each other
		Point source_m = { -tip_m[2], tip_m[0], -tip_m[1] };
		const double round_s = std::fmod(t_s, 3.8);
		const double scale =
				(is_metric_ ? 100.0 : 39.3701) * (faults_.flip && round_s > 1.4 && round_s < 2.4 ? -1 : 1);
		if (!is_binary_ || !has_output_list_) {
			bytes += "01 " + std::to_string(source_m[0] * scale) + " " + std::to_string(source_m[1] * scale) +
					"\r\n";
			continue;
		}
		bytes += header(station, 'C', 0, 40);
		put_u32(bytes, static_cast<std::uint32_t>(t_s * 1000.0));
		put_u32(bytes, count_);
		put_u32(bytes, 0);
		for (const double coordinate : source_m) {
			put_float(bytes, coordinate * scale);
		}
		for (const double q : { 1.0, 0.0, 0.0, 0.0 }) {
			put_float(bytes, q);
		}
	}
	return bytes;
}

/// Makes the frames that are due.
void SimulatedLiberty::measure(double now_s) {
	while (is_streaming_ && epoch_s_ + count_ / rate_hz() <= now_s) {
		if (is_awaited_ || epoch_s_ + count_ / rate_hz() > now_s - OVERLOAD_S) {
			std::string bytes = frame();
			if (faults_.garbage && count_ % 10 == 0) {
				std::string garbage(1 + random_() % 30, '\0');
				std::generate(
						garbage.begin(), garbage.end(), [this] { return static_cast<char>(random_()); });
				bytes = garbage + bytes;
			}
			if (faults_.split && !transfers_.empty()) {
				transfers_.back() += bytes;
			} else {
				transfers_.push_back(bytes);
			}
		} else {
			++overloads_;
		}
		++count_;
	}
}

std::string SimulatedLiberty::read(double now_s) {
	measure(now_s);
	is_awaited_ = transfers_.empty();
	if (is_awaited_) {
		return {};
	}
	std::string bytes = transfers_.front();
	transfers_.pop_front();
	// They cut records at odd places. On average they are as long as a frame of three stations: a busy
	// computer could not keep up with many more transfers than frames.
	constexpr std::array<std::size_t, 6> SIZES = { 7, 241, 96, 1, 500, 13 };
	const std::size_t size = SIZES[split_++ % SIZES.size()];
	if (faults_.split && bytes.size() > size) {
		transfers_.push_front(bytes.substr(size));
		bytes.resize(size);
	}
	return bytes;
}
