#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace steadyhand {

/// Lock-free queue of events from one writer thread to one reader thread. No side waits. A full ring refuses
/// events.
template <class Event, std::size_t CAPACITY> class EventRing {
	static_assert(CAPACITY > 0 && (CAPACITY & (CAPACITY - 1)) == 0, "so that the counters may roll over");
	static_assert(std::atomic<std::size_t>::is_always_lock_free);

public:
	/// For the writer's thread. False if fewer than `spare` slots would stay free; `event` is not changed
	/// then.
	bool push(Event &&event, std::size_t spare = 0) {
		const std::size_t written = written_.load(std::memory_order_relaxed);
		if (written - read_.load(std::memory_order_acquire) + spare >= CAPACITY) {
			return false;
		}
		events_[written % CAPACITY] = std::move(event);
		written_.store(written + 1, std::memory_order_release);
		return true;
	}

	/// Takes the oldest event. For the reader's thread. False if the ring is empty.
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
	// Each counter has its own cache line, because the threads write them independently.
	alignas(64) std::atomic<std::size_t> written_ = 0;
	alignas(64) std::atomic<std::size_t> read_ = 0;
};

} // namespace steadyhand
