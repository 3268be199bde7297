#include "haptic_device_profile.h"

#include "node_label.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

void HapticDeviceProfile::set_response(const PackedVector2Array &p_response) {
	using Point = steadyhand::DeviceProfile::Point;
	response_ = p_response;
	profile_.response.clear();
	for (int64_t i = 0; i < p_response.size(); ++i) {
		const Point point{ static_cast<double>(p_response[i].x), static_cast<double>(p_response[i].y) };
		if (point.frequency_hz > 0.0 && std::isfinite(point.frequency_hz) && point.response >= 0.0 &&
				std::isfinite(point.response)) {
			profile_.response.push_back(point);
		}
	}
	std::stable_sort(profile_.response.begin(), profile_.response.end(),
			[](const Point &one, const Point &other) { return one.frequency_hz < other.frequency_hz; });
	// The inspector adds (0, 0) for the user to edit.
	if (has_unusable_points() && !Engine::get_singleton()->is_editor_hint()) {
		WARN_PRINT(
				"HapticDeviceProfile: some points of \"response\" are left out. Give each point a frequency "
				"above 0 Hz and a response of 0 or more");
	}
	emit_changed();
}

void HapticDeviceProfile::set_resonance(double p_resonance_hz) {
	ERR_FAIL_COND_MSG(!(p_resonance_hz >= 0.0) || !std::isfinite(p_resonance_hz),
			refusal("HapticDeviceProfile", "resonance must be 0 Hz (none) or more", p_resonance_hz));
	profile_.resonance_hz = p_resonance_hz;
	emit_changed();
}

void HapticDeviceProfile::set_maximum_amplitude(double p_amplitude) {
	ERR_FAIL_COND_MSG(!(p_amplitude > 0.0) || p_amplitude > 1.0,
			refusal("HapticDeviceProfile", "maximum_amplitude must be above 0 and at most 1", p_amplitude));
	profile_.most = p_amplitude;
	emit_changed();
}

void HapticDeviceProfile::set_latency(double p_latency_s) {
	ERR_FAIL_COND_MSG(!(p_latency_s >= 0.0) || !std::isfinite(p_latency_s),
			refusal("HapticDeviceProfile", "latency must be 0 s or more", p_latency_s));
	profile_.latency_s = p_latency_s;
	emit_changed();
}

void HapticDeviceProfile::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_response", "response"), &HapticDeviceProfile::set_response);
	ClassDB::bind_method(D_METHOD("get_response"), &HapticDeviceProfile::get_response);
	ClassDB::bind_method(D_METHOD("set_resonance", "resonance"), &HapticDeviceProfile::set_resonance);
	ClassDB::bind_method(D_METHOD("get_resonance"), &HapticDeviceProfile::get_resonance);
	ClassDB::bind_method(
			D_METHOD("set_maximum_amplitude", "amplitude"), &HapticDeviceProfile::set_maximum_amplitude);
	ClassDB::bind_method(D_METHOD("get_maximum_amplitude"), &HapticDeviceProfile::get_maximum_amplitude);
	ClassDB::bind_method(D_METHOD("set_latency", "latency"), &HapticDeviceProfile::set_latency);
	ClassDB::bind_method(D_METHOD("get_latency"), &HapticDeviceProfile::get_latency);

	ADD_PROPERTY(PropertyInfo(Variant::PACKED_VECTOR2_ARRAY, "response"), "set_response", "get_response");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "resonance", PROPERTY_HINT_RANGE, "0,500,1,or_greater,suffix:Hz"),
			"set_resonance", "get_resonance");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "maximum_amplitude", PROPERTY_HINT_RANGE, "0.01,1,0.01"),
			"set_maximum_amplitude", "get_maximum_amplitude");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "latency", PROPERTY_HINT_RANGE, "0,0.1,0.001,or_greater,suffix:s"),
			"set_latency", "get_latency");
}

} // namespace godot
