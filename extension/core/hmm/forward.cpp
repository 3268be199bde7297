#include "hmm/forward.h"

namespace steadyhand {

template <class Scalar>
ForwardFilter<Scalar>::ForwardFilter(const DiscreteHmm &hmm) :
		hmm_(hmm), b_(hmm_.b.cast<Scalar>()), alpha_(hmm_.a, hmm_.b) {
	hmm_.pi.maxCoeff(&first_state_);
}

template <class Scalar> void ForwardFilter<Scalar>::reset() {
	started_ = false;
}

template <class Scalar> void ForwardFilter<Scalar>::push(Symbol symbol) {
	const Eigen::Index column = hmm_.column(symbol);
	if (started_) {
		alpha_.step(b_.col(column).data(), hmm_.b.col(column).data());
	} else {
		alpha_.reset();
		alpha_.start(0, hmm_.pi.data(), hmm_.b.col(column).data());
		started_ = true;
	}
}

template class ForwardFilter<float>;
template class ForwardFilter<double>;

double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	ForwardFilter<> filter(hmm);
	for (const Symbol symbol : symbols) {
		filter.push(symbol);
	}
	return filter.log_likelihood();
}

} // namespace steadyhand
