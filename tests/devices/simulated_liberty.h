#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <string_view>
#include <vector>

/// What the simulated tracker does wrong.
struct SimulatedFaults {
	double rate_hz = 0.0;   ///< 0: the rate that it is set to
	bool split = false;     ///< transfers of odd sizes
	bool garbage = false;   ///< random bytes before every tenth record
	bool flip = false;      ///< the mirror image of the position, for a second of each round
	bool silent = false;    ///< no answer at all
	bool streaming = false; ///< from the start, as a program left it that crashed
	char refused = '\0';    ///< commands with this first letter are refused as of an invalid parameter
	int station_count = 1;
};

/// A Polhemus Liberty that follows the manual: commands in, transfers out, time given. Station 1 is a
/// fingertip that drags, written apart from the code under test.
class SimulatedLiberty {
public:
	SimulatedLiberty(const SimulatedFaults &faults, double now_s);

	/// Bytes of the computer. What was a command is listed in commands().
	void write(std::string_view bytes, double now_s);
	/// The next transfer, empty where none is due.
	std::string read(double now_s);

	/// All commands without their carriage return, "," between them; control characters as "^U".
	[[nodiscard]] const std::string &commands() const { return commands_; }
	/// Time since the computer started the stream, on the tracker's clock, s; 0 before.
	[[nodiscard]] double streamed_s() const {
		return is_started_ ? (count_ - first_count_) / rate_hz() : 0.0;
	}
	/// Frames of this stream that the computer did not fetch in time.
	[[nodiscard]] int overloads() const { return overloads_; }

private:
	void obey(const std::string &command, double now_s);
	void refuse(char command, std::uint8_t code, std::string_view text);
	void measure(double now_s);
	[[nodiscard]] std::string frame() const;
	[[nodiscard]] double rate_hz() const { return faults_.rate_hz > 0.0 ? faults_.rate_hz : set_rate_hz_; }

	SimulatedFaults faults_;
	bool is_binary_ = false, is_metric_ = false, is_streaming_ = false, has_output_list_ = false;
	double set_rate_hz_ = 240.0;
	double epoch_s_; ///< when the frame count was 0
	std::uint32_t count_ = 0, first_count_ = 0;
	bool is_started_ = false; ///< the computer has started the stream
	/// The computer waits for data: frames are not lost, also if this program itself runs late.
	bool is_awaited_ = false;
	int overloads_ = 0;
	std::string command_;
	std::string commands_;
	std::deque<std::string> transfers_;
	std::size_t split_ = 0;
	std::mt19937 random_{ 3 };
};
