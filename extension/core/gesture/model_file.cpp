#include "gesture/model_file.h"

#include "gesture/feature.h"
#include "gesture/reference_curve.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace steadyhand {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *FORMAT_NAME = "steadyhand-gesture";
constexpr int FORMAT_VERSION = 1;
/// Far more than any gesture needs; a file that asks for more is damaged.
constexpr std::size_t MAX_STATES = 256;

/// Found while reading; caught in parse_model, never leaves this file.
struct Fault : std::runtime_error {
	using std::runtime_error::runtime_error;
};

template <class Row> Json row_to_json(const Row &row) {
	Json out = Json::array();
	for (Eigen::Index i = 0; i < row.size(); ++i) {
		out.push_back(std::isfinite(row(i)) ? Json(row(i)) : Json());
	}
	return out;
}

template <class Matrix> Json matrix_to_json(const Matrix &matrix) {
	Json out = Json::array();
	for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
		out.push_back(row_to_json(matrix.row(i)));
	}
	return out;
}

const Json &member(const Json &object, const char *key) {
	if (!object.is_object() || !object.contains(key)) {
		throw Fault(std::string(key) + ": missing");
	}
	return object[key];
}

double number(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_number() || !std::isfinite(value.get<double>())) {
		throw Fault(std::string(key) + ": not a number");
	}
	return value.get<double>();
}

double positive(const Json &object, const char *key) {
	const double value = number(object, key);
	if (!(value > 0.0)) {
		throw Fault(std::string(key) + ": must be greater than 0");
	}
	return value;
}

std::string text(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_string()) {
		throw Fault(std::string(key) + ": not a string");
	}
	return value.get<std::string>();
}

/// False where it is missing, as in files of before there was the flag.
bool optional_flag(const Json &object, const char *key) {
	const auto found = object.find(key);
	if (found == object.end()) {
		return false;
	}
	if (!found->is_boolean()) {
		throw Fault(std::string(key) + ": not true or false");
	}
	return found->get<bool>();
}

const Json &array(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_array() || value.empty()) {
		throw Fault(std::string(key) + ": not an array with entries");
	}
	return value;
}

/// null stands for log 0 where `null_is_log_zero`, and is a fault elsewhere.
Eigen::VectorXd vector(const Json &values, const char *key, bool null_is_log_zero) {
	if (!values.is_array()) {
		throw Fault(std::string(key) + ": not an array");
	}
	Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
	for (std::size_t i = 0; i < values.size(); ++i) {
		if (values[i].is_null() && null_is_log_zero) {
			out(static_cast<Eigen::Index>(i)) = -std::numeric_limits<double>::infinity();
		} else if (values[i].is_number()) {
			out(static_cast<Eigen::Index>(i)) = values[i].get<double>();
		} else {
			throw Fault(std::string(key) + "[" + std::to_string(i) + "]: not a number");
		}
	}
	return out;
}

Eigen::Vector3d point(const Json &object, const char *key) {
	const Eigen::VectorXd values = vector(member(object, key), key, false);
	if (values.size() != 3) {
		throw Fault(std::string(key) + ": not three numbers");
	}
	return values;
}

Eigen::MatrixXd matrix(const Json &object, const char *key, bool null_is_log_zero) {
	const Json &rows = array(object, key);
	Eigen::MatrixXd out;
	for (std::size_t i = 0; i < rows.size(); ++i) {
		const Eigen::VectorXd row = vector(rows[i], key, null_is_log_zero);
		if (i == 0) {
			out.resize(static_cast<Eigen::Index>(rows.size()), row.size());
		}
		if (row.size() != out.cols()) {
			throw Fault(std::string(key) + ", row " + std::to_string(i) + ": " + std::to_string(row.size()) +
					" numbers where the first row has " + std::to_string(out.cols()));
		}
		out.row(static_cast<Eigen::Index>(i)) = row.transpose();
	}
	return out;
}

Json element_to_json(const PrimitiveMotionElement &element) {
	return { { "phase_begin", element.phase_begin }, { "phase_end", element.phase_end },
		{ "polynomial", element.curve.coefficients }, { "deviation", element.deviation },
		{ "duration_mean_s", element.duration_mean_s },
		{ "duration_deviation_s", element.duration_deviation_s } };
}

/// Of curves from 0 to 1 over a state: with larger ones their squares are no numbers.
constexpr double LARGEST_COEFFICIENT = 1e6;

PrimitiveMotionElement element_from_json(const Json &json) {
	PrimitiveMotionElement element;
	element.phase_begin = number(json, "phase_begin");
	element.phase_end = number(json, "phase_end");
	if (!(element.phase_begin < element.phase_end)) {
		throw Fault("elements: phase_begin must be less than phase_end");
	}
	element.deviation = number(json, "deviation");
	element.duration_mean_s = positive(json, "duration_mean_s");
	element.duration_deviation_s = number(json, "duration_deviation_s");
	const Eigen::VectorXd coefficients = vector(member(json, "polynomial"), "polynomial", false);
	if (coefficients.size() > static_cast<Eigen::Index>(element.curve.coefficients.size())) {
		throw Fault("polynomial: more than " + std::to_string(element.curve.coefficients.size()) +
				" coefficients");
	}
	if ((coefficients.array().abs() > LARGEST_COEFFICIENT).any()) {
		throw Fault("polynomial: a coefficient is beyond 1e6");
	}
	for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
		element.curve.coefficients[static_cast<std::size_t>(i)] = coefficients(i);
	}
	return element;
}

