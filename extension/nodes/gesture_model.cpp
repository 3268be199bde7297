#include "gesture_model.h"

#include "conversions.h"
#include "node_label.h"
#include "text_file.h"

#include "gesture/gesture_model.h"
#include "gesture/model_file.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

namespace godot {

void GestureModel::set_core(std::shared_ptr<const steadyhand::GestureModel> p_model) {
	model_ = std::move(p_model);
	emit_changed();
}

StringName GestureModel::get_gesture() const {
	return model_ ? StringName(to_godot(model_->gesture)) : StringName();
}

String GestureModel::get_feature() const {
	return model_ ? to_godot(model_->feature) : String();
}

int GestureModel::get_state_count() const {
	return model_ ? static_cast<int>(model_->hmm.states()) : 0;
}

int GestureModel::get_symbol_count() const {
	return model_ ? static_cast<int>(model_->hmm.symbols()) : 0;
}

double GestureModel::get_typical_amplitude() const {
	return model_ ? model_->typical_task.amplitude_m : 0.0;
}

double GestureModel::get_duration_mean() const {
	return model_ ? model_->duration_mean_s : 0.0;
}

double GestureModel::get_duration_deviation() const {
	return model_ ? model_->duration_deviation_s : 0.0;
}

Dictionary GestureModel::get_provenance() const {
	Dictionary dictionary;
	if (!model_) {
		return dictionary;
	}
	const steadyhand::Provenance &provenance = model_->provenance;
	PackedStringArray dropped;
	for (const std::string &name : provenance.dropped) {
		dropped.push_back(to_godot(name));
	}
	dictionary["trial_set"] = to_godot(provenance.trial_set);
	dictionary["trained_with"] = to_godot(provenance.trained_with);
	dictionary["recordings"] = provenance.recordings;
	dictionary["dropped"] = dropped;
	dictionary["r2_threshold"] = provenance.r2_threshold;
	dictionary["objective"] = to_godot(std::span<const double>(provenance.objective));
	return dictionary;
}

PackedFloat64Array GestureModel::get_reference_mean() const {
	return model_ ? to_godot(model_->reference_mean) : PackedFloat64Array();
}

PackedFloat64Array GestureModel::get_reference_deviation() const {
	return model_ ? to_godot(model_->reference_deviation) : PackedFloat64Array();
}

Dictionary GestureModel::get_element(int p_state) const {
	ERR_FAIL_INDEX_V(p_state, get_state_count(), Dictionary());
	const steadyhand::PrimitiveMotionElement &element = model_->elements[static_cast<std::size_t>(p_state)];
	Dictionary dictionary;
	dictionary["phase_begin"] = element.phase_begin;
	dictionary["phase_end"] = element.phase_end;
	dictionary["coefficients"] = to_godot(std::span<const double>(element.curve.coefficients));
	dictionary["deviation"] = element.deviation;
	dictionary["duration_mean"] = element.duration_mean_s;
	dictionary["duration_deviation"] = element.duration_deviation_s;
	return dictionary;
}

double GestureModel::evaluate(double p_phase) const {
	ERR_FAIL_COND_V_MSG(
			!std::isfinite(p_phase), 0.0, refusal("GestureModel", "the phase must be finite", p_phase));
	return model_ ? steadyhand::evaluate(*model_, p_phase).value : 0.0;
}

String GestureModel::to_text() const {
	return model_ ? to_godot(steadyhand::format_model(*model_)) : String();
}

void GestureModel::set_text(const String &p_text) {
	if (p_text.is_empty()) {
		set_core(nullptr);
	} else {
		parse_text(p_text);
	}
}

Error GestureModel::parse_text(const String &p_text) {
	steadyhand::Result<steadyhand::GestureModel> parsed =
			steadyhand::parse_model(to_core(p_text), "GestureModel.parse_text");
	ERR_FAIL_COND_V_MSG(!parsed, ERR_PARSE_ERROR, to_godot(parsed.error()));
	set_core(std::make_shared<const steadyhand::GestureModel>(std::move(parsed).value()));
	return OK;
}

Ref<GestureModel> GestureModel::load_file(const String &p_path) {
	const steadyhand::Result<std::string> text = read_text_file(p_path);
	ERR_FAIL_COND_V_MSG(!text, Ref<GestureModel>(), to_godot(text.error()));
	steadyhand::Result<steadyhand::GestureModel> parsed =
			steadyhand::parse_model(text.value(), to_core(p_path));
	ERR_FAIL_COND_V_MSG(!parsed, Ref<GestureModel>(), to_godot(parsed.error()));
	Ref<GestureModel> resource;
	resource.instantiate();
	resource->set_core(std::make_shared<const steadyhand::GestureModel>(std::move(parsed).value()));
	return resource;
}

void GestureModel::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_gesture"), &GestureModel::get_gesture);
	ClassDB::bind_method(D_METHOD("get_feature"), &GestureModel::get_feature);
	ClassDB::bind_method(D_METHOD("get_state_count"), &GestureModel::get_state_count);
	ClassDB::bind_method(D_METHOD("get_symbol_count"), &GestureModel::get_symbol_count);
	ClassDB::bind_method(D_METHOD("get_typical_amplitude"), &GestureModel::get_typical_amplitude);
	ClassDB::bind_method(D_METHOD("get_duration_mean"), &GestureModel::get_duration_mean);
	ClassDB::bind_method(D_METHOD("get_duration_deviation"), &GestureModel::get_duration_deviation);
	ClassDB::bind_method(D_METHOD("get_provenance"), &GestureModel::get_provenance);
	ClassDB::bind_method(D_METHOD("get_reference_mean"), &GestureModel::get_reference_mean);
	ClassDB::bind_method(D_METHOD("get_reference_deviation"), &GestureModel::get_reference_deviation);
	ClassDB::bind_method(D_METHOD("get_element", "state"), &GestureModel::get_element);
	ClassDB::bind_method(D_METHOD("evaluate", "phase"), &GestureModel::evaluate);
	ClassDB::bind_method(D_METHOD("set_text", "text"), &GestureModel::set_text);
	ClassDB::bind_method(D_METHOD("get_text"), &GestureModel::to_text);
	ClassDB::bind_method(D_METHOD("to_text"), &GestureModel::to_text);
	ClassDB::bind_method(D_METHOD("parse_text", "text"), &GestureModel::parse_text);
	ClassDB::bind_static_method("GestureModel", D_METHOD("load_file", "path"), &GestureModel::load_file);

