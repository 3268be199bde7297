#pragma once

#include "gesture/feature.h"

#include <Eigen/Dense>

namespace steadyhand {

/// Whether a tracker errs, by the way on which it shows a hand that sets out: hands go along a line or a bow,
/// and trackers that err wander beside it as they do along it. Lengths in amplitudes.
class WayShape {
public:
	/// A frame that tells where the hand is. x: how far it has come; place: as TrackingSoundness takes it;
	/// noise: the tracker's, in each coordinate, standard deviation.
	void push(double x, const FeaturePlace &place, double noise);
	/// How much likelier the way so far is of a tracker that errs, as a logarithm, 0 .. 2.
	[[nodiscard]] double log_ratio() const { return log_ratio_; }

private:
	/// The way since the hand was last at the start: sums over frames of [1, x, x^2] with itself and with the
	/// places from the first one, and of these squared.
	struct Frames {
		Eigen::Matrix3d powers = Eigen::Matrix3d::Zero();
		Eigen::Matrix<double, 3, FeaturePlace::RowsAtCompileTime> places =
				Eigen::Matrix<double, 3, FeaturePlace::RowsAtCompileTime>::Zero();
		double squares = 0.0;
		int count = 0;
		FeaturePlace first = FeaturePlace::Zero();
	};

	Frames frames_;
	bool has_start_ = false; ///< of a hand that is first seen on its way nothing is known of that
	double log_ratio_ = 0.0;

	[[nodiscard]] double squared_distance_from_bow() const;
};

} // namespace steadyhand
