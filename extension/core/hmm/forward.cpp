#include "hmm/forward.h"

#include "hmm/log_sum.h"

namespace steadyhand {

ForwardFilter::ForwardFilter(const DiscreteHmm &hmm) :
		hmm_(&hmm), log_alpha_(hmm.states()), next_(hmm.states()), log_b_(hmm.states()) {
	reset();
}

void ForwardFilter::reset() {
	started_ = false;
	log_alpha_ = hmm_->log_pi;
}

void ForwardFilter::push(Symbol symbol) {
	hmm_->emission(symbol, log_b_);
	if (!started_) {
		log_alpha_ = hmm_->log_pi + log_b_;
		started_ = true;
		return;
	}
	for (Eigen::Index j = 0; j < hmm_->states(); ++j) {
		next_(j) = log_sum_exp(log_alpha_ + hmm_->log_a.col(j)) + log_b_(j);
	}
	log_alpha_.swap(next_);
}

double ForwardFilter::log_likelihood() const {
	return started_ ? log_sum_exp(log_alpha_) : 0.0;
}

double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	ForwardFilter filter(hmm);
	for (const Symbol symbol : symbols) {
		filter.push(symbol);
	}
	return filter.log_likelihood();
}

Eigen::MatrixXd log_forward(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	Eigen::MatrixXd log_alpha(hmm.states(), static_cast<Eigen::Index>(symbols.size()));
	ForwardFilter filter(hmm);
	for (Eigen::Index t = 0; t < log_alpha.cols(); ++t) {
		filter.push(symbols[static_cast<std::size_t>(t)]);
		log_alpha.col(t) = filter.log_alpha();
	}
	return log_alpha;
}

Eigen::MatrixXd log_backward(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	const auto length = static_cast<Eigen::Index>(symbols.size());
	Eigen::MatrixXd log_beta = Eigen::MatrixXd::Zero(hmm.states(), length);
	Eigen::VectorXd log_b(hmm.states());
	for (Eigen::Index t = length - 2; t >= 0; --t) {
		hmm.emission(symbols[static_cast<std::size_t>(t + 1)], log_b);
		for (Eigen::Index i = 0; i < hmm.states(); ++i) {
			log_beta(i, t) = log_sum_exp(hmm.log_a.row(i).transpose() + log_b + log_beta.col(t + 1));
		}
	}
	return log_beta;
}

} // namespace steadyhand
