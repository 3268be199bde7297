#include "liberty_source.h"

#include "conversions.h"
#include "device_queue.h"
#include "geometry_conversions.h"
#include "liberty_device.h"
#include "liberty_usb.h"
#include "live_clock.h"
#include "node_label.h"

#include "devices/device_clock.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

namespace godot {

namespace {

using steadyhand::LibertyEvent;

/// Collects the records of all stations of one measuring cycle into a frame.
class LibertyStream : public HandStream {
public:
	explicit LibertyStream(const Ref<LibertySource> &p_source) : source_(p_source) {}

	String open() override {
		const steadyhand::LibertySettings settings = source_->core();
		if (const auto fault = steadyhand::check(settings)) {
			return to_godot(fault->message);
		}
		device_.start(settings);
		return String();
	}
	StreamClock clock() const override { return StreamClock::LIVE; }
	double latency_s() const override { return LATENCY_S; }
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override {
		return queue_.next(p_until_s, r_frame);
	}
	double complete_until_s(double p_now_s) const override { return queue_.complete_until_s(p_now_s); }

	void poll(double p_now_s) override {
		const double live_from_steady_s = p_now_s - steadyhand::steady_now_s();
		LibertyEvent event;
		while (device_.next(event)) {
			switch (event.kind) {
				case LibertyEvent::Kind::CONNECTED:
					clock_.clear();
					announce(StreamEvent::Kind::READY);
					break;
				case LibertyEvent::Kind::RECORD:
					add(event, live_from_steady_s);
					break;
				case LibertyEvent::Kind::WARNING:
				case LibertyEvent::Kind::NOTE:
					announce(StreamEvent::Kind::WARNING, to_godot(event.text));
					break;
				case LibertyEvent::Kind::FAILURE:
					announce(StreamEvent::Kind::FAILED, to_godot(event.text));
					break;
			}
		}
		flush();
	}

private:
	/// By the manual, from the middle of a measurement to its record.
	static constexpr double LATENCY_S = 0.0035;

	/// The tracker reports levels 0 to 2.
	static constexpr int STRONG_DISTORTION = 2;

	void add(const LibertyEvent &p_event, double p_live_from_steady_s) {
		if (p_event.device_time_s != cycle_.device_time_s) {
			flush();
			cycle_.skeleton.clear();
			cycle_.device_time_s = p_event.device_time_s;
			cycle_.host_time_s = host_time_s();
			cycle_.hand.t_s =
					clock_.map(p_event.device_time_s, p_event.host_time_s + p_live_from_steady_s).host_s;
			has_cycle_ = true;
		}
		if (p_event.record.distortion >= STRONG_DISTORTION && !is_distortion_reported_) {
			is_distortion_reported_ = true;
			announce(StreamEvent::Kind::WARNING,
					String("Liberty: the field at station ") + itos(p_event.record.station) +
							String(" is strongly distorted. Move metal away from sensors and source"));
		}
		const auto station = static_cast<int64_t>(p_event.record.station) - 1;
		const PackedInt32Array joints = source_->get_joints();
		if (station >= joints.size() || joints[station] < 0 || !p_event.record.is_tracked) {
			return;
		}
		const auto joint = static_cast<std::size_t>(joints[station]);
		cycle_.skeleton.set(static_cast<steadyhand::SkeletonJoint>(joint), p_event.record.position_m);
		cycle_.skeleton.rotations[joint] = p_event.record.rotation;
		cycle_.skeleton.rotated |= 1U << joint;
	}

	/// Called when the next cycle begins, or no data is left.
	void flush() {
		if (!has_cycle_) {
			return;
		}
		has_cycle_ = false;
		move_joints(cycle_.skeleton, to_core(source_->get_device_transform()));
		cycle_.hand = steadyhand::hand_frame_of(cycle_.skeleton, cycle_.hand.t_s);
		queue_.push(cycle_);
	}

