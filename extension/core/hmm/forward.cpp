#include "hmm/forward.h"

namespace steadyhand {

ForwardFilter::ForwardFilter(const DiscreteHmm &hmm) :
		hmm_(hmm), alpha_(hmm_.a, hmm_.b), first_(hmm.states()) {}

void ForwardFilter::reset() {
	started_ = false;
}

void ForwardFilter::push(Symbol symbol) {
	const auto b = hmm_.b.col(hmm_.column(symbol));
	if (started_) {
		alpha_.step(b.data());
	} else {
		first_ = hmm_.pi.cwiseProduct(b);
		alpha_.reset();
		alpha_.start(0, first_.data());
		started_ = true;
	}
}

double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	ForwardFilter filter(hmm);
	for (const Symbol symbol : symbols) {
		filter.push(symbol);
	}
	return filter.log_likelihood();
}

} // namespace steadyhand
