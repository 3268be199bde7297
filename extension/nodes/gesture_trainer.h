#pragma once

#include "gesture_model.h"
#include "trial_set.h"

#include <godot_cpp/classes/ref_counted.hpp>

namespace godot {

/// Trains a GestureModel from a trial set.
class GestureTrainer : public RefCounted {
	GDCLASS(GestureTrainer, RefCounted)

	String feature_ = "index_along_axis";
	int states_ = 4;
	int symbols_ = 16;
	double r2_threshold_ = 0.9;

protected:
	static void _bind_methods();
	void _validate_property(PropertyInfo &p_property) const;

public:
	void set_feature(const String &p_feature) { feature_ = p_feature; }
	String get_feature() const { return feature_; }
	void set_states(int p_states) { states_ = p_states; }
	int get_states() const { return states_; }
	void set_symbols(int p_symbols) { symbols_ = p_symbols; }
	int get_symbols() const { return symbols_; }
	void set_r2_threshold(double p_threshold) { r2_threshold_ = p_threshold; }
	double get_r2_threshold() const { return r2_threshold_; }

	/// Null and one error in the log where it fails.
	Ref<GestureModel> train(const Ref<TrialSet> &p_trial_set, const StringName &p_gesture);
};

} // namespace godot
