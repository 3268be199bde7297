#pragma once

#include "base/parameters.h"
#include "signal/ring.h"
#include "tracking/hand_track.h"
#include "tracking/measurement.h"
#include "tracking/reading_noise.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace steadyhand {

/// Judges the tracker of one point by its readings, in metres and seconds. Trackers report little about their
/// own faults. Measures period and noise; finds dropouts, freezes and jumps. Does not allocate.
class TrackerMonitor {
public:
	/// Adds a frame in which the point is tracked. position_m is finite. A stamp before the last one starts
	/// over: the clock was set back.
	Measurement push(double t_s, const Eigen::Vector3d &position_m);

	/// Whether no frame has come for so long that it is a dropout.
	[[nodiscard]] bool is_overdue(double t_s) const { return has_frame_ && t_s - frame_s_ > overdue_s(); }
	/// Median interval of new readings; parameters::tracker::UNKNOWN_PERIOD_S before the second one.
	[[nodiscard]] double period_s() const { return period_s_; }
	[[nodiscard]] bool is_period_known() const { return !intervals_s_.empty(); }
	/// Standard deviation of white noise for each axis: root mean square of the three.
	[[nodiscard]] double noise_m() const;
	[[nodiscard]] bool is_noise_known() const { return noise_.is_measured(); }
	[[nodiscard]] const TrackerFaults &faults() const { return faults_; }

private:
	/// A jump of the tracked position.
	struct Jump {
		double since_s = 0.0;
		double gap_s = 0.0;                                     ///< Measurement::gap_s before the jump
		bool is_catch_up = false;                               ///< the hand made the jump, untracked
		Eigen::Vector3d from_m = Eigen::Vector3d::Zero();       ///< predicted position of the hand
		Eigen::Vector3d hand_m_s = Eigen::Vector3d::Zero();     ///< predicted velocity of the hand
		Eigen::Vector3d way_m = Eigen::Vector3d::Zero();        ///< from the predicted position
		Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero(); ///< velocity of a hand that makes the jump
		HandTrack track;                                        ///< of the readings since the jump
		int readings = 1;

		[[nodiscard]] Eigen::Vector3d displacement_m() const {
			return is_catch_up ? Eigen::Vector3d(0.0, 0.0, 0.0) : way_m;
		}
	};

	bool has_frame_ = false;
	double frame_s_ = 0.0; ///< stamp of the newest frame
	double new_s_ = 0.0;   ///< stamp of the newest reading that is no repetition
	Eigen::Vector3d position_m_ = Eigen::Vector3d::Zero();
	double kept_s_ = 0.0;        ///< stamp of the first reading of the newest burst, or of the newest reading
	bool is_in_burst_ = false;   ///< the newest frame is a later one of a burst
	bool is_burst_used_ = false; ///< an earlier frame of the newest burst was usable
	double gap_ended_s_ = -INFINITY;   ///< time of the last frame after a missing one
	std::int64_t delayed_frames_ = 0;  ///< frames missing before the newest burst that have not arrived in it
	double period_before_gap_s_ = 0.0; ///< period_s() before the newest burst
	Ring<double, 8> intervals_s_;
	double period_s_ = parameters::tracker::UNKNOWN_PERIOD_S;
	ReadingNoise noise_;
	HandTrack hand_;
	std::optional<Jump> jump_;     ///< not yet accepted
	std::optional<Jump> accepted_; ///< the tracker may still undo it
	Eigen::Vector3d displacement_m_ = Eigen::Vector3d::Zero();
	/// Fastest velocity of the hand within the last MEMORY_S.
	Eigen::Vector3d fastest_m_s_ = Eigen::Vector3d::Zero();
	double fastest_s_ = 0.0;
	bool is_frozen_ = false;
	TrackerFaults faults_;

	[[nodiscard]] double overdue_s() const;
	[[nodiscard]] Eigen::Vector3d reading_noise_m() const;
	void restart(double t_s, const Eigen::Vector3d &position_m);
	[[nodiscard]] bool is_in_burst(double t_s) const;
	void replace_in_burst(Measurement &r_measurement);
	void repeat(Measurement &r_measurement);
	void read(Measurement &r_measurement, double frame_gap_s);
	void time(double t_s);
	void judge(Measurement &r_measurement, double dt_s);
	void judge_jumped(Measurement &r_measurement, Jump &r_jump);
	void accept_jump(const Jump &jump);
	[[nodiscard]] bool leads_to(const Eigen::Vector3d &way_m, double most_s) const;
	[[nodiscard]] bool catches_up(const Eigen::Vector3d &way_m, double t_s) const;
	[[nodiscard]] bool has_returned(const Jump &jump, const Eigen::Vector3d &position_m, double t_s) const;
};

} // namespace steadyhand
