#pragma once

#include "tracking/frame.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

namespace steadyhand::bench {

/// Position of a HandPoint, and radius of the circle through thumb, index and middle fingertip, m.
using HandPose = Eigen::Vector4d;

/// The point whose position a pose has.
enum class HandPoint { INDEX_TIP, CIRCLE_CENTRE };

inline double radians(double degrees) {
	return degrees * std::numbers::pi / 180.0;
}

/// Minimum-jerk curve from 0 to 1 over 0..1 (Flash and Hogan 1985). Independent of the core's function.
inline double minimum_jerk(double time) {
	return time * time * time * (10.0 - 15.0 * time + 6.0 * time * time);
}

/// Plan of a hand's motion: minimum-jerk strokes between poses, and rests.
class HandPlan {
public:
	explicit HandPlan(const HandPose &start, HandPoint point = HandPoint::INDEX_TIP) :
			start_(start), pose_(start), point_(point) {}

	void rest(double duration_s) { end_s_ += duration_s; }
	void go(const HandPose &to, double duration_s) {
		strokes_.push_back({ end_s_, duration_s, pose_, to });
		pose_ = to;
		end_s_ += duration_s;
	}
	void hide(double from_s, double to_s) { hidden_s_.emplace_back(from_s, to_s); }
	/// Adds sway(t_s) to every pose.
	void sway(std::function<HandPose(double t_s)> sway) { sway_ = std::move(sway); }
	/// Sets the motion of the tracker's frame.
	void move_frame(std::function<Eigen::Vector3d(double t_s)> frame) { frame_m_ = std::move(frame); }

	/// End of the plan so far.
	[[nodiscard]] double end_s() const { return end_s_; }
	[[nodiscard]] const HandPose &pose() const { return pose_; }

	[[nodiscard]] HandPose pose_at(double t_s) const {
		HandPose pose = start_;
		for (const Stroke &stroke : strokes_) {
			if (t_s < stroke.from_s) {
				break;
			}
			const double time = std::min(1.0, (t_s - stroke.from_s) / stroke.duration_s);
			pose = stroke.from + minimum_jerk(time) * (stroke.to - stroke.from);
		}
		return sway_ ? HandPose(pose + sway_(t_s)) : pose;
	}
	[[nodiscard]] Eigen::Vector3d frame_at_m(double t_s) const {
		return frame_m_ ? frame_m_(t_s) : Eigen::Vector3d(Eigen::Vector3d::Zero());
	}
	[[nodiscard]] bool is_seen(double t_s) const {
		return std::ranges::none_of(
				hidden_s_, [t_s](const auto &hidden) { return t_s >= hidden.first && t_s < hidden.second; });
	}
	[[nodiscard]] HandFrame show(const HandPose &pose) const {
		const auto on_circle = [radius_m = pose(3)](double degrees) {
			const double angle = radians(degrees);
			return Eigen::Vector3d(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0);
		};
		constexpr double THUMB = 230.0, INDEX = 75.0, MIDDLE = 115.0;
		Eigen::Vector3d centre_m = pose.head<3>();
		if (point_ == HandPoint::INDEX_TIP) {
			centre_m -= on_circle(INDEX);
		}
		HandFrame frame;
		frame.set(Joint::THUMB, centre_m + on_circle(THUMB));
		frame.set(Joint::INDEX, centre_m + on_circle(INDEX));
		frame.set(Joint::MIDDLE, centre_m + on_circle(MIDDLE));
		frame.set(Joint::PALM, centre_m + Eigen::Vector3d(0.0, -0.06, 0.05));
		return frame;
	}

private:
	struct Stroke {
		double from_s, duration_s;
		HandPose from, to;
	};

	HandPose start_, pose_;
	HandPoint point_;
	double end_s_ = 0.0;
	std::vector<Stroke> strokes_;
	std::vector<std::pair<double, double>> hidden_s_; ///< from, to
	std::function<HandPose(double)> sway_;
	std::function<Eigen::Vector3d(double)> frame_m_;
};

} // namespace steadyhand::bench
