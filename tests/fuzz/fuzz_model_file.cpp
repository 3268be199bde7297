// Any bytes are a model or one error; a model that was read is written and read back bit for bit, and its
// curve is finite.

#include "gesture/model_file.h"
#include "require.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace steadyhand {
namespace {

/// The suite runs in the repository's root.
std::string text_of(const char *path) {
	std::ifstream file(path);
	require(file.good(), "models/gestures.classifier can be read");
	return { std::istreambuf_iterator<char>(file), {} };
}

const std::string CLASSIFIER_TEXT = text_of("models/gestures.classifier");

} // namespace

extern const std::string_view OWN_CLASSIFIER;
const std::string_view OWN_CLASSIFIER = CLASSIFIER_TEXT;

} // namespace steadyhand

namespace {

void check_probabilities(const DiscreteHmm &hmm) {
	require(!hmm.log_pi.hasNaN() && !hmm.log_a.hasNaN() && !hmm.log_b.hasNaN(), "probabilities are numbers");
	require(hmm.log_pi.maxCoeff() < 1e-3 && hmm.log_a.maxCoeff() < 1e-3 && hmm.log_b.maxCoeff() < 1e-3,
			"probabilities are at most 1");
}

void check_curve(const GestureModel &model) {
	for (int i = -2; i <= 22; ++i) {
		for (const CurvePoint &point : { evaluate(model, 0.05 * i), evaluate_onwards(model, 0.05 * i) }) {
			require(std::isfinite(point.value) && std::isfinite(point.slope) &&
							std::isfinite(point.curvature),
					"the curve is finite");
		}
	}
	for (const double value : { -1.0, 0.0, 0.3, 0.95, 2.0 }) {
		const double phase = phase_of_value(model, value);
		require(phase >= 0.0 && phase <= 1.0, "the phase of a value is within 0..1");
	}
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	const std::string_view text(reinterpret_cast<const char *>(data), size);
	const Result<GestureModel> read = parse_model(text, "a.gesture");
	if (!read) {
		require(read.error().starts_with("a.gesture:"), "an error names the source");
		return 0;
	}
	const GestureModel &model = read.value();
	require(gesture_name_fault(model.gesture).empty(), "the gesture has a name that may be");
	require(model.reference_mean.allFinite() && model.reference_deviation.allFinite() &&
					model.quantiser.codebook().allFinite() && model.quantiser.scale().allFinite(),
			"references and codebook are finite");
	check_probabilities(model.hmm);
	check_curve(model);
	const std::string written = format_model(model);
	const Result<GestureModel> again = parse_model(written, "a.gesture");
	require(again.ok(), "what is written can be read");
	require(format_model(again.value()) == written, "what is read back is written the same");
	return 0;
}
