#pragma once

#include "base/result.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/string.hpp>

#include <string>
#include <string_view>

namespace godot {

// Reads and writes whole text files by the engine, so that res:// and user:// also work in an exported
// project.

/// The error names the path and the engine's reason.
steadyhand::Result<std::string> read_text_file(const String &p_path);

/// Replaces the file in one step, so a half-written file never exists. Reports a failure with the path in the
/// engine's log.
Error write_text_file(const String &p_path, std::string_view p_text);

/// Flushes the file. Whether all data up to the present position is on the disk. FileAccess does not report a
/// full disk while data is in its buffer.
bool is_written(const Ref<FileAccess> &p_file);

/// Why p_path did not open, with the path.
String cannot_open(const String &p_path, Error p_error);

} // namespace godot
