#include "gesture_trainer.h"

#include "conversions.h"
#include "name_suggestions.h"
#include "node_label.h"
#include "text_file.h"

#include "base/version.h"
#include "gesture/classifier_file.h"
#include "gesture/feature.h"
#include "gesture/feature_choice.h"
#include "gesture/model_file.h"
#include "simulation/classifier_set.h"

#include <godot_cpp/core/class_db.hpp>

#include <set>
#include <string>

namespace godot {

namespace {

/// Share of the time for reading tracks.
constexpr double READING = 0.3;

String listed(const std::set<std::string> &p_names) {
	PackedStringArray names;
	for (const std::string &name : p_names) {
		names.push_back(to_godot(name));
	}
	return String(", ").join(names);
}

} // namespace

void GestureTrainer::set_states(int p_states) {
	constexpr int MOST = steadyhand::TrainingOptions::MOST_STATES;
	ERR_FAIL_COND_MSG(p_states < 1 || p_states > MOST,
			refusal("GestureTrainer", String("states must be 1..") + itos(MOST), p_states));
	states_ = p_states;
}

void GestureTrainer::set_symbols(int p_symbols) {
	constexpr int MOST = steadyhand::TrainingOptions::MOST_SYMBOLS;
	ERR_FAIL_COND_MSG(p_symbols < 1 || p_symbols > MOST,
			refusal("GestureTrainer", String("symbols must be 1..") + itos(MOST), p_symbols));
	symbols_ = p_symbols;
}

void GestureTrainer::set_r2_threshold(double p_threshold) {
	ERR_FAIL_COND_MSG(!(p_threshold >= 0.0) || p_threshold > 1.0,
			refusal("GestureTrainer", "r2_threshold must be 0..1", p_threshold));
	r2_threshold_ = p_threshold;
}

Ref<GestureModel> GestureTrainer::train(const Ref<TrialSet> &p_trial_set, const StringName &p_gesture) {
	error_message_ = String();
	if (p_trial_set.is_null()) {
		return fail("GestureTrainer: train() needs a TrialSet, is null");
	}
	const Ref<GestureTrainer> kept(this); // a handler of the progress signal may drop the last reference
	cancelled_ = false;
	is_training_ = true;
	Ref<GestureModel> model = train_on(p_trial_set, p_gesture);
	is_training_ = false;
	return model;
}

Ref<GestureModel> GestureTrainer::fail(const String &p_reason) {
	error_message_ = p_reason;
	ERR_FAIL_V_MSG(Ref<GestureModel>(), p_reason);
}

Ref<GestureModel> GestureTrainer::train_on(const Ref<TrialSet> &p_trial_set, const StringName &p_gesture) {
	recordings_.clear();
	const std::string gesture = to_core(String(p_gesture));
	// Checked before any track is read.
	if (gesture == steadyhand::NO_GESTURE) {
		return fail("GestureTrainer: the gesture's name 'none' " +
				to_godot(steadyhand::gesture_name_fault(gesture)));
	}
	std::vector<const steadyhand::Trial *> wanted;
	std::set<std::string> gestures;
	for (const steadyhand::Trial &trial : p_trial_set->core()) {
		gestures.insert(trial.gesture);
		if (trial.gesture == gesture) {
			wanted.push_back(&trial);
		}
	}
	if (wanted.empty()) {
		return fail(p_trial_set->get_path() + String(": no trial of the gesture '") + String(p_gesture) +
				String(gestures.empty() ? "'" : "', but of ") + listed(gestures));
	}

	steadyhand::TrainingOptions options;
	options.states = states_;
	options.symbols = symbols_;
	options.r2_threshold = r2_threshold_;
	options.without_task = without_task_;
	options.progress = [this](double p_done) {
		emit_signal("progressed", READING + (1.0 - READING) * p_done);
		return !cancelled_;
	};
	std::string feature = to_core(feature_);
	const std::string fault = feature.empty() ? "" : steadyhand::training_error(feature, options);
	if (!fault.empty()) {
		return fail(to_godot(gesture + ": " + fault));
	}

	std::vector<steadyhand::TrainingRecording> recordings;
	std::vector<steadyhand::NormalisedRecording> unread;
	for (const steadyhand::Trial *trial : wanted) {
		steadyhand::Result<steadyhand::TrainingRecording> recording = p_trial_set->read_recording(*trial);
		if (recording) {
			recordings.push_back(std::move(recording).value());
		} else {
			unread.push_back({ trial->trial, {}, 0.0, false, recording.error() });
		}
		emit_signal("progressed",
				READING * static_cast<double>(recordings.size() + unread.size()) /
						static_cast<double>(wanted.size()));
		if (cancelled_) {
			return {};
		}
	}
	if (recordings.empty()) {
		return fail(to_godot(unread.front().oddity));
	}

	if (feature.empty()) {
		const steadyhand::Feature *chosen = steadyhand::choose_feature(recordings);
		if (chosen == nullptr) {
			return fail(p_trial_set->get_path() + String(": no feature fits the trials of '") +
					String(p_gesture) + String("'; trial ") +
					to_godot(steadyhand::no_feature_reason(recordings)));
		}
		feature = chosen->name;
	}
	std::string warning;
	steadyhand::Result<steadyhand::GestureModel> trained =
			steadyhand::train(gesture, feature, recordings, options, &recordings_, &warning);
	if (cancelled_) {
		return {};
	}
	recordings_.insert(recordings_.end(), unread.begin(), unread.end());
	if (!trained) {
		return fail(to_godot(trained.error()));
	}
	if (!warning.empty()) {
		WARN_PRINT(to_godot("GestureTrainer: " + gesture + ": " + warning));
	}
	steadyhand::GestureModel &core = trained.value();
	for (const steadyhand::NormalisedRecording &recording : unread) {
		core.provenance.dropped.push_back(recording.name);
	}
	core.provenance.trial_set = to_core(p_trial_set->get_path().get_file());
	core.provenance.trained_with = std::string("SteadyHand ").append(steadyhand::VERSION);
	const steadyhand::Result<steadyhand::GestureModel> read =
			steadyhand::parse_model(steadyhand::format_model(core), gesture);
	if (!read) {
		return fail(to_godot(gesture) + String(": these recordings give no usable model: ") +
				to_godot(read.error()));
	}
	Ref<GestureModel> model;
	model.instantiate();
	model->set_core(std::make_shared<const steadyhand::GestureModel>(std::move(core)));
	return model;
}

Error GestureTrainer::write_own_classifier(const String &p_path) {
	const steadyhand::Result<steadyhand::ClassifierModel> model = steadyhand::train_own_classifier();
	ERR_FAIL_COND_V_MSG(!model, ERR_BUG, to_godot(model.error()));
	return write_text_file(p_path, steadyhand::format_classifier(model.value()));
}

TypedArray<Dictionary> GestureTrainer::get_recordings() const {
	TypedArray<Dictionary> rows;
	for (const steadyhand::NormalisedRecording &recording : recordings_) {
		Dictionary row;
		row["trial"] = to_godot(recording.name);
		row["curve"] = to_godot(recording.curve);
		row["r2"] = recording.r2;
		row["kept"] = recording.kept;
		row["oddity"] = to_godot(recording.oddity);
		rows.push_back(row);
	}
	return rows;
}

String GestureTrainer::get_version() {
	return steadyhand::VERSION;
}

void GestureTrainer::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("feature")) {
		PackedStringArray names;
		for (const steadyhand::Feature &known : steadyhand::features()) {
			names.push_back(to_godot(known.name));
		}
		suggest(names, p_property);
	}
}

