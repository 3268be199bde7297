#include "written_file.h"

#include "conversions.h"
#include "node_label.h"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <filesystem>

namespace godot {

bool is_same_file(const String &p_path, const String &p_other) {
	const ProjectSettings *const settings = ProjectSettings::get_singleton();
	std::error_code is_none;
	return std::filesystem::equivalent(
			to_core(settings->globalize_path(p_path)), to_core(settings->globalize_path(p_other)), is_none);
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
						node_label(file->owner_) + String("; give each a file of its own"));
	}
	return OK;
}

} // namespace godot
