#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// By another name too; false where one of them is no file yet.
bool is_same_file(const String &p_path, const String &p_other);

/// A file that a node writes for some time: another's would destroy what it has written. Of the scene's
/// thread.
class WrittenFile {
public:
	/// p_owner outlives it.
	WrittenFile(const Node &p_owner, const String &p_path);
	~WrittenFile();
	WrittenFile(const WrittenFile &) = delete;
	WrittenFile &operator=(const WrittenFile &) = delete;

	/// Where another node writes to it, reports in the log which one, and returns ERR_FILE_ALREADY_IN_USE.
	static Error check_free(const Node &p_for, const String &p_path);

private:
	/// A list of all; no container, which would be destroyed when the library is unloaded.
	static inline WrittenFile *first_ = nullptr;
	WrittenFile *next_;
	const Node &owner_;
	String path_;
};

} // namespace godot
