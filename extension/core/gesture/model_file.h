#pragma once

#include "base/result.h"
#include "gesture/gesture_model.h"

#include <string>
#include <string_view>

namespace steadyhand {

/// The one file format of a gesture model (`*.gesture`): JSON text, probabilities as natural logarithms with
/// -inf as null, numbers in the shortest form that reads back to the same bits. Described in docs/formats.md.
std::string format_model(const GestureModel &model);

/// Errors name the source, the line, and what is wrong there (malformed text) or the key (missing, wrong
/// type, sizes that do not belong together, an unknown feature, a version that is too new).
Result<GestureModel> parse_model(std::string_view text, std::string_view source_name);

} // namespace steadyhand
