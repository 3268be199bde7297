#include "devices/leap_protocol.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace steadyhand {
namespace {

// Its objects are sorted maps. Objects of nlohmann::ordered_json would need quadratic time for many keys.
using Json = nlohmann::json;
using J = SkeletonJoint;

constexpr double M_PER_MM = 0.001;
/// Integers up to this are exact as double. In microseconds it is 285 years.
constexpr std::int64_t LARGEST_WHOLE = 1LL << 53;
/// How far a basis may be from unit length and right angles. Services print six decimals or more; a basis
/// beyond this is damaged.
constexpr double BASIS_TOLERANCE = 0.05;

/// The member with that name; null if there is none, or if `object` is no object.
const Json *find(const Json &object, const char *key) {
	if (!object.is_object()) {
		return nullptr;
	}
	const auto found = object.find(key);
	return found == object.end() ? nullptr : &*found;
}

std::optional<double> number(const Json &object, const char *key) {
	const Json *value = find(object, key);
	if (value == nullptr || !value->is_number()) {
		return std::nullopt;
	}
	const auto read = value->get<double>();
	return std::isfinite(read) ? std::optional(read) : std::nullopt;
}

/// Rounded: the bridge may print whole numbers with decimals.
std::optional<std::int64_t> whole_number(const Json &object, const char *key) {
	const std::optional<double> read = number(object, key);
	if (!read || std::abs(*read) > static_cast<double>(LARGEST_WHOLE)) {
		return std::nullopt;
	}
	return std::llround(*read);
}

/// A share of 0..1.
double share(const Json &object, const char *key, double absent) {
	return std::clamp(number(object, key).value_or(absent), 0.0, 1.0);
}

std::string text_of(const Json *value) {
	if (value != nullptr && value->is_string()) {
		return value->get_ref<const std::string &>();
	}
	return value != nullptr && value->is_number_integer() ? value->dump() : std::string();
}

bool is_true(const Json &object, const char *key) {
	const Json *value = find(object, key);
	return value != nullptr && value->is_boolean() && value->get<bool>();
}

std::optional<Eigen::Vector3d> vector_of(const Json *value) {
	if (value == nullptr || !value->is_array() || value->size() != 3) {
		return std::nullopt;
	}
	Eigen::Vector3d out;
	for (std::size_t i = 0; i < 3; ++i) {
		if (!(*value)[i].is_number()) {
			return std::nullopt;
		}
		out[static_cast<Eigen::Index>(i)] = (*value)[i].get<double>();
	}
	return out.allFinite() ? std::optional(out) : std::nullopt;
}

std::optional<Eigen::Vector3d> position_m(const Json &object, const char *key) {
	const std::optional<Eigen::Vector3d> read_mm = vector_of(find(object, key));
	if (!read_mm || read_mm->isZero(0.0) || (*read_mm * M_PER_MM).norm() > LEAP_FARTHEST_M) {
		return std::nullopt;
	}
	return *read_mm * M_PER_MM;
}

/// The rotation whose z axis lies along `z` and whose y axis is as near to `y` as it can be; both of about
/// unit length.
std::optional<Eigen::Quaterniond> rotation_of(const Eigen::Vector3d &y, const Eigen::Vector3d &z) {
	const auto is_unit = [](double norm) { return std::abs(norm - 1.0) <= BASIS_TOLERANCE; };
	if (!is_unit(y.norm()) || !is_unit(z.norm()) || std::abs(y.dot(z)) > BASIS_TOLERANCE) {
		return std::nullopt;
	}
	Eigen::Matrix3d axes;
	axes.col(2) = z.normalized();
	axes.col(0) = y.cross(axes.col(2)).normalized();
	axes.col(1) = axes.col(2).cross(axes.col(0));
	return Eigen::Quaterniond(axes);
}

/// From the three rows x, y, z of a bone. Leap's y points out of the back of the hand and its z from the tip
/// to the wrist, as OpenXR's do. The original service gives left hands a mirrored x (determinant -1): x is
/// taken from y and z.
std::optional<Eigen::Quaterniond> bone_rotation(const Json &basis) {
	if (!basis.is_array() || basis.size() != 3) {
		return std::nullopt;
	}
	const std::optional<Eigen::Vector3d> x = vector_of(&basis[0]);
	const std::optional<Eigen::Vector3d> y = vector_of(&basis[1]);
	const std::optional<Eigen::Vector3d> z = vector_of(&basis[2]);
	if (!x || !y || !z || std::abs(std::abs(x->dot(y->cross(*z))) - 1.0) > 3.0 * BASIS_TOLERANCE) {
		return std::nullopt;
	}
	return rotation_of(*y, *z);
}

void set_rotation(HandSkeleton &r_skeleton, J joint, const std::optional<Eigen::Quaterniond> &rotation) {
	if (rotation) {
		r_skeleton.rotations[static_cast<std::size_t>(joint)] = *rotation;
		r_skeleton.rotated |= HandSkeleton::bit(joint);
	}
}

void set_position(HandSkeleton &r_skeleton, J joint, const std::optional<Eigen::Vector3d> &position) {
	if (position) {
		r_skeleton.set(joint, *position);
	}
}

/// A joint of a finger: the key of its position, and the index of its bone among the four bases.
struct FingerJoint {
	const char *position;
	std::size_t basis;
};

constexpr std::size_t LEAP_BONES = 4; // metacarpal, proximal, intermediate, distal
constexpr std::array<FingerJoint, 5> FINGER{ { { "carpPosition", 0 }, { "mcpPosition", 1 },
		{ "pipPosition", 2 }, { "dipPosition", 3 }, { "tipPosition", 3 } } };
/// A thumb has three bones. Leap reports four: a metacarpal of length zero at the wrist's side (carp = mcp),
/// and names that are shifted by one. Its "proximal" bone, mcp to pip, is the anatomical metacarpal, its
/// "intermediate" bone the anatomical proximal one. So the joints of OpenXR's thumb are FINGER without the
/// first.
constexpr std::size_t THUMB_FROM = 1;

/// Reads the finger number 0 thumb .. 4 pinky.
void read_finger(const Json &pointable, std::size_t finger, HandSkeleton &r_skeleton) {
	constexpr std::array<J, 5> FIRST{ J::THUMB_METACARPAL, J::INDEX_METACARPAL, J::MIDDLE_METACARPAL,
		J::RING_METACARPAL, J::PINKY_METACARPAL };
	const std::size_t from = finger == 0 ? THUMB_FROM : 0;
	const Json *bases = find(pointable, "bases");
	const bool has_bases = bases != nullptr && bases->is_array() && bases->size() == LEAP_BONES;
	for (std::size_t i = from; i < FINGER.size(); ++i) {
		const auto joint = static_cast<J>(static_cast<std::size_t>(FIRST[finger]) + i - from);
		set_position(r_skeleton, joint, position_m(pointable, FINGER[i].position));
		if (has_bases) {
			set_rotation(r_skeleton, joint, bone_rotation((*bases)[FINGER[i].basis]));
		}
		if (i + 1 == FINGER.size() && !r_skeleton.has(joint)) {
			set_position(r_skeleton, joint, position_m(pointable, "btipPosition"));
		}
	}
}

std::optional<LeapHand> hand_of(const Json &object) {
	const std::optional<std::int64_t> id = whole_number(object, "id");
	const std::string type = text_of(find(object, "type"));
	const std::optional<Eigen::Vector3d> palm_m = position_m(object, "palmPosition");
	if (!id || (type != "left" && type != "right") || !palm_m) {
		return std::nullopt;
	}
	LeapHand hand;
	hand.id = *id;
	hand.is_left = type == "left";
	hand.confidence = share(object, "confidence", 1.0);
	hand.grab = share(object, "grabStrength", 0.0);
	hand.pinch = share(object, "pinchStrength", 0.0);
	hand.time_visible_s = std::max(0.0, number(object, "timeVisible").value_or(0.0));
	hand.skeleton.set(J::PALM, *palm_m);
	set_position(hand.skeleton, J::WRIST, position_m(object, "wrist"));
	// `direction` points from the palm to the fingers, `palmNormal` out of the palm.
	const std::optional<Eigen::Vector3d> direction = vector_of(find(object, "direction"));
	const std::optional<Eigen::Vector3d> normal = vector_of(find(object, "palmNormal"));
	if (direction && normal) {
		set_rotation(hand.skeleton, J::PALM, rotation_of(-*normal, -*direction));
	}
	return hand;
}

/// Null if there is none.
LeapHand *hand_with(LeapFrame &r_frame, std::int64_t id) {
	const auto found = std::find_if(
			r_frame.hands.begin(), r_frame.hands.end(), [id](const LeapHand &hand) { return hand.id == id; });
	return found == r_frame.hands.end() ? nullptr : &*found;
}

void read_pointable(const Json &pointable, LeapFrame &r_frame) {
	const std::optional<std::int64_t> hand_id = whole_number(pointable, "handId");
	const std::optional<std::int64_t> finger = whole_number(pointable, "type");
	if (!hand_id || !finger || *finger < 0 || *finger > 4 || is_true(pointable, "tool")) {
		return;
	}
	if (LeapHand *hand = hand_with(r_frame, *hand_id)) {
		read_finger(pointable, static_cast<std::size_t>(*finger), hand->skeleton);
	}
}

LeapMessage frame_of(const Json &message) {
	const std::optional<std::int64_t> id = whole_number(message, "id");
	const std::optional<std::int64_t> timestamp_us = whole_number(message, "timestamp");
	const Json *hands = find(message, "hands");
	const Json *pointables = find(message, "pointables");
	if (!id) {
		return Error{ "frame: 'id' is not a number" };
	}
	if (!timestamp_us) {
		return Error{ "frame: 'timestamp' is not a number" };
	}
	if (hands == nullptr || !hands->is_array()) {
		return Error{ "frame: 'hands' is not a list" };
	}
	if (pointables != nullptr && !pointables->is_array()) {
		return Error{ "frame: 'pointables' is not a list" };
	}
	LeapFrame frame;
	frame.id = *id;
	frame.timestamp_us = *timestamp_us;
	frame.frame_rate_hz = std::max(0.0, number(message, "currentFrameRate").value_or(0.0));
	for (const Json &object : *hands) {
		std::optional<LeapHand> hand = hand_of(object);
		if (hand && frame.hands.size() < LEAP_HANDS_MAX && hand_with(frame, hand->id) == nullptr) {
			frame.hands.push_back(*std::move(hand));
		}
	}
	if (pointables != nullptr) {
		for (const Json &pointable : *pointables) {
			read_pointable(pointable, frame);
		}
	}
	return frame;
}

LeapMessage event_of(const Json &event) {
	if (!event.is_object()) {
		return Error{ "'event' is not an object" };
	}
	if (text_of(find(event, "type")) != "deviceEvent") {
		return LeapOther{};
	}
	const Json *state = find(event, "state");
	if (state == nullptr || !state->is_object()) {
		return Error{ "device event: 'state' is not an object" };
	}
	LeapDevice device;
	device.id = text_of(find(*state, "id"));
	device.type = text_of(find(*state, "type"));
	std::transform(device.type.begin(), device.type.end(), device.type.begin(),
			[](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
	device.attached = is_true(*state, "attached");
	device.streaming = device.attached && is_true(*state, "streaming");
	return device;
}

LeapMessage version_of(const Json &message) {
	constexpr std::int64_t LARGEST = 1000; // services have 6 or 7
	const std::optional<std::int64_t> version = whole_number(message, "version");
	if (!version || *version < 1 || *version > LARGEST) {
		return Error{ "'version' is not a number of 1..1000" };
	}
	return LeapVersion{ static_cast<int>(*version), text_of(find(message, "serviceVersion")) };
}

} // namespace

LeapMessage parse_leap_message(std::string_view text) {
	if (text.size() > LEAP_MESSAGE_SIZE_MAX) {
		return Error{ "message of " + std::to_string(text.size()) + " bytes, more than " +
			std::to_string(LEAP_MESSAGE_SIZE_MAX) };
	}
	const Json message = Json::parse(text.begin(), text.end(), nullptr, false);
	if (message.is_discarded()) {
		return Error{ "invalid JSON" };
	}
	if (!message.is_object()) {
		return Error{ "message is not a JSON object" };
	}
	if (message.contains("hands") || message.contains("timestamp")) {
		return frame_of(message);
	}
	if (const Json *event = find(message, "event")) {
		return event_of(*event);
	}
	return message.contains("version") ? version_of(message) : LeapOther{};
}

} // namespace steadyhand
