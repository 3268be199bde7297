#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/json_fields.h"

namespace steadyhand::json_fields {

[[nodiscard]] Json reach_to_json(const GestureReach &reach);

/// Throws a Fault, as the functions of json_fields.h.
[[nodiscard]] GestureReach reach_from_json(const Json &json);

} // namespace steadyhand::json_fields
