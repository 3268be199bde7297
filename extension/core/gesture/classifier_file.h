#pragma once

#include "base/result.h"
#include "gesture/classifier_model.h"

#include <memory>
#include <string>
#include <string_view>

namespace steadyhand {

/// The file format of a ClassifierModel: JSON text, as of model_file.h.
std::string format_classifier(const ClassifierModel &model);

/// Errors name the source, the line, and what is wrong there, as parse_model()'s.
Result<ClassifierModel> parse_classifier(std::string_view text, std::string_view source_name);

/// The classifier of the four gestures that the library brings: models/gestures.classifier as it was built
/// in. Read when it is first asked for.
std::shared_ptr<const ClassifierModel> own_classifier();

} // namespace steadyhand
