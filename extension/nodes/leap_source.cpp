#include "leap_source.h"

#include "conversions.h"
#include "leap_stream.h"
#include "node_label.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

std::unique_ptr<HandStream> LeapSource::make_stream(HandTracker &) {
	return std::make_unique<LeapStream>(Ref<LeapSource>(this));
}

void LeapSource::set_hand(HandTracker::Hand p_hand) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_hand, HandTracker::HAND_RIGHT),
			refusal("LeapSource", "hand must be HAND_LEFT or HAND_RIGHT", p_hand));
	hand_ = p_hand;
	emit_changed();
}

void LeapSource::set_mounting(Mounting p_mounting) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_mounting, MOUNTING_SCREENTOP),
			refusal("LeapSource", "mounting must be one of MOUNTING_*", p_mounting));
	mounting_ = p_mounting;
	emit_changed();
}

void LeapSource::set_device_transform(const Transform3D &p_transform) {
	ERR_FAIL_COND_MSG(!p_transform.origin.is_finite() || !(p_transform.basis.determinant() > 0),
			refusal("LeapSource", "device_transform must be finite, without a scale of 0 or a mirror",
					p_transform));
	device_transform_ = p_transform;
	emit_changed();
}

void LeapSource::set_address(const String &p_address) {
	address_ = p_address.strip_edges();
	emit_changed();
}

void LeapSource::set_port(int64_t p_port) {
	ERR_FAIL_COND_MSG(p_port < 1 || p_port > 65535, refusal("LeapSource", "port must be 1..65535", p_port));
	port_ = p_port;
	emit_changed();
}

String LeapSource::no_frame_advice() const {
	return "Hold the hand 10 to 40 cm in front of the Leap device";
}

void LeapSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_hand", "hand"), &LeapSource::set_hand);
	ClassDB::bind_method(D_METHOD("get_hand"), &LeapSource::get_hand);
	ClassDB::bind_method(D_METHOD("set_mounting", "mounting"), &LeapSource::set_mounting);
	ClassDB::bind_method(D_METHOD("get_mounting"), &LeapSource::get_mounting);
	ClassDB::bind_method(D_METHOD("set_device_transform", "transform"), &LeapSource::set_device_transform);
	ClassDB::bind_method(D_METHOD("get_device_transform"), &LeapSource::get_device_transform);
	ClassDB::bind_method(D_METHOD("set_address", "address"), &LeapSource::set_address);
	ClassDB::bind_method(D_METHOD("get_address"), &LeapSource::get_address);
	ClassDB::bind_method(D_METHOD("set_port", "port"), &LeapSource::set_port);
	ClassDB::bind_method(D_METHOD("get_port"), &LeapSource::get_port);

	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "hand", PROPERTY_HINT_ENUM, "Left,Right"), "set_hand", "get_hand");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "mounting", PROPERTY_HINT_ENUM, "Desktop,HMD,Screentop"),
			"set_mounting", "get_mounting");
	ADD_PROPERTY(PropertyInfo(Variant::TRANSFORM3D, "device_transform", PROPERTY_HINT_NONE, "suffix:m"),
			"set_device_transform", "get_device_transform");
	ADD_GROUP("Service", "");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "address"), "set_address", "get_address");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "port", PROPERTY_HINT_RANGE, "1,65535,1"), "set_port", "get_port");

	BIND_ENUM_CONSTANT(MOUNTING_DESKTOP);
	BIND_ENUM_CONSTANT(MOUNTING_HMD);
	BIND_ENUM_CONSTANT(MOUNTING_SCREENTOP);
}

} // namespace godot
