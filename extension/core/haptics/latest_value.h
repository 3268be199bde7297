#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace steadyhand {

/// Hands the newest of a row of values from one thread to one other, wait-free on both sides (a triple
/// buffer): the writer never waits for the reader, the reader never sees half a value and never the same one
/// twice. What is overtaken is lost.
template <class Value> class LatestValue {
	static_assert(std::is_trivially_copyable_v<Value>, "copied on the audio thread");

public:
	/// The writer's thread only.
	void publish(const Value &value) {
		slots_[back_] = value;
		back_ = middle_.exchange(back_ | FRESH, std::memory_order_acq_rel) & INDEX;
	}

	/// The reader's thread only: the newest value, which stays valid until the next call; null where none has
	/// come since the last one.
	[[nodiscard]] const Value *take() {
		if ((middle_.load(std::memory_order_relaxed) & FRESH) == 0) {
			return nullptr;
		}
		front_ = middle_.exchange(front_, std::memory_order_acq_rel) & INDEX;
		return &slots_[front_];
	}

private:
	static constexpr std::uint32_t INDEX = 3;
	static constexpr std::uint32_t FRESH = 4;
	static_assert(std::atomic<std::uint32_t>::is_always_lock_free);

	std::array<Value, 3> slots_{};
	std::uint32_t back_ = 0;
	std::uint32_t front_ = 1;
	std::atomic<std::uint32_t> middle_ = 2;
};

} // namespace steadyhand
