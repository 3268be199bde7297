#pragma once

#include <godot_cpp/variant/string_name.hpp>

#include <atomic>
#include <cstddef>

namespace godot::internal {

// A StringName for the life of the library: made at its first use, since the engine is not there when static
// objects are constructed, and freed by free_all() while the engine still is, since it no longer is when they
// are destroyed. p_text must be a literal. Safe to use from any thread.
class CachedName {
	const char *text_;
	CachedName *next_ = nullptr;
	std::atomic<bool> ready_ = false;
	alignas(StringName) std::byte storage_[sizeof(StringName)] = {};

	static CachedName *first_;
	void make();

public:
	explicit constexpr CachedName(const char *p_text) : text_(p_text) {}

	const StringName &get() {
		if (!ready_.load(std::memory_order_acquire)) {
			make();
		}
		return *reinterpret_cast<const StringName *>(storage_);
	}

	static void free_all();
};

} // namespace godot::internal