Eigen::VectorXd reference(const Json &json, const char *key) {
	const Eigen::VectorXd curve = vector(array(json, key), key, false);
	if (curve.size() != CURVE_POINTS) {
		throw Fault(std::string(key) + ": " + std::to_string(curve.size()) + " points, not " +
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
		throw Fault("recordings: not a number of recordings");
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

GestureModel model_from_json(const Json &json) {
	if (!json.is_object() || text(json, "format") != FORMAT_NAME) {
		throw Fault(std::string("format: not a ") + FORMAT_NAME + " file");
	}
	if (number(json, "version") != FORMAT_VERSION) {
		throw Fault("version: this program reads version " + std::to_string(FORMAT_VERSION));
	}
	GestureModel model;
	model.gesture = text(json, "gesture");
	model.feature = text(json, "feature");
	if (find_feature(model.feature) == nullptr) {
		throw Fault("feature: there is no feature '" + model.feature + "'");
	}
	model.typical_task.start_m = point(json, "typical_start_m");
	model.typical_task.axis = point(json, "typical_axis");
	model.typical_task.amplitude_m = positive(json, "typical_amplitude_m");
	model.both_ways = optional_flag(json, "both_ways");
	model.duration_mean_s = positive(json, "duration_mean_s");
	model.duration_deviation_s = number(json, "duration_deviation_s");
	model.reference_mean = reference(json, "reference_mean");
	model.reference_deviation = reference(json, "reference_deviation");

	const Json &quantiser = member(json, "quantiser");
	const Eigen::MatrixXd codebook = matrix(quantiser, "codebook", false);
	const Eigen::VectorXd scale = vector(member(quantiser, "scale"), "scale", false);
	if (codebook.cols() != 2 || scale.size() != 2 || !(scale.minCoeff() > 0.0)) {
		throw Fault("quantiser: the codebook must be M x 2, the scale two numbers greater than 0");
	}
	model.quantiser = VectorQuantiser(codebook, scale);

	const Json &hmm = member(json, "hmm");
	Result<DiscreteHmm> checked = validated({ vector(array(hmm, "log_pi"), "log_pi", true),
			matrix(hmm, "log_a", true), matrix(hmm, "log_b", true) });
	if (!checked) {
		throw Fault("hmm: " + checked.error());
	}
	model.hmm = std::move(checked).value();

	const Json &elements = array(json, "elements");
	if (elements.size() > MAX_STATES) {
		throw Fault("elements: more than " + std::to_string(MAX_STATES) + " states");
	}
	for (const Json &element : elements) {
		model.elements.push_back(element_from_json(element));
	}
	if (static_cast<Eigen::Index>(model.elements.size()) != model.hmm.states() ||
			model.quantiser.symbols() != model.hmm.symbols()) {
		throw Fault("the counts of states (elements) and symbols (codebook) differ from the hmm's");
	}
	double reached = 0.0;
	for (const PrimitiveMotionElement &element : model.elements) {
		if (element.phase_begin != reached) {
			throw Fault("elements: each phase_begin must be the phase_end before it, and the first 0");
		}
		reached = element.phase_end;
	}
	if (reached != 1.0) {
		throw Fault("elements: the last phase_end must be 1");
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
	Json json = {
		{ "format", FORMAT_NAME },
		{ "version", FORMAT_VERSION },
		{ "gesture", model.gesture },
		{ "feature", model.feature },
		{ "typical_start_m", row_to_json(model.typical_task.start_m) },
		{ "typical_axis", row_to_json(model.typical_task.axis) },
		{ "typical_amplitude_m", model.typical_task.amplitude_m },
		{ "both_ways", model.both_ways },
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
		{ "provenance",
				{ { "trial_set", model.provenance.trial_set },
						{ "trained_with", model.provenance.trained_with },
						{ "recordings", model.provenance.recordings },
						{ "r2_threshold", model.provenance.r2_threshold },
						{ "dropped", model.provenance.dropped },
						{ "objective", model.provenance.objective } } },
	};
	return json.dump(1, '\t', false, Json::error_handler_t::replace) + "\n";
}

Result<GestureModel> parse_model(std::string_view text, std::string_view source_name) {
	const std::string source(source_name);
	try {
		return model_from_json(Json::parse(text));
	} catch (const Json::parse_error &fault) {
		const std::string_view before = text.substr(0, fault.byte > 0 ? fault.byte - 1 : 0);
		const auto line = 1 + std::count(before.begin(), before.end(), '\n');
		return Error{ source + ":" + std::to_string(line) + ": not valid JSON" };
	} catch (const Json::exception &fault) {
		// The library's own label before it, as [json.exception.out_of_range.406], says nothing to a user.
		const std::string_view what = fault.what();
		return Error{ source + ": " + std::string(what.substr(what.find("] ") + 2)) };
	} catch (const Fault &fault) {
		return Error{ source + ": " + fault.what() };
	}
}

} // namespace steadyhand
