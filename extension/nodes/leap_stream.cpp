#include "leap_stream.h"

#include "conversions.h"
#include "geometry_conversions.h"
#include "live_clock.h"

#include <godot_cpp/classes/tls_options.hpp>
#include <godot_cpp/classes/xr_pose.hpp>
#include <godot_cpp/classes/xr_positional_tracker.hpp>
#include <godot_cpp/classes/xr_server.hpp>

#include <variant>

namespace godot {

namespace {

/// A frame of two hands has 10 to 20 kB. This is half a second of frames, in case the game stalls.
constexpr int INBOUND_BYTES = 1 << 20;
constexpr int QUEUED_PACKETS = 256;
/// A service sends its version at once.
constexpr double NO_VERSION_AFTER_S = 3.0;

steadyhand::HandSide side_of(const LeapSource &p_source) {
	return p_source.get_hand() == HandTracker::HAND_LEFT ? steadyhand::HandSide::LEFT
														 : steadyhand::HandSide::RIGHT;
}

bool is_ip_v6(const String &p_address) {
	return p_address.split(":").size() > 2;
}

/// Pose of the headset in the world; identity if none is tracked.
Eigen::Affine3d head_place() {
	XRServer *const server = XRServer::get_singleton();
	const Ref<XRPositionalTracker> head = server->get_tracker("head");
	const Ref<XRPose> pose = head.is_valid() ? head->get_pose("default") : Ref<XRPose>();
	if (pose.is_null() || !pose->get_has_tracking_data()) {
		return Eigen::Affine3d::Identity();
	}
	return to_core(server->get_world_origin()) * to_core(pose->get_adjusted_transform());
}

} // namespace

LeapStream::LeapStream(const Ref<LeapSource> &p_source) : source_(p_source), chooser_(side_of(**p_source)) {}

LeapStream::~LeapStream() {
	if (socket_.is_valid()) {
		socket_->close();
	}
}

String LeapStream::open() {
	const String address = source_->get_address();
	const bool has_port = address.contains(":") && !is_ip_v6(address);
	return address.is_empty() || address.contains("/") || has_port
			? String("LeapSource: \"address\" must be a host name or an IP address, without ws:// and "
					 "without a "
					 "port, is '") +
					address + String("'")
			: String();
}

String LeapStream::url() const {
	const String address = source_->get_address();
	return String("ws://") + (is_ip_v6(address) ? String("[") + address + String("]") : address) +
			String(":") + itos(source_->get_port()) + to_godot(steadyhand::leap_path(version_));
}

void LeapStream::fail(const String &p_text) {
	if (!is_failure_reported_) {
		is_failure_reported_ = true;
		announce(StreamEvent::Kind::FAILED, String("LeapSource: ") + p_text);
	}
}

void LeapStream::warn(Topic p_topic, const String &p_text) {
	const unsigned topic = 1U << static_cast<unsigned>(p_topic);
	if ((warned_ & topic) == 0) {
		warned_ |= topic;
		announce(StreamEvent::Kind::WARNING, String("LeapSource: ") + p_text);
	}
}

void LeapStream::connect(double p_now_s) {
	socket_.instantiate();
	socket_->set_inbound_buffer_size(INBOUND_BYTES);
	socket_->set_max_queued_packets(QUEUED_PACKETS);
	got_version_ = false;
	connected_s_ = p_now_s;
	clock_.clear();
	chooser_ = steadyhand::LeapHandChooser(side_of(**source_));
	if (socket_->connect_to_url(url()) != OK) {
		fail(String("the address ") + url() + String(" cannot be used. Set \"address\" and \"port\""));
		on_closed(p_now_s);
	}
}

void LeapStream::on_closed(double p_now_s) {
	const auto lower = steadyhand::next_version(version_, socket_->get_close_code(), got_version_);
	socket_.unref();
	if (lower) {
		version_ = *lower;
		next_attempt_s_ = p_now_s;
		return;
	}
	attempts_ = got_version_ ? 0 : attempts_;
	fail(got_version_ ? String("the service at ") + url() +
							String(" has closed the connection. LeapSource tries again until it is back")
					  : String("no service answers at ") + url() +
							String(". Start the Leap Motion service with \"Allow Web Apps\", or Ultraleap's "
								   "UltraleapTrackingWebSocket. LeapSource tries again until it answers"));
	next_attempt_s_ = p_now_s + steadyhand::reconnect_delay_s(attempts_++);
	version_ = steadyhand::LEAP_VERSION_WANTED;
}

void LeapStream::poll(double p_now_s) {
	if (socket_.is_null()) {
		if (p_now_s < next_attempt_s_) {
			return;
		}
		connect(p_now_s);
		if (socket_.is_null()) {
			return;
		}
	}
	socket_->poll();
	while (socket_->get_available_packet_count() > 0) {
		read(socket_->get_packet(), p_now_s);
	}
	if (socket_->get_ready_state() == WebSocketPeer::STATE_CLOSED) {
		on_closed(p_now_s);
	} else if (!got_version_ && p_now_s - connected_s_ > NO_VERSION_AFTER_S) {
		fail(String("the program at ") + url() +
				String(" sends no Leap messages. Set \"port\" to that of the Leap service"));
	}
}

void LeapStream::read(const PackedByteArray &p_packet, double p_now_s) {
	if (!socket_->was_string_packet()) {
		warn(Topic::BINARY,
				"the service sends binary messages, which no Leap service does. They are left out. Check "
				"\"port\"");
		return;
	}
	const std::string_view text(
			reinterpret_cast<const char *>(p_packet.ptr()), static_cast<std::size_t>(p_packet.size()));
	const steadyhand::LeapMessage message = steadyhand::parse_leap_message(text);
	if (const auto *version = std::get_if<steadyhand::LeapVersion>(&message)) {
		on_version(*version);
	} else if (const auto *device = std::get_if<steadyhand::LeapDevice>(&message)) {
		on_device(*device);
	} else if (const auto *frame = std::get_if<steadyhand::LeapFrame>(&message)) {
		on_frame(*frame, p_now_s);
	} else if (const auto *error = std::get_if<steadyhand::Error>(&message)) {
		warn(Topic::INVALID,
				String("a message of the service is left out: ") + to_godot(error->message) +
						String(" (reported once per run)"));
	}
}

void LeapStream::on_version(const steadyhand::LeapVersion &p_version) {
	got_version_ = true;
	attempts_ = 0;
	is_failure_reported_ = false;
	const auto mounting = static_cast<steadyhand::LeapMounting>(source_->get_mounting());
	for (const std::string_view request : steadyhand::leap_greeting(mounting)) {
		socket_->send_text(to_godot(request));
	}
	if (p_version.version < steadyhand::LEAP_VERSION_WANTED) {
		warn(Topic::VERSION,
				String("the service speaks version ") + itos(p_version.version) +
						String(" of the protocol, which does not distinguish left and right hands. Install "
							   "V2 or later"));
	}
	announce(StreamEvent::Kind::READY);
}

void LeapStream::on_device(const steadyhand::LeapDevice &p_device) {
	if (p_device.streaming) {
		is_failure_reported_ = false;
	} else {
		fail(p_device.attached ? "the Leap device is paused. Resume tracking in its control panel"
							   : "the Leap device is unplugged. Plug it in");
	}
}

Eigen::Affine3d LeapStream::device_place() const {
	const Eigen::Affine3d mount = to_core(source_->get_device_transform());
	return source_->get_mounting() == LeapSource::MOUNTING_HMD ? head_place() * mount : mount;
}

void LeapStream::on_frame(const steadyhand::LeapFrame &p_frame, double p_now_s) {
	const steadyhand::DeviceClock::Stamp stamp = clock_.map(p_frame.device_time_s(), p_now_s);
	if (stamp.restarted) {
		warn(Topic::CLOCK, "the service's clock was set to another time. Frames continue from here");
	}
	steadyhand::DeviceFrame frame;
	if (const steadyhand::LeapHand *const hand = chooser_.choose(p_frame)) {
		const auto mounting = static_cast<steadyhand::LeapMounting>(source_->get_mounting());
		frame.skeleton = steadyhand::leap_to_godot(hand->skeleton, mounting);
		move_joints(frame.skeleton, device_place());
		frame.hand = steadyhand::hand_frame_of(frame.skeleton, stamp.host_s);
		frame.hand.confidence = hand->confidence;
	}
	frame.hand.t_s = stamp.host_s;
	frame.device_time_s = p_frame.device_time_s();
	frame.host_time_s = host_time_s();
	queue_.push(frame);
}

} // namespace godot
