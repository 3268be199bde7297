#include "metrics/rigid_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steadyhand {

namespace {

/// Residuals beyond this many medians are outliers: of normal noise 1 in 10000.
constexpr double OUTLIER_MEDIANS = 3.0;
/// No residual below it is an outlier: trackers are not that exact.
constexpr double NO_OUTLIER_M = 0.001;
/// Each fit finds the outliers that the next one leaves out. Jumps disturb the first two.
constexpr int FITS = 3;

} // namespace

Eigen::VectorXd RigidFit::residuals_m(const Pairs &pairs) const {
	return ((rotation * pairs.other_m).colwise() + translation_m - pairs.reference_m)
			.colwise()
			.norm()
			.transpose();
}

RigidFit rigid_fit(const Pairs &pairs) {
	const Eigen::Matrix4d transform = Eigen::umeyama(pairs.other_m, pairs.reference_m, false);
	return { transform.topLeftCorner<3, 3>(), transform.topRightCorner<3, 1>() };
}

double rms(const Eigen::VectorXd &values) {
	return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

Pairs without_outliers(const Pairs &all) {
	Pairs kept = all;
	for (int i = 0; i < FITS; ++i) {
		const Eigen::VectorXd residuals_m = rigid_fit(kept).residuals_m(all);
		std::vector<double> sorted_m(residuals_m.begin(), residuals_m.end());
		const auto middle = sorted_m.begin() + static_cast<std::ptrdiff_t>(sorted_m.size() / 2);
		std::nth_element(sorted_m.begin(), middle, sorted_m.end());
		const double limit_m = std::max(OUTLIER_MEDIANS * *middle, NO_OUTLIER_M);
		PairList list(static_cast<std::size_t>(all.size()));
		for (Eigen::Index column = 0; column < all.size(); ++column) {
			if (residuals_m[column] <= limit_m) {
				list.add(all.reference_m.col(column), all.other_m.col(column));
			}
		}
		kept = list.take();
	}
	return kept;
}

} // namespace steadyhand
