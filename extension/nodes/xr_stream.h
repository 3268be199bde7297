#pragma once

#include "body_space.h"
#include "hand_stream.h"
#include "xr_source.h"

#include <godot_cpp/classes/xr_hand_tracker.hpp>

#include <limits>
#include <optional>

namespace godot {

/// Samples an XRHandTracker once a frame of the game, the rate at which the XRServer moves its joints on.
/// The engine gives no time of capture: a frame is stamped with the game's live time.
class XRStream : public HandStream {
public:
	explicit XRStream(const Ref<XRSource> &p_source) : source_(p_source) {}

	String open() override { return String(); }
	StreamClock clock() const override { return StreamClock::LIVE; }
	void poll(double p_now_s) override;
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override;

private:
	/// The name is looked up each time: an interface registers, replaces and removes trackers at any time.
	Ref<XRHandTracker> find_hand();
	void watch_for_hand(const Ref<XRHandTracker> &p_hand, double p_now_s);
	/// Joints that are tracked, or that the runtime infers, in the tracking space.
	steadyhand::HandSkeleton read_joints(XRHandTracker &p_hand) const;
	/// The runtime repeats a pose to the last bit, as no hand holds one.
	bool is_frozen(const steadyhand::HandSkeleton &p_joints, double p_now_s);
	/// Where the other hand was: the runtime takes one for the other.
	bool is_other_hand(const steadyhand::HandSkeleton &p_joints, double p_now_s);
	void to_space(steadyhand::HandSkeleton &r_joints, double p_now_s);

	Ref<XRSource> source_;
	std::optional<steadyhand::DeviceFrame> sampled_;
	std::optional<double> polled_s_;
	std::optional<double> searched_from_s_; ///< while there is no hand tracker
	bool is_found_ = false;
	bool is_missing_told_ = false;
	bool is_class_told_ = false;
	steadyhand::HandSkeleton last_;
	double moved_s_ = -std::numeric_limits<double>::infinity();
	/// Palms in the tracking space, m, and when they were last taken for their own hand's.
	Eigen::Vector3d own_palm_m_ = Eigen::Vector3d::Zero();
	double own_palm_s_ = -std::numeric_limits<double>::infinity();
	std::optional<Eigen::Vector3d> other_palm_m_;
	BodySpace body_;
};

} // namespace godot
