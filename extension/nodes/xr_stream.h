#pragma once

#include "body_space.h"
#include "hand_stream.h"
#include "xr_source.h"

#include <godot_cpp/classes/xr_hand_tracker.hpp>

#include <limits>
#include <optional>

namespace godot {

/// Samples an XRHandTracker once a game frame, which is how often the XRServer updates its joints. The engine
/// gives no capture time, so a frame is stamped with live_time_s().
class XRStream : public HandStream {
public:
	explicit XRStream(const Ref<XRSource> &p_source) : source_(p_source) {}

	String open() override { return String(); }
	StreamClock clock() const override { return StreamClock::LIVE; }
	void poll(double p_now_s) override;
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override;
	Eigen::Affine3d tracking_to_frames() const override { return tracking_to_frames_; }

private:
	/// Searches by name each time, because an interface may register, replace and remove trackers at any
	/// time.
	Ref<XRHandTracker> find_hand();
	void report_search(const Ref<XRHandTracker> &p_hand, double p_now_s);
	/// Tracked and inferred joints, in the tracking space.
	steadyhand::HandSkeleton read_joints(XRHandTracker &p_hand) const;
	/// Whether the runtime repeats a pose with equal bits, which a real hand never does.
	bool is_frozen(const steadyhand::HandSkeleton &p_joints, double p_now_s);
	/// Whether the palm has jumped to the other hand: the runtime has swapped the hands.
	bool is_other_hand(const steadyhand::HandSkeleton &p_joints, double p_now_s);
	void to_space(steadyhand::HandSkeleton &r_joints, double p_now_s);

	Ref<XRSource> source_;
	std::optional<steadyhand::DeviceFrame> sampled_;
	std::optional<double> polled_s_;
	std::optional<double> searched_from_s_; ///< set while there is no hand tracker
	bool is_found_ = false;
	bool is_missing_reported_ = false;
	bool is_class_reported_ = false;
	steadyhand::HandSkeleton last_;
	double moved_s_ = -std::numeric_limits<double>::infinity();
	/// Palms in the tracking space, m, and the last time at which the own palm was accepted.
	Eigen::Vector3d own_palm_m_ = Eigen::Vector3d::Zero();
	double own_palm_s_ = -std::numeric_limits<double>::infinity();
	std::optional<Eigen::Vector3d> other_palm_m_;
	BodySpace body_;
	Eigen::Affine3d tracking_to_frames_ = Eigen::Affine3d::Identity(); ///< at the last poll
};

} // namespace godot
