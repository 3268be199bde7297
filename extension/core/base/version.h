#pragma once

namespace steadyhand {

/// Version of models, evaluations and archives.
inline constexpr const char *VERSION = "0.1.0";

} // namespace steadyhand
