#include "gesture/model_file.h"

#include "gesture/feature.h"
#include "gesture/json_fields.h"
#include "gesture/recorded_hmms.h"
#include "gesture/reference_curve.h"
#include "gesture/task.h"
#include "tracking/csv_text.h"
#include "tracking/frame.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

using namespace json_fields;

namespace {

constexpr const char *MODEL_FORMAT = "steadyhand-gesture";
constexpr int MODEL_VERSION = 1;
/// Far more than a gesture needs. A file with more is damaged.
constexpr std::size_t MAX_STATES = 256;
/// Limits of what training can produce, with a margin. Beyond them the arithmetic of a frame can give NaN.
constexpr double SHORTEST_S = 1e-5;
constexpr double MOST_RELATIVE_DEVIATION = 100.0; // n recordings have at most sqrt(n)
constexpr double MOST_DEVIATION = 10.0;           // of the recordings, amplitudes
constexpr double AXIS_TOLERANCE = 0.01;           // of the length: trial sets round axes

Json element_to_json(const PrimitiveMotionElement &element) {
	return { { "phase_begin", element.phase_begin }, { "phase_end", element.phase_end },
		{ "polynomial", element.curve.coefficients }, { "deviation", element.deviation },
		{ "duration_mean_s", element.duration_mean_s },
		{ "duration_deviation_s", element.duration_deviation_s } };
}

/// Whether |value| of an element's curve is at most FARTHEST_VALUE.
bool is_bounded(const Polynomial &curve) {
	constexpr int POINTS = 101;
	for (int i = 0; i < POINTS; ++i) {
		if (!(std::abs(curve.value(i / (POINTS - 1.0))) <= FARTHEST_VALUE)) {
			return false;
		}
	}
	return true;
}

PrimitiveMotionElement element_from_json(const Json &json) {
	PrimitiveMotionElement element;
	element.phase_begin = number(json, "phase_begin");
	element.phase_end = number(json, "phase_end");
	if (!(element.phase_end - element.phase_begin >= SHORTEST_ELEMENT)) {
		throw Fault(json["phase_end"], "elements: phase_end must be phase_begin + 0.01 at least");
	}
	element.deviation = within(json, "deviation", 0.0, MOST_DEVIATION);
	element.duration_mean_s = within(json, "duration_mean_s", SHORTEST_S, LONGEST_GESTURE_S);
	element.duration_deviation_s =
			within(json, "duration_deviation_s", 0.0, MOST_RELATIVE_DEVIATION * element.duration_mean_s);
	const Eigen::VectorXd coefficients = vector(member(json, "polynomial"), "polynomial", false);
	if (coefficients.size() > static_cast<Eigen::Index>(element.curve.coefficients.size())) {
		throw Fault(json["polynomial"],
				"polynomial: more than " + std::to_string(element.curve.coefficients.size()) +
						" coefficients");
	}
	for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
		element.curve.coefficients[static_cast<std::size_t>(i)] = coefficients(i);
	}
	if (!is_bounded(element.curve)) {
		throw Fault(json["polynomial"], "polynomial: its values leave -2 .. 2");
	}
	return element;
}

Eigen::VectorXd reference(const Json &json, const char *key) {
	const Eigen::VectorXd curve = vector(array(json, key), key, false);
	if (curve.size() != CURVE_POINTS) {
		throw Fault(json[key],
				std::string(key) + ": " + std::to_string(curve.size()) + " points, not " +
						std::to_string(CURVE_POINTS));
	}
	return curve;
}

Provenance provenance_from_json(const Json &json) {
	Provenance provenance;
	provenance.trial_set = text(json, "trial_set");
	provenance.trained_with = text(json, "trained_with");
	const double recordings = number(json, "recordings");
	if (recordings < 0.0 || recordings > 1e9) {
		throw Fault(json["recordings"], "recordings: not a number of recordings");
	}
	provenance.recordings = static_cast<int>(recordings);
	provenance.r2_threshold = number(json, "r2_threshold");
	for (const Json &name : member(json, "dropped")) {
		provenance.dropped.push_back(name.is_string() ? name.get<std::string>() : std::string());
	}
	const Eigen::VectorXd objective = vector(member(json, "objective"), "objective", true);
	provenance.objective.assign(objective.begin(), objective.end());
	return provenance;
}

bool is_unit(const Eigen::Vector3d &axis) {
	return std::abs(axis.norm() - 1.0) < AXIS_TOLERANCE;
}

std::vector<Eigen::Vector3d> axes(const Json &json, const char *key) {
	std::vector<Eigen::Vector3d> axes;
	const Json &rows = member(json, key);
	if (!rows.is_array()) {
		throw Fault(rows, std::string(key) + ": not a list of axes");
	}
	for (const Json &row : rows) {
		const Eigen::VectorXd axis = vector(row, key, false);
		if (axis.size() != 3 || !is_unit(axis)) {
			throw Fault(row, std::string(key) + ": not an axis of length 1");
		}
		axes.emplace_back(axis);
	}
	return axes;
}

