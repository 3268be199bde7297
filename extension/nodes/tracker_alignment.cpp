#include "tracker_alignment.h"

#include "conversions.h"
#include "geometry_conversions.h"
#include "leap_source.h"
#include "liberty_source.h"
#include "listener_list.h"
#include "node_label.h"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <iterator>
#include <limits>

namespace godot {

namespace {

using Alignment = steadyhand::TrackerAlignment::Alignment;

constexpr double UNKNOWN = std::numeric_limits<double>::quiet_NaN();

/// Index of p_joint in a HandFrame; JOINT_COUNT if it has no such joint.
std::size_t frame_joint(HandTracker::Joint p_joint) {
	const auto found = std::find_if(steadyhand::SKELETON_OF.begin(), steadyhand::SKELETON_OF.end(),
			[&](steadyhand::SkeletonJoint p_one) {
				return static_cast<int64_t>(p_one) == static_cast<int64_t>(p_joint);
			});
	return static_cast<std::size_t>(std::distance(steadyhand::SKELETON_OF.begin(), found));
}

Transform3D transform_of(const Alignment &p_alignment) {
	return Transform3D(to_godot(p_alignment.rotation), to_godot(p_alignment.translation_m));
}

/// nullopt if the source has no device_transform that is fixed in space.
std::optional<Transform3D> device_transform_of(const HandTracker *p_tracker) {
	const Ref<HandSource> source = p_tracker != nullptr ? p_tracker->get_source() : Ref<HandSource>();
	if (const auto *leap = Object::cast_to<LeapSource>(source.ptr())) {
		if (leap->get_mounting() != LeapSource::MOUNTING_HMD) {
			return leap->get_device_transform();
		}
	} else if (const auto *liberty = Object::cast_to<LibertySource>(source.ptr())) {
		return liberty->get_device_transform();
	}
	return std::nullopt;
}

void set_device_transform(HandTracker &p_tracker, const Transform3D &p_transform) {
	const Ref<HandSource> source = p_tracker.get_source();
	if (auto *leap = Object::cast_to<LeapSource>(source.ptr())) {
		leap->set_device_transform(p_transform);
	} else if (auto *liberty = Object::cast_to<LibertySource>(source.ptr())) {
		liberty->set_device_transform(p_transform);
	}
}

} // namespace

TrackerAlignment::TrackerAlignment() :
		reference_(*this, &steadyhand::TrackerAlignment::push_reference),
		other_(*this, &steadyhand::TrackerAlignment::push_other) {}

TrackerAlignment::~TrackerAlignment() {
	for (Side *side : { &reference_, &other_ }) {
		listen_to(static_cast<HandTracker *>(nullptr), side->tracker, static_cast<FrameListener *>(side));
	}
}

void TrackerAlignment::Side::on_tracker_freed() {
	tracker = nullptr;
	owner_.stop();
	owner_.update_configuration_warnings();
}

void TrackerAlignment::listen(Side &p_side, HandTracker *p_tracker) {
	if (listen_to(p_tracker, p_side.tracker, static_cast<FrameListener *>(&p_side))) {
		reset();
		update_configuration_warnings();
	}
}

void TrackerAlignment::set_reference(HandTracker *p_tracker) {
	listen(reference_, p_tracker);
}

void TrackerAlignment::set_tracker(HandTracker *p_tracker) {
	listen(other_, p_tracker);
}

void TrackerAlignment::set_joint(HandTracker::Joint p_joint) {
	ERR_FAIL_COND_MSG(frame_joint(p_joint) == steadyhand::JOINT_COUNT,
			refusal(*this, "joint must be one of HandTracker.JOINT_*", p_joint));
	if (joint_ != p_joint) {
		joint_ = p_joint;
		reset();
	}
}

void TrackerAlignment::reset() {
	running_ = false;
	samples_.clear();
	result_.reset();
	is_applied_ = false;
	error_message_ = String();
}

Error TrackerAlignment::fail(Error p_error, const String &p_message) {
	error_message_ = p_message;
	return p_error;
}

void TrackerAlignment::collect(Side::Push p_push, const steadyhand::HandFrame &p_frame) {
	const std::size_t place = frame_joint(joint_);
	const bool is_measured = (p_frame.tracked & ~p_frame.inferred) >> place & 1;
	if (running_ && is_measured) {
		(samples_.*p_push)(p_frame.t_s, p_frame.positions_m[place]);
	}
}

Error TrackerAlignment::start() {
	reset();
	if (reference_.tracker == nullptr || other_.tracker == nullptr) {
		return fail(ERR_UNCONFIGURED, "set \"reference\" and \"tracker\" to two HandTrackers first");
	}
	if (reference_.tracker == other_.tracker) {
		return fail(
				ERR_UNCONFIGURED, "\"reference\" and \"tracker\" are the same node; set two HandTrackers");
	}
	running_ = true;
	return OK;
}

Error TrackerAlignment::solve() {
	result_.reset();
	is_applied_ = false;
	const steadyhand::Result<Alignment> found = samples_.align();
	if (!found) {
		return fail(ERR_INVALID_DATA, to_godot(found.error()));
	}
	result_ = found.value();
	device_transform_ = device_transform_of(other_.tracker).value_or(Transform3D());
	error_message_ = String();
	return OK;
}

Error TrackerAlignment::apply() {
	if (!result_) {
		return fail(ERR_UNCONFIGURED, "there is no result to apply; call solve() until it returns OK");
	}
	if (is_applied_) {
		return fail(
				ERR_ALREADY_EXISTS, "the result has been applied; call start() and solve() for a new one");
	}
	const std::optional<Transform3D> present = device_transform_of(other_.tracker);
	if (!present) {
		return fail(ERR_UNAVAILABLE,
				"the source of \"tracker\" has no device_transform that is fixed in space; make the tracker "
				"with a LibertySource or LeapSource (not MOUNTING_HMD) \"tracker\" and the other one "
				"\"reference\", or multiply \"transform\" with positions in a script");
	}
	if (reference_.tracker != nullptr && reference_.tracker->get_source() == other_.tracker->get_source()) {
		return fail(ERR_UNAVAILABLE,
				"both trackers use the same source, which would move both; give each a source of its own");
	}
	if (*present != device_transform_) {
		return fail(ERR_INVALID_DATA,
				"device_transform has changed since solve(); call start() and solve() again");
	}
	set_device_transform(*other_.tracker, transform_of(*result_) * *present);
	is_applied_ = true;
	samples_.clear(); // the samples are in the tracker's former space
	error_message_ = String();
	return OK;
}

double TrackerAlignment::get_lag() const {
	return result_ ? result_->lag_s : UNKNOWN;
}

Transform3D TrackerAlignment::get_transform() const {
	return result_ ? transform_of(*result_) : Transform3D();
}

double TrackerAlignment::get_residual() const {
	return result_ ? result_->residual_rms_m : UNKNOWN;
}

double TrackerAlignment::get_residual_max() const {
	return result_ ? result_->residual_max_m : UNKNOWN;
}

int64_t TrackerAlignment::get_sample_count() const {
	return result_ ? static_cast<int64_t>(result_->samples) : 0;
}

PackedStringArray TrackerAlignment::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (reference_.tracker == nullptr) {
		warnings.push_back("Set \"reference\" to the HandTracker whose space and time are right.");
	}
	if (other_.tracker == nullptr) {
		warnings.push_back("Set \"tracker\" to the HandTracker to align with the reference.");
	} else if (other_.tracker == reference_.tracker) {
		warnings.push_back("Set \"reference\" and \"tracker\" to two different HandTrackers.");
	}
	return warnings;
}

