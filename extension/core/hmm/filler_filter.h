#pragma once

#include "hmm/scaled_number.h"

#include <Eigen/Core>

#include <array>

namespace steadyhand {

/// The filler, or threshold, model (Lee and Kim 1999, doi:10.1109/34.799904): the states of all gestures and
/// of other motion, each leading to itself as before and to all others alike. Any order of the states is as
/// likely as another, so that a hand which makes no gesture fits it better than the gesture's own HMM.
/// Probabilities.
struct FillerModel {
	Eigen::VectorXd stay; ///< N: that the state lasts for another symbol
	Eigen::MatrixXd b;    ///< N x (M + 1): the last column, all 1, is of UNSEEN
};

/// The forward variable of a FillerModel for several sequences at once, one a lane. As every state leads to
/// every other, none falls behind the others by more than one symbol can make it: one scale a lane is exact
/// at any length. A step costs N operations a lane, as all states but one are led to alike.
template <int LANES> class FillerFilter {
public:
	/// Allocates; nothing else does.
	explicit FillerFilter(const FillerModel &model) :
			stay_(model.stay),
			leave_((1.0 - model.stay.array()) / static_cast<double>(model.stay.size() - 1)),
			alpha_(model.stay.size(), LANES) {
		alpha_.setZero();
	}

	/// All states alike, after a first symbol. b: N emissions of it.
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
	Eigen::ArrayXXd alpha_; ///< N x LANES, each lane of sum 1
	std::array<ScaledNumber, LANES> likelihood_{};

	void normalise(int lane) {
		const double sum = alpha_.col(lane).sum();
		alpha_.col(lane) /= sum;
		auto &likelihood = likelihood_[static_cast<std::size_t>(lane)];
		likelihood = likelihood * sum;
	}
};

} // namespace steadyhand
