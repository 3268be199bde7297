#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <utility>

namespace steadyhand {

/// Positions of both trackers at the same moments of the movement, one a column.
struct Pairs {
	Eigen::Matrix3Xd reference_m, other_m;

	[[nodiscard]] Eigen::Index size() const { return reference_m.cols(); }
};

/// Collects pairs in memory that is allocated once.
class PairList {
public:
	explicit PairList(std::size_t most) :
			pairs_{ Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(most)),
				Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(most)) } {}

	void add(const Eigen::Vector3d &reference_m, const Eigen::Vector3d &other_m) {
		pairs_.reference_m.col(size_) = reference_m;
		pairs_.other_m.col(size_) = other_m;
		++size_;
	}
	[[nodiscard]] Pairs take() {
		pairs_.reference_m.conservativeResize(3, size_);
		pairs_.other_m.conservativeResize(3, size_);
		return std::move(pairs_);
	}

private:
	Pairs pairs_;
	Eigen::Index size_ = 0;
};

/// T_reference_other.
struct RigidFit {
	Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
	Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

	[[nodiscard]] Eigen::VectorXd residuals_m(const Pairs &pairs) const;
};

/// Umeyama 1991, doi 10.1109/34.88573, without scaling.
[[nodiscard]] RigidFit rigid_fit(const Pairs &pairs);

[[nodiscard]] double rms(const Eigen::VectorXd &values);

/// Without the pairs that a fit of the rest leaves far apart.
[[nodiscard]] Pairs without_outliers(const Pairs &all);

} // namespace steadyhand
