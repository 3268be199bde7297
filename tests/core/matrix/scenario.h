#pragma once

#include "gesture/task.h"
#include "hands.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace steadyhand::matrix {

enum class Gesture : std::uint8_t { TAP, HORIZONTAL_DRAG };

struct Rate {
	const char *name;
	double hz;
	bool in_bursts = false; ///< four frames at a time, stamped within 30 us of the fourth
};

inline constexpr std::array RATES{ Rate{ "10 Hz", 10.0 }, Rate{ "30 Hz", 30.0 }, Rate{ "60 Hz", 60.0 },
	Rate{ "72 Hz", 72.0 }, Rate{ "90 Hz", 90.0 }, Rate{ "100 Hz", 100.0 }, Rate{ "120 Hz", 120.0 },
	Rate{ "240 Hz", 240.0 }, Rate{ "bursts", 100.0, true } };

struct Noise {
	const char *name;
	double rounding_m;  ///< positions are multiples of it; 0: none
	double deviation_m; ///< white, on each axis
};

inline constexpr Noise NO_NOISE{ "none", 0.0, 0.0 }, ROUNDED{ "rounded to 0.5 mm", 5e-4, 0.0 },
		WHITE_100_UM{ "0.1 mm", 0.0, 1e-4 }, WHITE_500_UM{ "0.5 mm", 0.0, 5e-4 },
		WHITE_1_MM{ "1 mm", 0.0, 1e-3 };

enum class FaultKind : std::uint8_t { NONE, DROPOUT, ZEROS, FREEZE, SWAP, JUMP, DRIFT, LATE };

struct Fault {
	const char *name;
	FaultKind kind;
	double length_s; ///< SWAP, JUMP: unused, as they last for a number of frames
};

inline constexpr Fault NO_FAULT{ "none", FaultKind::NONE, 0.0 };
/// Each lasts for up to 0.5 s, and the tracker is right and on time before and after it.
inline constexpr std::array PASSING_FAULTS{ Fault{ "dropout 0.1 s", FaultKind::DROPOUT, 0.1 },
	Fault{ "dropout 0.3 s", FaultKind::DROPOUT, 0.3 }, Fault{ "zeros 0.2 s", FaultKind::ZEROS, 0.2 },
	Fault{ "freeze 0.5 s", FaultKind::FREEZE, 0.5 }, Fault{ "other hand, 6 frames", FaultKind::SWAP, 0.0 },
	Fault{ "jump 7 cm, 1 frame", FaultKind::JUMP, 0.0 },
	Fault{ "late 60 ms for 0.3 s", FaultKind::LATE, 0.3 } };
/// Grows for that long and stays.
inline constexpr Fault DRIFT{ "drift 1 cm", FaultKind::DRIFT, 0.5 };

/// A hand before a task, as one tracker shows it.
struct Scenario {
	std::string group; ///< its bounds: bounds.h
	Gesture gesture = Gesture::TAP;
	Task task;
	Hand hand;
	Rate rate = RATES[5];
	Noise noise = NO_NOISE;
	Fault fault = NO_FAULT;
	double fault_share = 0.4; ///< of the movement's duration, at which the fault begins
	std::uint64_t seed = 1;   ///< of the noise

	[[nodiscard]] double fault_s() const { return hand.from_s + fault_share * (hand.to_s - hand.from_s); }
	/// Where the hand is along the task, in amplitudes.
	[[nodiscard]] double truth(double t_s) const {
		return (hand.path.place_m(t_s) - task.start_m).dot(task.axis) / task.amplitude_m;
	}
	[[nodiscard]] double record_s() const { return hand.to_s + AFTER_S; }
};

/// Taps go down, drags to the right. Far from the tracker's origin, as in a room.
inline Task task_of(Gesture gesture, double length_m) {
	return { { 0.05, 1.05, -0.35 },
		gesture == Gesture::TAP ? Eigen::Vector3d(-Eigen::Vector3d::UnitY()) : Eigen::Vector3d::UnitX(),
		length_m };
}

} // namespace steadyhand::matrix