	// For duplicate() and models inside a scene. A model with its own *.gesture file is stored as a path.
	ADD_PROPERTY(
			PropertyInfo(Variant::STRING, "text", PROPERTY_HINT_MULTILINE_TEXT, "", PROPERTY_USAGE_STORAGE),
			"set_text", "get_text");
	constexpr uint32_t SHOWN = PROPERTY_USAGE_EDITOR | PROPERTY_USAGE_READ_ONLY;
	ADD_PROPERTY(
			PropertyInfo(Variant::STRING_NAME, "gesture", PROPERTY_HINT_NONE, "", SHOWN), "", "get_gesture");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "feature", PROPERTY_HINT_NONE, "", SHOWN), "", "get_feature");
	ADD_PROPERTY(
			PropertyInfo(Variant::INT, "state_count", PROPERTY_HINT_NONE, "", SHOWN), "", "get_state_count");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "symbol_count", PROPERTY_HINT_NONE, "", SHOWN), "",
			"get_symbol_count");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "typical_amplitude", PROPERTY_HINT_NONE, "suffix:m", SHOWN), "",
			"get_typical_amplitude");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration_mean", PROPERTY_HINT_NONE, "suffix:s", SHOWN), "",
			"get_duration_mean");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "duration_deviation", PROPERTY_HINT_NONE, "suffix:s", SHOWN),
			"", "get_duration_deviation");
	ADD_PROPERTY(PropertyInfo(Variant::DICTIONARY, "provenance", PROPERTY_HINT_NONE, "", SHOWN), "",
			"get_provenance");
}

} // namespace godot
