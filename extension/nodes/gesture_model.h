#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>

#include <memory>

namespace steadyhand {
struct GestureModel;
}

namespace godot {

/// One trained gesture as a resource. The core's model is immutable: parse_text() replaces it as a whole, and
/// users of the old one share its ownership.
class GestureModel : public Resource {
	GDCLASS(GestureModel, Resource)

	std::shared_ptr<const steadyhand::GestureModel> model_;

protected:
	static void _bind_methods();

public:
	/// Null before a model is loaded, trained or parsed.
	const std::shared_ptr<const steadyhand::GestureModel> &core() const { return model_; }
	void set_core(std::shared_ptr<const steadyhand::GestureModel> p_model);

	StringName get_gesture() const;
	String get_feature() const;
	int get_state_count() const;
	int get_symbol_count() const;
	double get_typical_amplitude() const;
	double get_duration_mean() const;
	double get_duration_deviation() const;
	Dictionary get_provenance() const;

	PackedFloat64Array get_reference_mean() const;
	PackedFloat64Array get_reference_deviation() const;
	Dictionary get_element(int p_state) const;
	double evaluate(double p_phase) const;

	/// The content of a *.gesture file; empty if no model is loaded.
	String to_text() const;
	/// For the property that scenes and duplicates store: an empty text clears the model.
	void set_text(const String &p_text);
	Error parse_text(const String &p_text);

	/// Null, and one error in the log, if the file is no gesture model.
	static Ref<GestureModel> load_file(const String &p_path);
};

} // namespace godot
