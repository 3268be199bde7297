#pragma once

#include "frame_listener.h"
#include "hand_tracker.h"
#include "lsl_library.h"

#include <godot_cpp/classes/node.hpp>

namespace godot {

/// Sends the frames of a HandTracker and events to the Lab Streaming Layer, if liblsl is installed.
class LslOutlet : public Node, public FrameListener {
	GDCLASS(LslOutlet, Node)

public:
	~LslOutlet() override;

	void set_tracker(HandTracker *p_tracker);
	HandTracker *get_tracker() const { return tracker_; }
	void set_stream_name(const String &p_name);
	String get_stream_name() const { return stream_name_; }
	void set_source_id(const String &p_id);
	String get_source_id() const { return source_id_; }

	bool is_active() const { return frames_ != nullptr; }
	void push_event(const String &p_text);

	void on_stream_started() override {}
	void on_stream_ended() override {}
	void on_frame(const steadyhand::HandFrame &p_frame) override;
	void on_time_advanced(double) override {}
	void on_tracker_freed() override;

	PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	HandTracker *tracker_ = nullptr;
	String stream_name_ = "SteadyHand";
	String source_id_;
	const steadyhand::LslLibrary *lsl_ = nullptr; ///< null if it is not active
	steadyhand::LslLibrary::Outlet frames_ = nullptr;
	steadyhand::LslLibrary::Outlet events_ = nullptr;
	bool is_failure_reported_ = false;

	void open();
	void close();
	/// Called after a change of a property.
	void reopen();
	void report_failure(const String &p_what);
};

} // namespace godot
