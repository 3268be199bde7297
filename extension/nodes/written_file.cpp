#include "written_file.h"

#include "conversions.h"
#include "node_label.h"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <filesystem>
#include <string>

namespace godot {

namespace {

// A path of char has the system's encoding, which on Windows is not UTF-8.
std::filesystem::path to_system(const String &p_path) {
	const std::string utf8 = to_core(ProjectSettings::get_singleton()->globalize_path(p_path));
	return std::u8string(utf8.begin(), utf8.end());
}

} // namespace

bool is_same_file(const String &p_path, const String &p_other) {
	std::error_code is_none;
	return std::filesystem::equivalent(to_system(p_path), to_system(p_other), is_none);
}

WrittenFile::WrittenFile(const Node &p_owner, const String &p_path) :
		next_(first_), owner_(p_owner), path_(p_path) {
	first_ = this;
}

WrittenFile::~WrittenFile() {
	WrittenFile **link = &first_;
	while (*link != this) {
		link = &(*link)->next_;
	}
	*link = next_;
}

Error WrittenFile::check_free(const Node &p_for, const String &p_path) {
	for (const WrittenFile *file = first_; file != nullptr; file = file->next_) {
		ERR_FAIL_COND_V_MSG(&file->owner_ != &p_for && is_same_file(file->path_, p_path),
				ERR_FILE_ALREADY_IN_USE,
				node_label(p_for) + String(": ") + p_path + String(" is being written by ") +
						node_label(file->owner_) + String(". Give each a file of its own"));
	}
	return OK;
}

} // namespace godot