void TrackerAlignment::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_reference", "tracker"), &TrackerAlignment::set_reference);
	ClassDB::bind_method(D_METHOD("get_reference"), &TrackerAlignment::get_reference);
	ClassDB::bind_method(D_METHOD("set_tracker", "tracker"), &TrackerAlignment::set_tracker);
	ClassDB::bind_method(D_METHOD("get_tracker"), &TrackerAlignment::get_tracker);
	ClassDB::bind_method(D_METHOD("set_joint", "joint"), &TrackerAlignment::set_joint);
	ClassDB::bind_method(D_METHOD("get_joint"), &TrackerAlignment::get_joint);
	ClassDB::bind_method(D_METHOD("start"), &TrackerAlignment::start);
	ClassDB::bind_method(D_METHOD("stop"), &TrackerAlignment::stop);
	ClassDB::bind_method(D_METHOD("is_running"), &TrackerAlignment::is_running);
	ClassDB::bind_method(D_METHOD("solve"), &TrackerAlignment::solve);
	ClassDB::bind_method(D_METHOD("apply"), &TrackerAlignment::apply);
	ClassDB::bind_method(D_METHOD("get_duration"), &TrackerAlignment::get_duration);
	ClassDB::bind_method(D_METHOD("get_lag"), &TrackerAlignment::get_lag);
	ClassDB::bind_method(D_METHOD("get_transform"), &TrackerAlignment::get_transform);
	ClassDB::bind_method(D_METHOD("get_residual"), &TrackerAlignment::get_residual);
	ClassDB::bind_method(D_METHOD("get_residual_max"), &TrackerAlignment::get_residual_max);
	ClassDB::bind_method(D_METHOD("get_sample_count"), &TrackerAlignment::get_sample_count);
	ClassDB::bind_method(D_METHOD("get_error_message"), &TrackerAlignment::get_error_message);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "reference", PROPERTY_HINT_NODE_TYPE, "HandTracker"),
			"set_reference", "get_reference");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "tracker", PROPERTY_HINT_NODE_TYPE, "HandTracker"),
			"set_tracker", "get_tracker");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "joint", PROPERTY_HINT_ENUM,
						 "Palm:0,Wrist:1,Thumb:5,Index:10,Middle:15,Ring:20,Pinky:25"),
			"set_joint", "get_joint");

	constexpr uint32_t READ_ONLY = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "",
			"get_duration");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "lag", PROPERTY_HINT_NONE, "suffix:s", READ_ONLY), "", "get_lag");
	ADD_PROPERTY(PropertyInfo(Variant::TRANSFORM3D, "transform", PROPERTY_HINT_NONE, "suffix:m", READ_ONLY),
			"", "get_transform");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "residual", PROPERTY_HINT_NONE, "suffix:m", READ_ONLY), "",
			"get_residual");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "residual_max", PROPERTY_HINT_NONE, "suffix:m", READ_ONLY), "",
			"get_residual_max");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "sample_count", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_sample_count");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "error_message", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_error_message");
}

} // namespace godot
