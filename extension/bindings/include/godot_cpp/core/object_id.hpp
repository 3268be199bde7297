#pragma once

#include <cstdint>

namespace godot {

// Refers to an object without owning it. ObjectDB::get_instance() returns null if the object was freed.
class ObjectID {
	uint64_t id_ = 0;

public:
	ObjectID() = default;
	explicit ObjectID(uint64_t p_id) : id_(p_id) {}
	ObjectID &operator=(uint64_t p_id) {
		id_ = p_id;
		return *this;
	}

	bool is_valid() const { return id_ != 0; }
	bool is_null() const { return id_ == 0; }
	operator uint64_t() const { return id_; }
};

} // namespace godot
