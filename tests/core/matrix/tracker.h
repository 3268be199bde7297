#pragma once

#include "base/random.h"
#include "scenario.h"
#include "signal/minimum_jerk.h"
#include "tracking/frame.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace steadyhand::matrix {

/// Shows a scenario's hand frame by frame. Its stamps are the instants of its samples, but in bursts.
class Tracker {
public:
	explicit Tracker(const Scenario &scenario) : scenario_(scenario), random_(scenario.seed) {}

	[[nodiscard]] std::vector<HandFrame> frames() {
		std::vector<HandFrame> frames;
		for (int i = 0; sample_s(i) < scenario_.record_s(); ++i) {
			HandFrame frame = look(sample_s(i));
			if (frame.t_s >= scenario_.fault_s()) {
				fail(frame, sample_s(i));
				++frames_since_fault_;
			}
			frame.t_s = stamp_s(i);
			frames.push_back(frame);
			last_ = frame;
		}
		return frames;
	}

private:
	static constexpr double SWAP_M = 0.3, JUMP_M = 0.07, DRIFT_M = 0.01, LATE_S = 0.06;
	static constexpr int SWAPPED_FRAMES = 6, JUMPED_FRAMES = 1, BURST_FRAMES = 4;
	static constexpr double BURST_SPACING_S = 1e-5;
	/// Of a period: no frame falls on an instant at which the hand's movement changes.
	static constexpr double FIRST_FRAME = 0.37;

	const Scenario &scenario_;
	Random random_;
	HandFrame last_;
	int frames_since_fault_ = 0;

	[[nodiscard]] double sample_s(int i) const { return (i + FIRST_FRAME) / scenario_.rate.hz; }
	[[nodiscard]] double stamp_s(int i) const {
		if (!scenario_.rate.in_bursts) {
			return sample_s(i);
		}
		const int in_burst = i % BURST_FRAMES;
		return sample_s(i - in_burst + BURST_FRAMES - 1) + in_burst * BURST_SPACING_S;
	}

	HandFrame look(double t_s) {
		Eigen::Vector3d error_m;
		for (double &coordinate_m : error_m) {
			coordinate_m = random_.normal(0.0, scenario_.noise.deviation_m);
		}
		return show(t_s, scenario_.hand.path.place_m(t_s) + error_m);
	}

	[[nodiscard]] HandFrame show(double t_s, const Eigen::Vector3d &tip_m) const {
		const double grid_m = scenario_.noise.rounding_m;
		HandFrame frame;
		frame.t_s = t_s;
		frame.set(Joint::INDEX,
				grid_m > 0.0 ? Eigen::Vector3d(grid_m * (tip_m / grid_m).array().round()) : tip_m);
		frame.set(Joint::PALM, frame.position(Joint::INDEX) + Eigen::Vector3d(0.0, 0.02, 0.1));
		return frame;
	}

	void displace(HandFrame &r_frame, const Eigen::Vector3d &error_m) const {
		r_frame = show(r_frame.t_s, r_frame.position(Joint::INDEX) + error_m);
	}

	/// Half along the task's way, half across it.
	[[nodiscard]] Eigen::Vector3d aslant() const {
		return (scenario_.task.axis + across(scenario_.task)).normalized();
	}

	void fail(HandFrame &r_frame, double t_s) {
		const Fault &fault = scenario_.fault;
		const double since_s = t_s - scenario_.fault_s();
		if (fault.kind == FaultKind::DRIFT) {
			return displace(r_frame, DRIFT_M * minimum_jerk(since_s / fault.length_s).value * aslant());
		}
		if (fault.kind == FaultKind::SWAP && frames_since_fault_ < SWAPPED_FRAMES) {
			return displace(r_frame, SWAP_M * across(scenario_.task));
		}
		if (fault.kind == FaultKind::JUMP && frames_since_fault_ < JUMPED_FRAMES) {
			return displace(r_frame, JUMP_M * aslant());
		}
		if (since_s >= fault.length_s) {
			return;
		}
		if (fault.kind == FaultKind::DROPOUT) {
			r_frame.tracked = 0;
		} else if (fault.kind == FaultKind::ZEROS) {
			r_frame.positions_m.fill(Eigen::Vector3d::Zero());
		} else if (fault.kind == FaultKind::FREEZE) {
			r_frame = last_;
		} else if (fault.kind == FaultKind::LATE) {
			r_frame = look(t_s - LATE_S);
		}
	}
};

[[nodiscard]] inline std::vector<HandFrame> frames_of(const Scenario &scenario) {
	return Tracker(scenario).frames();
}

} // namespace steadyhand::matrix
