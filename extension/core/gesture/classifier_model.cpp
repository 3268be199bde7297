#include "gesture/classifier_model.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double MOST_STAY = 0.95; ///< a state of the filler lasts at most 0.2 s on average

} // namespace

std::size_t ClassifierModel::paces(const DirectedHmm &gesture) const {
	return static_cast<std::size_t>(std::ranges::count_if(gestures, [&](const DirectedHmm &one) {
		return one.gesture == gesture.gesture && one.axis == gesture.axis;
	}));
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
