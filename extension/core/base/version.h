#pragma once

namespace steadyhand {

/// The one place where the version stands: models, evaluations and archives take it from here.
inline constexpr const char *VERSION = "0.1.0";

} // namespace steadyhand
