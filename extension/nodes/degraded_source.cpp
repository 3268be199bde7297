#include "degraded_source.h"

#include "conversions.h"
#include "node_label.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>
#include <utility>

namespace godot {

namespace {

using steadyhand::DegradeSettings;

/// Passes the frames of another stream through a DegradedHand.
class DegradedStream : public HandStream {
public:
	DegradedStream(std::unique_ptr<HandStream> p_original, const DegradeSettings &p_settings) :
			original_(std::move(p_original)), hand_(p_settings), latency_s_(p_settings.latency_s) {}

	String open() override { return original_->open(); }
	StreamClock clock() const override { return original_->clock(); }
	double start_s() const override { return original_->start_s(); }
	double duration_s() const override { return original_->duration_s(); }
	bool is_looped() const override { return original_->is_looped(); }
	bool begins_round() const override { return original_->begins_round(); }
	bool is_finished() const override { return original_->is_finished(); }
	String played_file() const override { return original_->played_file(); }
	bool is_polled() const override { return original_->is_polled(); }
	void poll(double p_now_s) override { original_->poll(p_now_s); }
	double complete_until_s(double p_now_s) const override { return original_->complete_until_s(p_now_s); }
	bool accept(const steadyhand::DeviceFrame &p_frame) override { return original_->accept(p_frame); }
	double latency_s() const override { return original_->latency_s() + latency_s_; }
	Eigen::Affine3d tracking_to_frames() const override { return original_->tracking_to_frames(); }
	bool next_event(StreamEvent &r_event) override { return original_->next_event(r_event); }

	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override {
		steadyhand::DeviceFrame original;
		while (original_->next(p_until_s, original)) {
			if (auto degraded = hand_.apply(original)) {
				r_frame = *std::move(degraded);
				return true;
			}
		}
		return false;
	}

private:
	std::unique_ptr<HandStream> original_;
	steadyhand::DegradedHand hand_;
	double latency_s_;
};

/// For a DegradedSource without a source.
class NoStream : public HandStream {
public:
	String open() override { return "set \"source\" of the DegradedSource to the source to degrade"; }
	StreamClock clock() const override { return StreamClock::FRAMES; }
	bool next(double, steadyhand::DeviceFrame &) override { return false; }
};

} // namespace

std::unique_ptr<HandStream> DegradedSource::make_stream(HandTracker &p_tracker) {
	if (source_.is_null()) {
		return std::make_unique<NoStream>();
	}
	return std::make_unique<DegradedStream>(source_->make_stream(p_tracker), settings_);
}

bool DegradedSource::contains(const HandSource *p_source) const {
	const auto *const inner = Object::cast_to<DegradedSource>(*source_);
	return p_source == this || p_source == *source_ || (inner != nullptr && inner->contains(p_source));
}

void DegradedSource::set_source(const Ref<HandSource> &p_source) {
	const auto *const degraded = Object::cast_to<DegradedSource>(*p_source);
	ERR_FAIL_COND_MSG(*p_source == this || (degraded != nullptr && degraded->contains(this)),
			"DegradedSource: a source cannot degrade itself; set \"source\" to another one");
	source_ = p_source;
	emit_changed();
}

void DegradedSource::set_preset(Preset p_preset) {
	ERR_FAIL_COND_MSG(!is_enumerator(p_preset, PRESET_UNSTABLE),
			refusal("DegradedSource", "preset must be one of PRESET_*", p_preset));
	preset_ = p_preset;
	if (p_preset != PRESET_CUSTOM) {
		const std::uint64_t seed = settings_.seed;
		settings_ = steadyhand::degrade_preset(p_preset == PRESET_STABLE ? "stable" : "unstable")
							.value_or(DegradeSettings());
		settings_.seed = seed;
	}
	notify_property_list_changed();
	emit_changed();
}

void DegradedSource::set_checked(const char *p_name, double &r_field, double p_value) {
	ERR_FAIL_COND_MSG(!(p_value >= 0.0) || !std::isfinite(p_value),
			refusal("DegradedSource", String(p_name) + String(" must be finite, and 0 (off) or more"),
					p_value));
	if (r_field != p_value) {
		r_field = p_value;
		preset_ = PRESET_CUSTOM;
		emit_changed();
	}
}

void DegradedSource::set_seed(int64_t p_seed) {
	settings_.seed = static_cast<std::uint64_t>(p_seed);
	emit_changed();
}

void DegradedSource::set_silent_dropouts(bool p_silent) {
	settings_.dropouts_are_silent = p_silent;
	emit_changed();
}

PackedStringArray DegradedSource::get_warnings() const {
	if (source_.is_valid()) {
		return source_->get_warnings();
	}
	PackedStringArray warnings;
	warnings.push_back("Set \"source\" of the DegradedSource to the source to degrade.");
	return warnings;
}

String DegradedSource::no_frame_advice() const {
	return source_.is_valid() ? source_->no_frame_advice() : String("Set \"source\" of the DegradedSource");
}

void DegradedSource::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_source", "source"), &DegradedSource::set_source);
	ClassDB::bind_method(D_METHOD("get_source"), &DegradedSource::get_source);
	ClassDB::bind_method(D_METHOD("set_preset", "preset"), &DegradedSource::set_preset);
	ClassDB::bind_method(D_METHOD("get_preset"), &DegradedSource::get_preset);
	ClassDB::bind_method(D_METHOD("set_seed", "seed"), &DegradedSource::set_seed);
	ClassDB::bind_method(D_METHOD("get_seed"), &DegradedSource::get_seed);
	ClassDB::bind_method(D_METHOD("set_silent_dropouts", "silent"), &DegradedSource::set_silent_dropouts);
	ClassDB::bind_method(D_METHOD("get_silent_dropouts"), &DegradedSource::get_silent_dropouts);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "source", PROPERTY_HINT_RESOURCE_TYPE, "HandSource"),
			"set_source", "get_source");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "preset", PROPERTY_HINT_ENUM, "Custom,Stable,Unstable"),
			"set_preset", "get_preset");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "seed", PROPERTY_HINT_RANGE, "0,1000,1,or_greater"), "set_seed",
			"get_seed");

