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

/// A tracker that watches a hand, frame by frame on its own irregular clock. Frames are stamped on the clock
/// of the true motion: a lag shows as content that comes late. Confidence, where it is reported, tells
/// nothing of the error, as with the real ones.
class SimulatedSensor {
public:
	SimulatedSensor(const SensorProfile &profile, std::uint64_t seed);

	/// The next frame that the tracker delivers; stamps increase for ever. A dropout shows as frames without
	/// joints or as no frames, as chance has it.
	[[nodiscard]] HandFrame next(const TrueMotion &motion);

private:
	/// One kind of fault: when it may come next and until when it lasts.
	struct Fault {
		double per_s = 0.0;
		double min_s = 0.0;
		double max_s = 0.0;
		double candidate_s = 0.0;
		double until_s = 0.0;
	};

	void advance_clock();
	/// True in the frame in which the fault begins.
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
	HandFrame last_; ///< what a frozen tracker repeats
	bool has_last_ = false;
};

/// Everything a tracker delivers from 0 to the motion's end.
[[nodiscard]] Track record_track(const TrueMotion &motion, const SensorProfile &profile, std::uint64_t seed);

} // namespace steadyhand
