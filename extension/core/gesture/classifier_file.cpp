#include "gesture/classifier_file.h"

#include "gesture/gesture_model.h"
#include "gesture/json_fields.h"
#include "gesture/reach_fields.h"
#include "tracking/csv_text.h"

#include <cmath>
#include <utility>

namespace steadyhand {

extern const std::string_view OWN_CLASSIFIER; // text of models/gestures.classifier; the build embeds it

using namespace json_fields;

namespace {

constexpr const char *CLASSIFIER_FORMAT = "steadyhand-classifier";
constexpr int CLASSIFIER_VERSION = 1;
constexpr int SIZE = MotionCodebook::Point::RowsAtCompileTime;

Json gesture_to_json(const DirectedHmm &gesture) {
	Json json = { { "gesture", gesture.gesture } };
	json.update(reach_to_json(gesture));
	json["log_pi"] = row_to_json(gesture.hmm.log_pi);
	json["log_a"] = matrix_to_json(gesture.hmm.log_a);
	json["log_b"] = matrix_to_json(gesture.hmm.log_b);
	return json;
}

DirectedHmm gesture_from_json(const Json &json, int symbols) {
	DirectedHmm gesture;
	gesture.gesture = text(json, "gesture");
	if (const std::string_view fault = gesture_name_fault(gesture.gesture); !fault.empty()) {
		throw Fault(json["gesture"],
				"gesture: " + steadyhand::quoted(gesture.gesture) + " " + std::string(fault));
	}
	static_cast<GestureReach &>(gesture) = reach_from_json(json);
	Result<DiscreteHmm> checked = validated({ vector(array(json, "log_pi"), "log_pi", true),
			matrix(json, "log_a", true), matrix(json, "log_b", true) });
	if (!checked) {
		throw Fault(json, "gesture: " + checked.error());
	}
	gesture.hmm = std::move(checked).value();
	if (gesture.hmm.states() < END_STATES + 2) {
		throw Fault(json["log_pi"],
				"log_pi: fewer than " + std::to_string(END_STATES + 2) +
						" states, so the gesture never ends");
	}
	if (gesture.hmm.symbols() != symbols) {
		throw Fault(json["log_b"], "log_b: must have one column for each codeword");
	}
	return gesture;
}

ClassifierModel classifier_from_json(const Json &json) {
	require_format(json, CLASSIFIER_FORMAT, CLASSIFIER_VERSION);
	const Json &quantiser = member(json, "quantiser");
	const Eigen::MatrixXd codebook = matrix(quantiser, "codebook", false);
	const Eigen::VectorXd scale = vector(member(quantiser, "scale"), "scale", false);
	if (codebook.cols() != SIZE || scale.size() != SIZE || !(scale.minCoeff() > 0.0)) {
		const std::string size = std::to_string(SIZE);
		throw Fault(quantiser,
				"quantiser: the codebook must be M x " + size + ", the scale " + size +
						" numbers greater than 0");
	}
	ClassifierModel model;
	model.codebook = MotionCodebook(codebook, scale);
	for (const Json &gesture : array(json, "gestures")) {
		model.gestures.push_back(gesture_from_json(gesture, model.codebook.symbols()));
	}
	const Json &other = member(json, "other");
	const Eigen::MatrixXd other_log_a = matrix(other, "log_a", true);
	Result<DiscreteHmm> checked = validated(
			{ vector(array(other, "log_pi"), "log_pi", true), other_log_a, matrix(other, "log_b", true) });
	if (!checked) {
		throw Fault(other, "other: " + checked.error());
	}
	model.other = std::move(checked).value();
	if (model.other.symbols() != model.codebook.symbols()) {
		throw Fault(other["log_b"], "log_b: must have one column for each codeword");
	}
	return model;
}

} // namespace

std::string format_classifier(const ClassifierModel &model) {
	Json gestures = Json::array();
	for (const DirectedHmm &gesture : model.gestures) {
		gestures.push_back(gesture_to_json(gesture));
	}
	const Json json = {
		{ "format", CLASSIFIER_FORMAT },
		{ "version", CLASSIFIER_VERSION },
		{ "quantiser",
				{ { "scale", row_to_json(model.codebook.scale()) },
						{ "codebook", matrix_to_json(model.codebook.codebook()) } } },
		{ "gestures", gestures },
		{ "other",
				{ { "log_pi", row_to_json(model.other.log_pi) },
						{ "log_a", matrix_to_json(model.other.log_a) },
						{ "log_b", matrix_to_json(model.other.log_b) } } },
	};
	// A line for each row of numbers. No string of the format contains a bracket.
	std::string lines;
	for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
		if (c == '{' || c == '[') {
			lines += lines.ends_with('\n') || lines.empty() ? "" : "\n";
		}
		lines += c;
	}
	return lines + "\n";
}

std::shared_ptr<const ClassifierModel> own_classifier() {
	// Never destroyed, because users may outlive the static objects of the library.
	static const auto *const own = [] {
		Result<ClassifierModel> read = parse_classifier(OWN_CLASSIFIER, "gestures.classifier");
		return new std::shared_ptr<const ClassifierModel>(
				std::make_shared<const ClassifierModel>(std::move(read).value()));
	}();
	return *own;
}

Result<ClassifierModel> parse_classifier(std::string_view text, std::string_view source_name) {
	return read_text<ClassifierModel>(text, source_name, classifier_from_json);
}

} // namespace steadyhand
