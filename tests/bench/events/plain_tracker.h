#pragma once

#include "draws.h"
#include "hand_plan.h"
#include "tracking/frame.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace steadyhand::bench {

struct TrackerTraits {
	double rate_hz = 90.0;
	double phase = 0.0;        ///< time of the first frame, in periods
	double noise_m = 0.0;      ///< standard deviation of white noise for each coordinate
	double lag_s = 0.0;        ///< latency that the stamps do not include
	double error_m = 0.0;      ///< standard deviation of drift for each coordinate
	double error_time_s = 0.7; ///< time constant of the drift
	double faults_per_s = 0.0; ///< rate of each: dropouts, freezes and jumps
};

enum class TrackerKind { GOOD, NOISY, BAD };

inline TrackerTraits tracker_traits(TrackerKind kind, std::uint64_t seed) {
	Draws draws(101 * seed + 3);
	TrackerTraits traits;
	traits.phase = draws.between(0.0, 1.0);
	const bool is_bad = kind == TrackerKind::BAD;
	traits.rate_hz = std::array{ 60.0, 90.0, is_bad ? 110.0 : 120.0 }[draws.below(3)];
	if (is_bad) {
		traits.noise_m = 0.0005;
		traits.lag_s = draws.between(0.04, 0.09);
		traits.error_m = draws.between(0.01, 0.02) / std::sqrt(3.0);
		traits.faults_per_s = 0.12;
	} else {
		traits.noise_m = kind == TrackerKind::GOOD ? 0.0001 : 0.001;
	}
	return traits;
}

/// A simulated tracker with white noise, latency, drift, dropouts, freezes and jumps.
class PlainTracker {
public:
	PlainTracker(const TrackerTraits &traits, std::uint64_t seed) :
			traits_(traits), draws_(seed ^ 0x5eed), drift_m_(traits.error_m * draws_.normals()),
			error_m_(drift_m_) {}

	/// Frames of a hand. Call it once.
	[[nodiscard]] std::vector<HandFrame> watch(const HandPlan &hand) {
		std::vector<HandFrame> frames;
		for (int i = 0;; ++i) {
			const double t_s = (i + traits_.phase) / traits_.rate_hz;
			if (t_s > hand.end_s()) {
				return frames;
			}
			drift();
			begin_faults(t_s);
			if (hand.is_seen(t_s - traits_.lag_s) && t_s >= gap_to_s_) {
				if (t_s >= freeze_to_s_ || !shown_) {
					shown_ = look(hand, t_s);
				}
				frames.push_back(*shown_);
				frames.back().t_s = t_s;
			}
		}
	}

private:
	static constexpr double RADIUS_SHARE = 0.12; ///< drift of the radius, as a fraction of the position's
	static constexpr double SMOOTHING_S = 0.06;
	static constexpr double LEAST_RADIUS_M = 0.006;

	TrackerTraits traits_;
	Draws draws_;
	Eigen::Vector3d drift_m_;
	double radius_drift_m_ = 0.0;
	Eigen::Vector3d error_m_; ///< smoothed drift
	double radius_error_m_ = 0.0;
	double gap_to_s_ = -1.0, freeze_to_s_ = -1.0, jump_to_s_ = -1.0;
	Eigen::Vector3d jump_m_ = Eigen::Vector3d::Zero();
	double radius_jump_m_ = 0.0;
	std::optional<HandFrame> shown_;

	void drift() {
		if (traits_.error_m <= 0.0) {
			return;
		}
		const double kept = std::exp(-1.0 / (traits_.rate_hz * traits_.error_time_s));
		const double step_m = traits_.error_m * std::sqrt(1.0 - kept * kept);
		drift_m_ = kept * drift_m_ + step_m * draws_.normals();
		radius_drift_m_ = kept * radius_drift_m_ + RADIUS_SHARE * step_m * draws_.normal();
		const double followed = 1.0 - std::exp(-1.0 / (traits_.rate_hz * SMOOTHING_S));
		error_m_ += followed * (drift_m_ - error_m_);
		radius_error_m_ += followed * (radius_drift_m_ - radius_error_m_);
	}

	bool begins(double t_s, double last_to_s) {
		return t_s > last_to_s && draws_.between(0.0, 1.0) < traits_.faults_per_s / traits_.rate_hz;
	}

	void begin_faults(double t_s) {
		if (traits_.faults_per_s <= 0.0) {
			return;
		}
		if (begins(t_s, gap_to_s_)) {
			gap_to_s_ = t_s + draws_.between(0.1, 0.3);
		}
		if (begins(t_s, freeze_to_s_)) {
			freeze_to_s_ = t_s + draws_.between(0.1, 0.3);
		}
		if (begins(t_s, jump_to_s_)) {
			jump_to_s_ = t_s + draws_.between(0.05, 0.3);
			const double length_m = draws_.between(0.03, 0.06);
			jump_m_ = length_m * draws_.unit_vector();
			radius_jump_m_ = draws_.between(-0.008, 0.008);
		}
	}

	HandFrame look(const HandPlan &hand, double t_s) {
		const double seen_s = t_s - traits_.lag_s;
		const bool jumps = t_s < jump_to_s_;
		HandPose pose = hand.pose_at(seen_s);
		pose.head<3>() += error_m_ + (jumps ? 1.0 : 0.0) * jump_m_;
		pose(3) = std::max(LEAST_RADIUS_M, pose(3) + radius_error_m_ + (jumps ? radius_jump_m_ : 0.0));
		HandFrame frame = hand.show(pose);
		for (Eigen::Vector3d &position_m : frame.positions_m) {
			position_m += hand.frame_at_m(seen_s) + traits_.noise_m * draws_.normals();
		}
		return frame;
	}
};

} // namespace steadyhand::bench
