#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace steadyhand {

/// Hands events from one thread to one other in order, without locks: neither side ever waits. What comes
/// when the ring is full is refused.
template <class Event, std::size_t CAPACITY> class EventRing {
	static_assert(CAPACITY > 0 && (CAPACITY & (CAPACITY - 1)) == 0, "so that the counters may roll over");
	static_assert(std::atomic<std::size_t>::is_always_lock_free);

public:
	/// The writer's thread only. False where fewer than `spare` slots would stay free, with `event` as it
	/// was.
	bool push(Event &&event, std::size_t spare = 0) {
		const std::size_t written = written_.load(std::memory_order_relaxed);
		if (written - read_.load(std::memory_order_acquire) + spare >= CAPACITY) {
			return false;
		}
		events_[written % CAPACITY] = std::move(event);
		written_.store(written + 1, std::memory_order_release);
		return true;
	}

	/// The reader's thread only: the oldest event. False where there is none.
	bool pop(Event &r_event) {
		const std::size_t read = read_.load(std::memory_order_relaxed);
		if (read == written_.load(std::memory_order_acquire)) {
			return false;
		}
		r_event = std::move(events_[read % CAPACITY]);
		read_.store(read + 1, std::memory_order_release);
		return true;
	}

private:
	std::array<Event, CAPACITY> events_{};
	alignas(64) std::atomic<std::size_t> written_ =
			0; // a cache line each, as both threads write all the time
	alignas(64) std::atomic<std::size_t> read_ = 0;
};

} // namespace steadyhand
