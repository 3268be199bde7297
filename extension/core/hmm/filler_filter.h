#pragma once

#include "hmm/scaled_number.h"

#include <Eigen/Core>

#include <array>

namespace steadyhand {

/// The filler, or threshold, model (Lee and Kim 1999, doi:10.1109/34.799904). It has the states of all
/// gestures and of other motion. Each state keeps its self-transition, and leads to all others with equal
/// probability. All orders of the states are equally likely, so motion that is no gesture is likelier under
/// the filler than under a gesture's HMM. Entries are probabilities.
struct FillerModel {
	Eigen::VectorXd stay; ///< N: self-transition
	Eigen::MatrixXd b;    ///< N x (M + 1): emissions; the last column, all 1, is for UNSEEN
};

/// Forward variable of a FillerModel for LANES sequences at once. Every state leads to every other, so the
/// states of a lane differ by at most the factor of one symbol. One scale for each lane is therefore exact at
/// any length. A step costs O(N) operations for each lane, because the transitions to all other states are
/// equal.
template <int LANES> class FillerFilter {
public:
	/// Only the constructor allocates.
	explicit FillerFilter(const FillerModel &model) :
			stay_(model.stay),
			leave_((1.0 - model.stay.array()) / static_cast<double>(model.stay.size() - 1)),
			alpha_(model.stay.size(), LANES) {
		alpha_.setZero();
	}

	/// Starts a lane with equal state probabilities. b: N emissions of the first symbol.
	void start(int lane, const double *b) {
		const Eigen::Map<const Eigen::ArrayXd> emission(b, alpha_.rows());
		alpha_.col(lane) = emission / static_cast<double>(alpha_.rows());
		likelihood_[static_cast<std::size_t>(lane)] = ScaledNumber(1.0, 0);
		normalise(lane);
	}
	void step(int lane, const double *b) {
		const Eigen::Map<const Eigen::ArrayXd> emission(b, alpha_.rows());
		auto alpha = alpha_.col(lane);
		const double left = (leave_ * alpha).sum();
		alpha = ((stay_ - leave_) * alpha + left) * emission;
		normalise(lane);
	}
	/// P(o_1..o_t | filler).
	[[nodiscard]] const ScaledNumber &likelihood(int lane) const {
		return likelihood_[static_cast<std::size_t>(lane)];
	}

private:
	Eigen::ArrayXd stay_, leave_;
	Eigen::ArrayXXd alpha_; ///< N x LANES; each lane sums to 1
	std::array<ScaledNumber, LANES> likelihood_{};

	void normalise(int lane) {
		const double sum = alpha_.col(lane).sum();
		alpha_.col(lane) /= sum;
		auto &likelihood = likelihood_[static_cast<std::size_t>(lane)];
		likelihood = likelihood * sum;
	}
};

} // namespace steadyhand
