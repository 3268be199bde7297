#include "simulation/earlier_rounds.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double PAUSE_S = 0.5; ///< before the return, and between the return and the next onset
constexpr double FASTEST_BACK_S = 0.4;

/// One repetition: a part of the motion, and the return. in_round_s: time since the begin of the round.
struct Round {
	TrueMotion motion;
	double from_s, to_s; ///< repeated part of the motion
	double back_s;       ///< duration of the return

	[[nodiscard]] double length_s() const { return to_s - from_s + back_s; }

	[[nodiscard]] double share_back(double in_round_s) const {
		return minimum_jerk((in_round_s - (to_s - from_s)) / back_s).value;
	}
	[[nodiscard]] HandFrame hand(double in_round_s) const {
		HandFrame frame = motion.hand(std::min(from_s + in_round_s, to_s));
		const HandFrame start = motion.hand(from_s);
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			frame.positions_m[joint] +=
					share_back(in_round_s) * (start.positions_m[joint] - frame.positions_m[joint]);
		}
		return frame;
	}
	[[nodiscard]] double severity(double in_round_s) const {
		const double there = motion.severity(std::min(from_s + in_round_s, to_s));
		return there + share_back(in_round_s) * (motion.severity(from_s) - there);
	}
};

} // namespace

TrueMotion after_earlier_rounds(const TrueMotion &motion, std::uint32_t rounds) {
	if (rounds == 0) {
		return motion;
	}
	const Round round{ motion, std::max(motion.start_s - PAUSE_S, 0.0),
		std::min(motion.end_s + PAUSE_S, motion.span_s),
		std::max(motion.end_s - motion.start_s, FASTEST_BACK_S) };
	const double earlier_s = rounds * round.length_s();
	TrueMotion all = motion;
	all.start_s += earlier_s;
	all.end_s += earlier_s;
	all.span_s += earlier_s;
	// The rounds begin at from_s. The rest before it comes once.
	const auto at = [round, earlier_s](double t_s, const auto &of_execution, const auto &of_round) {
		const double since_s = t_s - round.from_s;
		if (since_s < 0.0) {
			return of_execution(t_s);
		}
		return since_s < earlier_s ? of_round(std::fmod(since_s, round.length_s()))
								   : of_execution(t_s - earlier_s);
	};
	all.hand = [round, at](double t_s) {
		HandFrame frame =
				at(t_s, round.motion.hand, [&](double in_round_s) { return round.hand(in_round_s); });
		frame.t_s = t_s;
		return frame;
	};
	all.severity = [round, at](double t_s) {
		return at(t_s, round.motion.severity, [&](double in_round_s) { return round.severity(in_round_s); });
	};
	return all;
}

} // namespace steadyhand
