#pragma once

#include "hand_source.h"

#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// A hand of a Leap Motion or Ultraleap device, by its service's WebSocket.
class LeapSource : public HandSource {
	GDCLASS(LeapSource, HandSource)

public:
	/// In the order of the core's LeapMounting.
	enum Mounting : int64_t { MOUNTING_DESKTOP, MOUNTING_HMD, MOUNTING_SCREENTOP };

	void set_hand(HandTracker::Hand p_hand);
	HandTracker::Hand get_hand() const { return hand_; }
	void set_mounting(Mounting p_mounting);
	Mounting get_mounting() const { return mounting_; }
	void set_device_transform(const Transform3D &p_transform);
	Transform3D get_device_transform() const { return device_transform_; }
	void set_address(const String &p_address);
	String get_address() const { return address_; }
	void set_port(int64_t p_port);
	int64_t get_port() const { return port_; }

	std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker) override;
	String no_frame_advice() const override;
	bool is_script() const override { return false; }

protected:
	static void _bind_methods();

private:
	HandTracker::Hand hand_ = HandTracker::HAND_RIGHT;
	Mounting mounting_ = MOUNTING_DESKTOP;
	Transform3D device_transform_;
	String address_ = "127.0.0.1";
	int64_t port_ = 6437; ///< the port of all services
};

} // namespace godot

VARIANT_ENUM_CAST(godot::LeapSource::Mounting);
