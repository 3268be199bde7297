#pragma once

#include "hmm/state_decoder.h"
#include "motion/motion.h"
#include "phase/phase_effort.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand::bench {

inline constexpr double OUTPUTS_PER_S = 1000.0;
inline constexpr double FEW_OUTPUTS_PER_S = 250.0;
/// States and symbols beside those of the models that ship.
inline constexpr std::array<std::pair<int, int>, 8> MODEL_SIZES{ { { 2, 16 }, { 3, 16 }, { 6, 16 }, { 8, 16 },
		{ 4, 8 }, { 4, 32 }, { 4, 64 }, { 8, 64 } } };

struct Setting {
	std::string name; ///< of the preset, if it is one
	MotionMode mode;
	PhaseEffort effort;
	double outputs_per_s = OUTPUTS_PER_S;
	int states = 4, symbols = 16; ///< of the models; those that ship have so many
	StateDecoding decoding = {};  ///< of `paper` mode
};

inline bool is_same(const PhaseEffort &a, const PhaseEffort &b) {
	return a.usual == b.usual && a.erring == b.erring && a.wandering == b.wandering &&
			a.durations == b.durations && a.branch_period_s == b.branch_period_s;
}

/// `paper` mode as it ships, first; with other models; with every decoder, precision and rate of outputs.
inline std::vector<Setting> paper_settings() {
	std::vector<Setting> all{ { "paper", MotionMode::PAPER, {} } };
	for (const auto &[states, symbols] : MODEL_SIZES) {
		all.push_back({ "", MotionMode::PAPER, {}, OUTPUTS_PER_S, states, symbols });
	}
	using Rule = StateDecoding::Rule;
	using Precision = StateDecoding::Precision;
	for (const auto &[rule, lag] : { std::pair{ Rule::VITERBI, 0 }, std::pair{ Rule::VITERBI, 3 },
				 std::pair{ Rule::VITERBI, 8 }, std::pair{ Rule::FILTER, 0 } }) {
		for (const Precision precision : { Precision::DOUBLE, Precision::SINGLE }) {
			for (const double outputs_per_s : { OUTPUTS_PER_S, FEW_OUTPUTS_PER_S }) {
				const bool ships = rule == Rule::VITERBI && lag == 0 && precision == Precision::DOUBLE &&
						outputs_per_s == OUTPUTS_PER_S;
				if (!ships) {
					all.push_back(
							{ "", MotionMode::PAPER, {}, outputs_per_s, 4, 16, { rule, lag, precision } });
				}
			}
		}
	}
	return all;
}

inline std::vector<Setting> phase_settings() {
	std::vector<Setting> all;
	constexpr std::array<std::array<std::size_t, 3>, 5> KEPT{ { { 20, 16, 4 }, { 10, 8, 2 }, { 5, 4, 1 },
			{ 2, 2, 1 }, { 2, 1, 1 } } };
	for (const auto &[usual, erring, wandering] : KEPT) {
		for (const std::size_t durations : { 7, 3 }) {
			for (const double branch_period_s : { 0.03, 0.06 }) {
				all.push_back(
						{ "", MotionMode::PHASE, { usual, erring, wandering, durations, branch_period_s } });
			}
		}
	}
	for (const auto &[name, quality] : { std::pair{ "fast", Quality::FAST },
				 std::pair{ "balanced", Quality::BALANCED }, std::pair{ "accurate", Quality::ACCURATE } }) {
		const PhaseEffort effort = phase_effort(quality);
		std::erase_if(all, [&effort](const Setting &setting) { return is_same(setting.effort, effort); });
		all.push_back({ name, MotionMode::PHASE, effort });
		all.push_back({ "", MotionMode::PHASE, effort, FEW_OUTPUTS_PER_S });
	}
	return all;
}

} // namespace steadyhand::bench
