#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Whether two paths name the same file, also by links. False if one of them does not exist.
bool is_same_file(const String &p_path, const String &p_other);

/// Marks a file that a node is writing, so that no other node overwrites it. For the scene's thread.
class WrittenFile {
public:
	/// p_owner must outlive this object.
	WrittenFile(const Node &p_owner, const String &p_path);
	~WrittenFile();
	WrittenFile(const WrittenFile &) = delete;
	WrittenFile &operator=(const WrittenFile &) = delete;

	/// If another node is writing to the file, reports this node in the log and returns
	/// ERR_FILE_ALREADY_IN_USE.
	static Error check_free(const Node &p_for, const String &p_path);

private:
	/// Linked list of all. A container would be destroyed when the library is unloaded.
	static inline WrittenFile *first_ = nullptr;
	WrittenFile *next_;
	const Node &owner_;
	String path_;
};

} // namespace godot
