#pragma once

#include "gesture_model.h"
#include "trial_set.h"

#include "gesture/trainer.h"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <atomic>
#include <vector>

namespace godot {

/// Trains a GestureModel from a trial set.
class GestureTrainer : public RefCounted {
	GDCLASS(GestureTrainer, RefCounted)

	String feature_;
	int states_ = 4;
	int symbols_ = 16;
	double r2_threshold_ = 0.9;
	bool without_task_ = true;
	std::atomic<bool> is_training_ = false;
	std::atomic<bool> cancelled_ = false;
	std::vector<steadyhand::NormalisedRecording> recordings_; ///< from the last training
	String error_message_;                                    ///< from the last training

	Ref<GestureModel> train_on(const Ref<TrialSet> &p_trial_set, const StringName &p_gesture);
	/// Null.
	Ref<GestureModel> fail(const String &p_reason);

protected:
	static void _bind_methods();
	void _validate_property(PropertyInfo &p_property) const;

public:
	void set_feature(const String &p_feature) { feature_ = p_feature; }
	String get_feature() const { return feature_; }
	void set_states(int p_states);
	int get_states() const { return states_; }
	void set_symbols(int p_symbols);
	int get_symbols() const { return symbols_; }
	void set_r2_threshold(double p_threshold);
	double get_r2_threshold() const { return r2_threshold_; }
	void set_without_task(bool p_enabled) { without_task_ = p_enabled; }
	bool is_without_task() const { return without_task_; }

	/// Null if it is cancelled. Null, and one error in the log, if it fails.
	Ref<GestureModel> train(const Ref<TrialSet> &p_trial_set, const StringName &p_gesture);
	/// Trains the classifier of the add-on's four gestures and writes it to a file. Blocks for about 10 s.
	static Error write_own_classifier(const String &p_path);
	/// Cancels a running training. May be called from any thread.
	void cancel() { cancelled_ = cancelled_ || is_training_; }
	bool is_cancelled() const { return cancelled_; }
	/// Why the last train() gave no model; empty if it gave one or was cancelled.
	String get_error_message() const { return error_message_; }
	TypedArray<Dictionary> get_recordings() const;
	static String get_version();
};

} // namespace godot