#define BIND_NUMBER(m_name, m_field, m_range)                                                                \
	ClassDB::bind_method(D_METHOD("set_" m_name, m_name),                                                    \
			&DegradedSource::set_number<&DegradeSettings::m_field, m_name>);                                 \
	ClassDB::bind_method(D_METHOD("get_" m_name), &DegradedSource::get_number<&DegradeSettings::m_field>);   \
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, m_name, PROPERTY_HINT_RANGE, m_range), "set_" m_name,          \
			"get_" m_name)

	ADD_GROUP("Dropouts", "");
	BIND_NUMBER("dropouts_per_minute", dropouts_per_minute, "0,60,0.1,or_greater");
	BIND_NUMBER("dropout_duration", dropout_s, "0,2,0.01,or_greater,suffix:s");
	ADD_PROPERTY(
			PropertyInfo(Variant::BOOL, "silent_dropouts"), "set_silent_dropouts", "get_silent_dropouts");
	ADD_GROUP("Freezes", "");
	BIND_NUMBER("freezes_per_minute", freezes_per_minute, "0,60,0.1,or_greater");
	BIND_NUMBER("freeze_duration", freeze_s, "0,2,0.01,or_greater,suffix:s");
	ADD_GROUP("Jumps", "");
	BIND_NUMBER("jumps_per_minute", jumps_per_minute, "0,60,0.1,or_greater");
	BIND_NUMBER("jump_distance", jump_m, "0,0.5,0.001,or_greater,suffix:m");
	BIND_NUMBER("jump_duration", jump_s, "0,1,0.01,or_greater,suffix:s");
	ADD_GROUP("Drift and Noise", "");
	BIND_NUMBER("drift", drift_m, "0,0.05,0.0001,or_greater,suffix:m");
	BIND_NUMBER("drift_time", drift_s, "0,10,0.1,or_greater,suffix:s");
	BIND_NUMBER("noise", noise_m, "0,0.01,0.0001,or_greater,suffix:m");
	BIND_NUMBER("rounding", rounding_m, "0,0.01,0.0001,or_greater,suffix:m");
	ADD_GROUP("Timing", "");
	BIND_NUMBER("latency", latency_s, "0,0.5,0.001,or_greater,suffix:s");
	BIND_NUMBER("rate", rate_hz, "0,120,1,or_greater,suffix:Hz");
#undef BIND_NUMBER

	BIND_ENUM_CONSTANT(PRESET_CUSTOM);
	BIND_ENUM_CONSTANT(PRESET_STABLE);
	BIND_ENUM_CONSTANT(PRESET_UNSTABLE);
}

} // namespace godot
