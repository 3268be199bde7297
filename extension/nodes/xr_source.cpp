#include "xr_source.h"

#include "conversions.h"
#include "node_label.h"
#include "xr_stream.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

std::unique_ptr<HandStream> XRSource::make_stream(HandTracker &) {
	return std::make_unique<XRStream>(Ref<XRSource>(this));
}

StringName XRSource::name_of_hand() const {
	if (tracker_name_ != StringName()) {
		return tracker_name_;
	}
	return hand_ == HandTracker::HAND_LEFT ? "/user/hand_tracker/left" : "/user/hand_tracker/right";
}

StringName XRSource::name_of_other_hand() const {
	return hand_ == HandTracker::HAND_LEFT ? "/user/hand_tracker/right" : "/user/hand_tracker/left";
}

void XRSource::set_hand(HandTracker::Hand p_hand) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_hand, HandTracker::HAND_RIGHT),
			refusal("XRSource", "hand must be HAND_LEFT or HAND_RIGHT", p_hand));
	hand_ = p_hand;
	emit_changed();
}

void XRSource::set_tracker_name(const StringName &p_name) {
	tracker_name_ = p_name;
	emit_changed();
}

void XRSource::set_space(Space p_space) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_space, SPACE_BODY),
			refusal("XRSource", "space must be one of SPACE_*", p_space));
	space_ = p_space;
	emit_changed();
}

String XRSource::no_frame_advice() const {
	return "Raise the hand into the view of the headset, and lay the controllers aside";
}

void XRSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_hand", "hand"), &XRSource::set_hand);
	ClassDB::bind_method(D_METHOD("get_hand"), &XRSource::get_hand);
	ClassDB::bind_method(D_METHOD("set_tracker_name", "name"), &XRSource::set_tracker_name);
	ClassDB::bind_method(D_METHOD("get_tracker_name"), &XRSource::get_tracker_name);
	ClassDB::bind_method(D_METHOD("set_space", "space"), &XRSource::set_space);
	ClassDB::bind_method(D_METHOD("get_space"), &XRSource::get_space);
	ClassDB::bind_method(D_METHOD("set_use_inferred", "use"), &XRSource::set_use_inferred);
	ClassDB::bind_method(D_METHOD("get_use_inferred"), &XRSource::get_use_inferred);

	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "hand", PROPERTY_HINT_ENUM, "Left,Right"), "set_hand", "get_hand");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "space", PROPERTY_HINT_ENUM, "World,Origin,Body"), "set_space",
			"get_space");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "use_inferred"), "set_use_inferred", "get_use_inferred");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "tracker_name"), "set_tracker_name", "get_tracker_name");

	BIND_ENUM_CONSTANT(SPACE_WORLD);
	BIND_ENUM_CONSTANT(SPACE_ORIGIN);
	BIND_ENUM_CONSTANT(SPACE_BODY);
}

} // namespace godot
