#include "gesture/classifier_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace steadyhand {
namespace {

constexpr double MOST_STAY = 0.95; ///< a state of the filler lasts at most 0.2 s on average

} // namespace

std::size_t paces(std::span<const DirectedHmm> hmms, const DirectedHmm &gesture) {
	return static_cast<std::size_t>(std::ranges::count_if(hmms, [&](const DirectedHmm &one) {
		return one.gesture == gesture.gesture && one.axis == gesture.axis;
	}));
}

std::string checksum(const MotionCodebook &codebook) {
	// FNV-1a of 64 bits.
	std::uint64_t hash = 0xcbf29ce484222325;
	const auto add = [&hash](double value) {
		const auto bits = std::bit_cast<std::uint64_t>(value);
		for (int shift = 0; shift < 64; shift += 8) {
			hash = (hash ^ (bits >> shift & 0xff)) * 0x100000001b3;
		}
	};
	std::ranges::for_each(codebook.scale(), add);
	std::ranges::for_each(codebook.codebook().reshaped(), add);
	std::string text;
	for (int shift = 60; shift >= 0; shift -= 4) {
		text += "0123456789abcdef"[hash >> shift & 0xf];
	}
	return text;
}

Eigen::RowVectorXd symbols_of_other(const DiscreteHmm &other) {
	constexpr int DOUBLINGS = 20; // a million transitions: from any state to the stationary distribution
	Eigen::MatrixXd a = other.log_a.array().exp();
	for (int i = 0; i < DOUBLINGS; ++i) {
		a = (a * a).eval();
	}
	const Eigen::RowVectorXd symbols = a.row(0) * other.log_b.array().exp().matrix();
	return symbols / symbols.sum();
}

FillerModel filler_of(const ClassifierModel &model, double evidence) {
	Eigen::Index states = model.other.states();
	for (const DirectedHmm &gesture : model.gestures) {
		states += gesture.hmm.states();
	}
	const Eigen::Index symbols = model.codebook.symbols();
	FillerModel filler;
	filler.stay.resize(states);
	filler.b.resize(states, symbols + 1);
	Eigen::Index next = 0;
	for (const DirectedHmm &gesture : model.gestures) {
		const Eigen::Index n = gesture.hmm.states();
		filler.stay.segment(next, n) = gesture.hmm.log_a.diagonal().array().exp();
		filler.b.middleRows(next, n).leftCols(symbols) = (evidence * gesture.hmm.log_b).array().exp();
		next += n;
	}
	filler.stay.tail(states - next) = model.other.log_a.diagonal().array().exp();
	filler.b.bottomRows(states - next).leftCols(symbols) = (evidence * model.other.log_b).array().exp();
	filler.b.rightCols<1>().setOnes();
	// The last state of a gesture has a self-transition of 1, which the filler would never leave.
	filler.stay = filler.stay.cwiseMin(MOST_STAY);
	return filler;
}

} // namespace steadyhand
