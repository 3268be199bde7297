#pragma once

#include "frame_listener.h"
#include "hand_tracker.h"

#include "metrics/tracker_alignment.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <optional>

namespace godot {

/// The core's TrackerAlignment as a node: collects one joint of two HandTrackers and aligns the second with
/// the first.
class TrackerAlignment : public Node {
	GDCLASS(TrackerAlignment, Node)

public:
	TrackerAlignment();
	~TrackerAlignment() override;

	void set_reference(HandTracker *p_tracker);
	HandTracker *get_reference() const { return reference_.tracker; }
	void set_tracker(HandTracker *p_tracker);
	HandTracker *get_tracker() const { return other_.tracker; }
	void set_joint(HandTracker::Joint p_joint);
	HandTracker::Joint get_joint() const { return joint_; }

	/// Drops all samples and results.
	Error start();
	/// Keeps the samples.
	void stop() { running_ = false; }
	bool is_running() const { return running_; }
	double get_duration() const { return samples_.followed_s(); }

	Error solve();
	Error apply();

	/// NaN before solve() has succeeded; both residuals too.
	double get_lag() const;
	Transform3D get_transform() const;
	double get_residual() const;
	double get_residual_max() const;
	int64_t get_sample_count() const;
	/// Error of the last start(), solve() or apply(); empty after success.
	String get_error_message() const { return error_message_; }

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();

private:
	/// Listens to one of the two trackers.
	class Side final : public FrameListener {
	public:
		using Push = bool (steadyhand::TrackerAlignment::*)(double, const Eigen::Vector3d &);

		Side(TrackerAlignment &p_owner, Push p_push) : owner_(p_owner), push_(p_push) {}

		void on_stream_started() override { owner_.samples_.clear(); }
		void on_stream_ended() override {}
		void on_frame(const steadyhand::HandFrame &p_frame) override { owner_.collect(push_, p_frame); }
		void on_time_advanced(double) override {}
		void on_tracker_freed() override;

		HandTracker *tracker = nullptr;

	private:
		TrackerAlignment &owner_;
		Push push_;
	};

	Side reference_, other_;
	HandTracker::Joint joint_ = HandTracker::JOINT_INDEX;
	bool running_ = false;
	steadyhand::TrackerAlignment samples_;
	std::optional<steadyhand::TrackerAlignment::Alignment> result_;
	bool is_applied_ = false;
	Transform3D device_transform_; ///< of the tracker's source at the time of result_
	String error_message_;

	void listen(Side &p_side, HandTracker *p_tracker);
	void collect(Side::Push p_push, const steadyhand::HandFrame &p_frame);
	/// Stops, and drops all samples and results.
	void reset();
	Error fail(Error p_error, const String &p_message);
};

} // namespace godot
