#include "text_file.h"

#include "conversions.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot {

String cannot_open(const String &p_path, Error p_error) {
	if (DirAccess::dir_exists_absolute(p_path)) {
		return p_path + String(": this is a folder, not a file");
	}
	const String folder = p_path.get_base_dir();
	if (!folder.is_empty() && !DirAccess::dir_exists_absolute(folder)) {
		return p_path + String(": there is no folder ") + folder;
	}
	switch (p_error) {
		case ERR_FILE_NOT_FOUND:
			return p_path + String(": there is no such file");
		case ERR_FILE_NO_PERMISSION:
		case ERR_UNAUTHORIZED:
			return p_path + String(": no permission to open this file");
		default:
			return p_path + String(": this file cannot be opened (Godot's error ") + itos(p_error) +
					String(")");
	}
}

steadyhand::Result<std::string> read_text_file(const String &p_path) {
	if (p_path.is_empty()) {
		return steadyhand::Error{ "no file is named" };
	}
	const Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::READ);
	if (file.is_null()) {
		return steadyhand::Error{ to_core(cannot_open(p_path, FileAccess::get_open_error())) };
	}
	const PackedByteArray bytes = file->get_buffer(static_cast<int64_t>(file->get_length()));
	return std::string(reinterpret_cast<const char *>(bytes.ptr()), static_cast<std::size_t>(bytes.size()));
}

bool is_written(const Ref<FileAccess> &p_file) {
	const std::uint64_t end = p_file->get_position();
	p_file->flush();
	return p_file->get_error() == OK && p_file->get_length() == end;
}

Error write_text_file(const String &p_path, std::string_view p_text) {
	const String part = p_path + String(".part");
	const Ref<FileAccess> file = FileAccess::open(part, FileAccess::WRITE);
	ERR_FAIL_COND_V_MSG(
			file.is_null(), FileAccess::get_open_error(), cannot_open(p_path, FileAccess::get_open_error()));
	PackedByteArray bytes;
	bytes.resize(static_cast<int64_t>(p_text.size()));
	std::copy(p_text.begin(), p_text.end(), bytes.ptrw());
	file->store_buffer(bytes);
	Error error = is_written(file) ? OK : ERR_FILE_CANT_WRITE;
	file->close();
	error = error == OK ? DirAccess::rename_absolute(part, p_path) : error;
	if (error != OK) {
		DirAccess::remove_absolute(part);
	}
	ERR_FAIL_COND_V_MSG(
			error != OK, error, p_path + String(": this file cannot be written. Is the disk full?"));
	return OK;
}

} // namespace godot
