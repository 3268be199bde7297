#pragma once

#include "base/result.h"
#include "gesture/gesture_model.h"

#include <string>
#include <string_view>

namespace steadyhand {

/// Writes a gesture model (`*.gesture`) as JSON. Probabilities are natural logarithms, with null for
/// -infinity. Numbers have the shortest form that reads back to the same bits. docs/formats.md has the
/// format.
std::string format_model(const GestureModel &model);

/// Errors name the source, the line and the fault: malformed text, or a key that is missing, has a wrong type
/// or size, names an unknown feature, or is a newer version.
Result<GestureModel> parse_model(std::string_view text, std::string_view source_name);

} // namespace steadyhand
