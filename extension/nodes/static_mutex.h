#pragma once

#include <atomic>

namespace steadyhand {

/// A mutex for a static variable: no code runs when the library is loaded or unloaded. MinGW's std::mutex has
/// a non-trivial constructor and destructor.
class StaticMutex {
public:
	void lock() {
		while (is_locked_.test_and_set(std::memory_order_acquire)) {
			is_locked_.wait(true, std::memory_order_relaxed);
		}
	}
	void unlock() {
		is_locked_.clear(std::memory_order_release);
		is_locked_.notify_one();
	}

private:
	std::atomic_flag is_locked_;
};

} // namespace steadyhand
