#pragma once

#include "device_queue.h"
#include "hand_stream.h"
#include "leap_source.h"

#include "devices/device_clock.h"
#include "devices/leap_connection.h"
#include "devices/leap_hands.h"
#include "devices/leap_protocol.h"

#include <godot_cpp/classes/web_socket_peer.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot {

/// A connection to a Leap or Ultraleap service. Requests frames, and reconnects when the connection ends.
class LeapStream : public HandStream {
public:
	explicit LeapStream(const Ref<LeapSource> &p_source);
	~LeapStream() override;

	String open() override;
	StreamClock clock() const override { return StreamClock::LIVE; }
	void poll(double p_now_s) override;
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override {
		return queue_.next(p_until_s, r_frame);
	}
	double complete_until_s(double p_now_s) const override { return queue_.complete_until_s(p_now_s); }

private:
	void connect(double p_now_s);
	void on_closed(double p_now_s);
	void read(const PackedByteArray &p_packet, double p_now_s);
	void on_version(const steadyhand::LeapVersion &p_version);
	void on_device(const steadyhand::LeapDevice &p_device);
	void on_frame(const steadyhand::LeapFrame &p_frame, double p_now_s);
	/// Pose of the device in the scene.
	Eigen::Affine3d device_place() const;
	/// Reports one failure until the service sends again.
	void fail(const String &p_text);
	/// Topics of warnings. Each is reported once per run.
	enum class Topic : uint8_t { BINARY, INVALID, CLOCK, VERSION };
	void warn(Topic p_topic, const String &p_text);
	String url() const;

	Ref<LeapSource> source_;
	Ref<WebSocketPeer> socket_; ///< null between two attempts
	int version_ = steadyhand::LEAP_VERSION_WANTED;
	bool got_version_ = false; ///< on this connection
	int attempts_ = 0;         ///< failed attempts in a row
	double next_attempt_s_ = 0.0;
	double connected_s_ = 0.0; ///< start of this connection
	bool is_failure_reported_ = false;
	unsigned warned_ = 0; ///< bit i: Topic i
	steadyhand::DeviceClock clock_;
	steadyhand::LeapHandChooser chooser_;
	DeviceQueue queue_;
};

} // namespace godot
