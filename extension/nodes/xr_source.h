#pragma once

#include "hand_source.h"

namespace godot {

/// A hand that Godot tracks by OpenXR or another XR interface: an XRHandTracker of the XRServer.
class XRSource : public HandSource {
	GDCLASS(XRSource, HandSource)

public:
	enum Space : int64_t { SPACE_WORLD, SPACE_ORIGIN, SPACE_BODY };

	void set_hand(HandTracker::Hand p_hand);
	HandTracker::Hand get_hand() const { return hand_; }
	void set_tracker_name(const StringName &p_name);
	StringName get_tracker_name() const { return tracker_name_; }
	void set_space(Space p_space);
	Space get_space() const { return space_; }
	void set_use_inferred(bool p_use) { use_inferred_ = p_use; }
	bool get_use_inferred() const { return use_inferred_; }

	/// tracker_name, or OpenXR's name of the hand if that is empty.
	StringName name_of_hand() const;
	StringName name_of_other_hand() const;

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	String no_frame_advice() const override;
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();

private:
	HandTracker::Hand hand_ = HandTracker::HAND_RIGHT;
	StringName tracker_name_;
	Space space_ = SPACE_WORLD;
	bool use_inferred_ = true;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::XRSource::Space);
