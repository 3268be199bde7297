#pragma once

#include "base/result.h"

#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/variant/string.hpp>

#include <string>
#include <string_view>

namespace godot {

// Whole files of text through the engine, so that res:// and user:// work, inside an exported project too.

/// The error names the path and the engine's reason.
steadyhand::Result<std::string> read_text_file(const String &p_path);

/// Replaces what is there, in one step: nobody sees a half of it. Reports a failure in the engine's log, with
/// the path.
Error write_text_file(const String &p_path, std::string_view p_text);

/// Whether all that was stored in the file, up to where it is now, is there; writes it through. FileAccess
/// does not tell of a full disk where its buffer took the last of it.
bool is_written(const Ref<FileAccess> &p_file);

/// "No such file: p_path" and the like, for a path that did not open.
String cannot_open(const String &p_path, Error p_error);

} // namespace godot