	Ref<LibertySource> source_;
	steadyhand::LibertyDevice device_;
	steadyhand::DeviceClock clock_;
	steadyhand::DeviceFrame cycle_;
	bool has_cycle_ = false;
	bool is_distortion_reported_ = false;
	DeviceQueue queue_;
};

} // namespace

std::unique_ptr<HandStream> LibertySource::make_stream(HandTracker &) {
	return std::make_unique<LibertyStream>(Ref<LibertySource>(this));
}

steadyhand::LibertySettings LibertySource::core() const {
	steadyhand::LibertySettings settings;
	settings.rate_hz = static_cast<int>(rate_);
	// The source frame: x forward, y right, z down.
	settings.hemisphere = { -static_cast<double>(hemisphere_.z), static_cast<double>(hemisphere_.x),
		-static_cast<double>(hemisphere_.y) };
	return settings;
}

void LibertySource::set_joints(const PackedInt32Array &p_joints) {
	for (int64_t i = 0; i < p_joints.size(); ++i) {
		const int joint = p_joints[i];
		ERR_FAIL_COND_MSG(joint < -1 || joint >= static_cast<int>(steadyhand::SKELETON_JOINT_COUNT),
				refusal("LibertySource",
						String("joint of station ") + itos(i + 1) +
								String(" must be HandTracker.JOINT_*, or -1 for a station without a sensor"),
						joint));
	}
	joints_ = p_joints;
	emit_changed();
}

void LibertySource::set_rate(Rate p_rate) {
	ERR_FAIL_COND_MSG(p_rate != RATE_120_HZ && p_rate != RATE_240_HZ,
			refusal("LibertySource", "rate must be RATE_120_HZ or RATE_240_HZ", p_rate));
	rate_ = p_rate;
	emit_changed();
}

void LibertySource::set_hemisphere(const Vector3 &p_hemisphere) {
	ERR_FAIL_COND_MSG(
			!p_hemisphere.is_finite(), refusal("LibertySource", "hemisphere must be finite", p_hemisphere));
	hemisphere_ = p_hemisphere;
	emit_changed();
}

void LibertySource::set_device_transform(const Transform3D &p_transform) {
	ERR_FAIL_COND_MSG(!p_transform.origin.is_finite() || !(p_transform.basis.determinant() > 0),
			refusal("LibertySource", "device_transform must be finite, without a scale of 0 or a mirror",
					p_transform));
	device_transform_ = p_transform;
	emit_changed();
}

String LibertySource::no_frame_advice() const {
	return "Plug a sensor into station 1, and set \"joints\" of the LibertySource to the joint that wears it";
}

void LibertySource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_joints", "joints"), &LibertySource::set_joints);
	ClassDB::bind_method(D_METHOD("get_joints"), &LibertySource::get_joints);
	ClassDB::bind_method(D_METHOD("set_rate", "rate"), &LibertySource::set_rate);
	ClassDB::bind_method(D_METHOD("get_rate"), &LibertySource::get_rate);
	ClassDB::bind_method(D_METHOD("set_hemisphere", "hemisphere"), &LibertySource::set_hemisphere);
	ClassDB::bind_method(D_METHOD("get_hemisphere"), &LibertySource::get_hemisphere);
	ClassDB::bind_method(D_METHOD("set_device_transform", "transform"), &LibertySource::set_device_transform);
	ClassDB::bind_method(D_METHOD("get_device_transform"), &LibertySource::get_device_transform);

	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "joints"), "set_joints", "get_joints");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "rate", PROPERTY_HINT_ENUM, "120 Hz:120,240 Hz:240"), "set_rate",
			"get_rate");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "hemisphere"), "set_hemisphere", "get_hemisphere");
	ADD_PROPERTY(PropertyInfo(Variant::TRANSFORM3D, "device_transform", PROPERTY_HINT_NONE, "suffix:m"),
			"set_device_transform", "get_device_transform");

	BIND_ENUM_CONSTANT(RATE_120_HZ);
	BIND_ENUM_CONSTANT(RATE_240_HZ);
}

} // namespace godot
