#pragma once

#include "hmm/state_decoder.h"
#include "motion/motion.h"
#include "motion/quality.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand::bench {

inline constexpr double OUTPUTS_PER_S = 1000.0;
inline constexpr double FEW_OUTPUTS_PER_S = 250.0;
/// Numbers of states and symbols, in addition to those of the shipped models.
inline constexpr std::array<std::pair<int, int>, 8> MODEL_SIZES{ { { 2, 16 }, { 3, 16 }, { 6, 16 }, { 8, 16 },
		{ 4, 8 }, { 4, 32 }, { 4, 64 }, { 8, 64 } } };

struct Setting {
	std::string name; ///< of the preset; empty if it is none
	MotionMode mode;
	std::size_t hypotheses;
	double outputs_per_s = OUTPUTS_PER_S;
	int states = 4, symbols = 16; ///< of the models; default: those of the shipped models
	StateDecoding decoding = {};  ///< of `paper` mode
};

/// Settings of `paper` mode: first the shipped one; then other models; then all decoders, precisions and
/// output rates.
inline std::vector<Setting> paper_settings() {
	std::vector<Setting> all{ { "paper", MotionMode::PAPER, 0 } };
	for (const auto &[states, symbols] : MODEL_SIZES) {
		all.push_back({ "", MotionMode::PAPER, 0, OUTPUTS_PER_S, states, symbols });
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
							{ "", MotionMode::PAPER, 0, outputs_per_s, 4, 16, { rule, lag, precision } });
				}
			}
		}
	}
	return all;
}

inline std::vector<Setting> phase_settings() {
	std::vector<Setting> all;
	for (const std::size_t hypotheses : { 2, 3, 4, 6, 8, 12, 16, 24, 48 }) {
		all.push_back({ "", MotionMode::PHASE, hypotheses });
	}
	for (const auto &[name, quality] : { std::pair{ "fast", Quality::FAST },
				 std::pair{ "balanced", Quality::BALANCED }, std::pair{ "accurate", Quality::ACCURATE } }) {
		const std::size_t hypotheses = hypotheses_of(quality);
		std::erase_if(all, [&](const Setting &setting) { return setting.hypotheses == hypotheses; });
		all.push_back({ name, MotionMode::PHASE, hypotheses });
		all.push_back({ "", MotionMode::PHASE, hypotheses, FEW_OUTPUTS_PER_S });
	}
	return all;
}

} // namespace steadyhand::bench
