#pragma once

#include "gesture/feature.h"
#include "signal/ring.h"
#include "tracking/tracker_monitor.h"

#include <cmath>
#include <cstddef>
#include <optional>

namespace steadyhand {

/// Place of a feature whose tracked point for TrackerMonitor is point_m. Of a radius, x and y are the
/// fingertips' mean, and z is the radius.
[[nodiscard]] FeaturePlace place_of(const Feature &feature, const Eigen::Vector3d &point_m);

/// Positions of a feature in the newest frames, judged by a TrackerMonitor. Only the constructor allocates.
class FeatureTrack {
public:
	explicit FeatureTrack(const Feature &feature) : feature_(&feature) {}

	/// Time stamps must not decrease.
	void push(const HandFrame &frame);

	[[nodiscard]] const Feature &feature() const { return *feature_; }
	/// As measured in the newest frame; nullopt if it has none, or the feature has no position.
	[[nodiscard]] const std::optional<FeaturePlace> &place() const { return place_; }
	/// place(), without the tracker's displacement.
	[[nodiscard]] std::optional<FeaturePlace> hand() const {
		return place_ ? std::optional<FeaturePlace>(*place_ - displacement_m_) : std::nullopt;
	}
	/// Measurement of the tracked point in the newest frame. Its time is that of the frame.
	[[nodiscard]] const Measurement &measurement() const { return measurement_; }
	[[nodiscard]] const TrackerMonitor &monitor() const { return monitor_; }
	/// Displacement of the tracker in the newest frame with a position.
	[[nodiscard]] const FeaturePlace &displacement_m() const { return displacement_m_; }
	/// Time of the last usable measurement with a position; -infinity before the first one.
	[[nodiscard]] double last_measurement_s() const { return past_.empty() ? -INFINITY : past_.newest().t_s; }
	/// Calls f(t_s, hand) for each usable measurement since t_s, of the newest PAST ones.
	template <class Function> void frames_since(double t_s, const Function &f) const {
		for (std::size_t i = 0; i < past_.size(); ++i) {
			if (past_[i].t_s >= t_s) {
				f(past_[i].t_s, past_[i].hand_m);
			}
		}
	}

private:
	static constexpr std::size_t PAST = 256;

	struct PastFrame {
		double t_s = 0.0;
		FeaturePlace hand_m = FeaturePlace::Zero();
	};

	const Feature *feature_;
	std::optional<FeaturePlace> place_;
	FeaturePlace displacement_m_ = FeaturePlace::Zero();
	TrackerMonitor monitor_;
	Measurement measurement_;
	Ring<PastFrame, PAST> past_;
};

} // namespace steadyhand
