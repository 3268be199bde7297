#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace steadyhand {

/// log(sum(exp(x))) without overflow; -inf for an empty vector or one of nothing but -inf.
template <class Derived> double log_sum_exp(const Eigen::DenseBase<Derived> &x) {
	const double largest = x.size() > 0 ? x.derived().maxCoeff() : -std::numeric_limits<double>::infinity();
	if (!(largest > -std::numeric_limits<double>::infinity())) {
		return largest;
	}
	return largest + std::log((x.derived().array() - largest).exp().sum());
}

} // namespace steadyhand
