#pragma once

#include "tracking/track_csv.h"

#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Reads a track CSV. The error names file, line and column. Prints a warning for each clock jump that is
/// closed. If the last row is cut off, it reads the rows before, with a warning.
steadyhand::Result<steadyhand::Track> read_track_file(const String &p_path);

/// As read_track_file(). A track without frames is an error too.
steadyhand::Result<steadyhand::Track> read_recording(const String &p_path);

} // namespace godot