void GestureTrainer::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_feature", "feature"), &GestureTrainer::set_feature);
	ClassDB::bind_method(D_METHOD("get_feature"), &GestureTrainer::get_feature);
	ClassDB::bind_method(D_METHOD("set_states", "states"), &GestureTrainer::set_states);
	ClassDB::bind_method(D_METHOD("get_states"), &GestureTrainer::get_states);
	ClassDB::bind_method(D_METHOD("set_symbols", "symbols"), &GestureTrainer::set_symbols);
	ClassDB::bind_method(D_METHOD("get_symbols"), &GestureTrainer::get_symbols);
	ClassDB::bind_method(D_METHOD("set_r2_threshold", "threshold"), &GestureTrainer::set_r2_threshold);
	ClassDB::bind_method(D_METHOD("get_r2_threshold"), &GestureTrainer::get_r2_threshold);
	ClassDB::bind_method(D_METHOD("set_without_task", "enabled"), &GestureTrainer::set_without_task);
	ClassDB::bind_method(D_METHOD("is_without_task"), &GestureTrainer::is_without_task);
	ClassDB::bind_method(D_METHOD("train", "trial_set", "gesture"), &GestureTrainer::train);
	ClassDB::bind_method(D_METHOD("cancel"), &GestureTrainer::cancel);
	ClassDB::bind_method(D_METHOD("is_cancelled"), &GestureTrainer::is_cancelled);
	ClassDB::bind_method(D_METHOD("get_error_message"), &GestureTrainer::get_error_message);
	ClassDB::bind_method(D_METHOD("get_recordings"), &GestureTrainer::get_recordings);
	ClassDB::bind_static_method("GestureTrainer", D_METHOD("write_own_classifier", "path"),
			&GestureTrainer::write_own_classifier);
	ClassDB::bind_static_method("GestureTrainer", D_METHOD("get_version"), &GestureTrainer::get_version);

	ADD_PROPERTY(PropertyInfo(Variant::STRING, "feature"), "set_feature", "get_feature");
	const auto up_to = [](int p_most) { return String("1,") + itos(p_most); };
	ADD_PROPERTY(PropertyInfo(Variant::INT, "states", PROPERTY_HINT_RANGE,
						 up_to(steadyhand::TrainingOptions::MOST_STATES)),
			"set_states", "get_states");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "symbols", PROPERTY_HINT_RANGE,
						 up_to(steadyhand::TrainingOptions::MOST_SYMBOLS)),
			"set_symbols", "get_symbols");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "r2_threshold", PROPERTY_HINT_RANGE, "0,1,0.01"),
			"set_r2_threshold", "get_r2_threshold");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "without_task"), "set_without_task", "is_without_task");
	constexpr uint32_t READ_ONLY = PROPERTY_USAGE_NONE;
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "error_message", PROPERTY_HINT_NONE, "", READ_ONLY), "",
			"get_error_message");

	ADD_SIGNAL(MethodInfo("progressed", PropertyInfo(Variant::FLOAT, "done")));
}

} // namespace godot
