#include <godot_cpp/core/cached_name.hpp>

#include <mutex>
#include <new>

namespace godot::internal {

namespace {
std::mutex names_mutex;
} // namespace

CachedName *CachedName::first_ = nullptr;

void CachedName::make() {
	const std::lock_guard lock(names_mutex);
	if (!ready_.load(std::memory_order_relaxed)) {
		new (storage_) StringName(text_);
		next_ = first_;
		first_ = this;
		ready_.store(true, std::memory_order_release);
	}
}

void CachedName::free_all() {
	const std::lock_guard lock(names_mutex);
	for (CachedName *name = first_; name != nullptr; name = name->next_) {
		reinterpret_cast<StringName *>(name->storage_)->~StringName();
		name->ready_.store(false, std::memory_order_relaxed);
	}
	first_ = nullptr;
}

} // namespace godot::internal