GestureModel model_from_json(const Json &json) {
	require_format(json, MODEL_FORMAT, MODEL_VERSION);
	GestureModel model;
	model.gesture = text(json, "gesture");
	if (const std::string_view fault = gesture_name_fault(model.gesture); !fault.empty()) {
		throw Fault(
				json["gesture"], "gesture: " + steadyhand::quoted(model.gesture) + " " + std::string(fault));
	}
	model.feature = text(json, "feature");
	if (find_feature(model.feature) == nullptr) {
		throw Fault(json["feature"], "feature: there is no feature '" + model.feature + "'");
	}
	model.typical_task.start_m = point(json, "typical_start_m");
	model.typical_task.axis = point(json, "typical_axis");
	if (!find_feature(model.feature)->is_radius && !is_unit(model.typical_task.axis)) {
		throw Fault(json["typical_axis"], "typical_axis: its length is not 1");
	}
	model.typical_task.amplitude_m = within(json, "typical_amplitude_m", SMALLEST_AMPLITUDE_M, FARTHEST_M);
	model.other_axes = axes(json, "other_axes");
	model.duration_mean_s = within(json, "duration_mean_s", SHORTEST_S, LONGEST_GESTURE_S);
	model.duration_deviation_s =
			within(json, "duration_deviation_s", 0.0, MOST_RELATIVE_DEVIATION * model.duration_mean_s);
	model.reference_mean = reference(json, "reference_mean");
	model.reference_deviation = reference(json, "reference_deviation");
	if (!(model.reference_deviation.minCoeff() >= 0.0)) {
		throw Fault(json["reference_deviation"], "reference_deviation: less than 0");
	}

	const Json &quantiser = member(json, "quantiser");
	const Eigen::MatrixXd codebook = matrix(quantiser, "codebook", false);
	const Eigen::VectorXd scale = vector(member(quantiser, "scale"), "scale", false);
	if (codebook.cols() != 2 || scale.size() != 2 || !(scale.minCoeff() > 0.0)) {
		throw Fault(quantiser, "quantiser: the codebook must be M x 2, the scale two numbers greater than 0");
	}
	model.quantiser = VectorQuantiser(codebook, scale);

	const Json &hmm = member(json, "hmm");
	Result<DiscreteHmm> checked = validated({ vector(array(hmm, "log_pi"), "log_pi", true),
			matrix(hmm, "log_a", true), matrix(hmm, "log_b", true) });
	if (!checked) {
		throw Fault(hmm, "hmm: " + checked.error());
	}
	model.hmm = std::move(checked).value();

	const Json &elements = array(json, "elements");
	if (elements.size() > MAX_STATES) {
		throw Fault(elements, "elements: more than " + std::to_string(MAX_STATES) + " states");
	}
	for (const Json &element : elements) {
		model.elements.push_back(element_from_json(element));
	}
	if (static_cast<Eigen::Index>(model.elements.size()) != model.hmm.states() ||
			model.quantiser.symbols() != model.hmm.symbols()) {
		throw Fault(elements, "the counts of states (elements) and symbols (codebook) differ from the hmm's");
	}
	double reached = 0.0;
	for (std::size_t i = 0; i < model.elements.size(); ++i) {
		if (model.elements[i].phase_begin != reached) {
			throw Fault(elements[i]["phase_begin"],
					"elements: each phase_begin must be the phase_end before it, and the first 0");
		}
		reached = model.elements[i].phase_end;
	}
	if (reached != 1.0) {
		throw Fault(elements.back()["phase_end"], "elements: the last phase_end must be 1");
	}
	if (json.contains("recorded_hmms")) {
		model.recorded_counts = counts_from_json(json["recorded_hmms"], *find_feature(model.feature));
		model.recorded_hmms = recorded_hmms(model.gesture, model.recorded_counts);
	}
	model.provenance = provenance_from_json(member(json, "provenance"));
	return model;
}

} // namespace

std::string format_model(const GestureModel &model) {
	Json elements = Json::array();
	for (const PrimitiveMotionElement &element : model.elements) {
		elements.push_back(element_to_json(element));
	}
	Json other_axes = Json::array();
	for (const Eigen::Vector3d &axis : model.other_axes) {
		other_axes.push_back(row_to_json(axis));
	}
	Json json = {
		{ "format", MODEL_FORMAT },
		{ "version", MODEL_VERSION },
		{ "gesture", model.gesture },
		{ "feature", model.feature },
		{ "typical_start_m", row_to_json(model.typical_task.start_m) },
		{ "typical_axis", row_to_json(model.typical_task.axis) },
		{ "typical_amplitude_m", model.typical_task.amplitude_m },
		{ "other_axes", other_axes },
		{ "duration_mean_s", model.duration_mean_s },
		{ "duration_deviation_s", model.duration_deviation_s },
		{ "elements", elements },
		{ "quantiser",
				{ { "scale", row_to_json(model.quantiser.scale()) },
						{ "codebook", matrix_to_json(model.quantiser.codebook()) } } },
		{ "hmm",
				{ { "log_pi", row_to_json(model.hmm.log_pi) }, { "log_a", matrix_to_json(model.hmm.log_a) },
						{ "log_b", matrix_to_json(model.hmm.log_b) } } },
		{ "reference_mean", row_to_json(model.reference_mean) },
		{ "reference_deviation", row_to_json(model.reference_deviation) },
	};
	if (!model.recorded_counts.empty()) {
		json["recorded_hmms"] = counts_to_json(model.recorded_counts);
	}
	json["provenance"] = { { "trial_set", model.provenance.trial_set },
		{ "trained_with", model.provenance.trained_with }, { "recordings", model.provenance.recordings },
		{ "r2_threshold", model.provenance.r2_threshold }, { "dropped", model.provenance.dropped },
		{ "objective", model.provenance.objective } };
	return json.dump(1, '\t', false, Json::error_handler_t::replace) + "\n";
}

Result<GestureModel> parse_model(std::string_view text, std::string_view source_name) {
	return read_text<GestureModel>(text, source_name, model_from_json);
}

} // namespace steadyhand
