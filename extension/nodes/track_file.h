#pragma once

#include "tracking/track_csv.h"

#include <godot_cpp/variant/string.hpp>

namespace godot {

/// A track CSV through the engine's files; the error names file, line and column.
/// Prints a warning for each clock jump that is closed up. Of a file that was cut off in its last row it
/// reads what is before that, with a warning.
steadyhand::Result<steadyhand::Track> read_track_file(const String &p_path);

} // namespace godot
