#pragma once

#include "haptics/device_profile.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

namespace godot {

/// The core's DeviceProfile, an actuator's response to a signal, as a resource.
class HapticDeviceProfile : public Resource {
	GDCLASS(HapticDeviceProfile, Resource)

	PackedVector2Array response_; ///< as set, with invalid points
	steadyhand::DeviceProfile profile_;

public:
	void set_response(const PackedVector2Array &p_response);
	PackedVector2Array get_response() const { return response_; }
	bool has_unusable_points() const {
		return response_.size() != static_cast<int64_t>(profile_.response.size());
	}
	void set_resonance(double p_resonance_hz);
	double get_resonance() const { return profile_.resonance_hz; }
	void set_maximum_amplitude(double p_amplitude);
	double get_maximum_amplitude() const { return profile_.most; }
	void set_latency(double p_latency_s);
	double get_latency() const { return profile_.latency_s; }

	const steadyhand::DeviceProfile &core() const { return profile_; }

protected:
	static void _bind_methods();
};

} // namespace godot
