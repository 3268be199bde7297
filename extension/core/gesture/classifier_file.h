#pragma once

#include "base/result.h"
#include "gesture/classifier_model.h"

#include <memory>
#include <string>
#include <string_view>

namespace steadyhand {

/// Writes a ClassifierModel as JSON, with the conventions of model_file.h.
std::string format_classifier(const ClassifierModel &model);

/// Errors name the source, the line and the fault, as in parse_model().
Result<ClassifierModel> parse_classifier(std::string_view text, std::string_view source_name);

/// Classifier of the add-on's four gestures: models/gestures.classifier, embedded by the build. Parsed at the
/// first call.
std::shared_ptr<const ClassifierModel> own_classifier();

} // namespace steadyhand
