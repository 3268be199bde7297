#pragma once

#include <godot_cpp/variant/string_name.hpp>

#include <atomic>
#include <cstddef>

namespace godot::internal {

// A StringName that exists while the library is loaded. It is made at its first use and freed by free_all(),
// because the engine is not available while static objects are constructed and destroyed. p_text must be a
// literal. Any thread may use it.
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
