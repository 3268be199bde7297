#pragma once

#include "base/random.h"
#include "simulation/drift.h"
#include "simulation/sensor_profile.h"
#include "simulation/true_motion.h"
#include "tracking/frame.h"
#include "tracking/track.h"

#include <cstdint>
#include <vector>

namespace steadyhand {

/// A simulated tracker. Its frames are at irregular times, stamped in the time of the true motion: with a
/// lag, a frame has an earlier position. The reported confidence does not depend on the error, as with real
/// trackers.
class SimulatedSensor {
public:
	SimulatedSensor(const SensorProfile &profile, std::uint64_t seed);

	/// The next frame that the tracker delivers. Time stamps increase without limit. A dropout has frames
	/// without joints, or no frames, at random.
	[[nodiscard]] HandFrame next(const TrueMotion &motion);

private:
	/// One kind of fault. candidate_s: next possible time; until_s: end of the last one.
	struct Fault {
		double per_s = 0.0;
		double min_s = 0.0;
		double max_s = 0.0;
		double candidate_s = 0.0;
		double until_s = 0.0;
	};

	void advance_clock();
	/// True if the fault begins in this frame.
	bool begins(Fault &r_fault, double severity);
	void draw_drift(double dt_s);
	[[nodiscard]] HandFrame distorted(HandFrame frame, double severity);

	SensorProfile profile_;
	Random random_;
	double period_s_;
	double t_s_;
	double dt_s_ = 0.0;
	double lag_target_s_;
	double lag_growth_s_;
	double lag_s_;
	double content_t_s_;
	std::vector<Drift> drifts_; ///< three axes of the whole hand, then three of each joint
	std::vector<double> drift_values_;
	Drift confidence_;
	Fault freeze_;
	Fault dropout_;
	Fault jump_;
	int jump_frames_left_ = 0;
	Eigen::Vector3d jump_m_ = Eigen::Vector3d::Zero();
	bool dropout_is_silent_ = false;
	HandFrame last_; ///< is repeated by a freeze
	bool has_last_ = false;
};

/// All frames of a tracker from 0 to the motion's end.
[[nodiscard]] Track record_track(const TrueMotion &motion, const SensorProfile &profile, std::uint64_t seed);

} // namespace steadyhand
