#pragma once

#include <array>
#include <cstddef>

namespace steadyhand {

/// Ring buffer of the newest CAPACITY items, the oldest first.
template <class Item, std::size_t CAPACITY> class Ring {
public:
	/// Drops the oldest item if the ring is full.
	void push(const Item &item) {
		if (count_ == CAPACITY) {
			drop_oldest();
		}
		items_[(first_ + count_) % CAPACITY] = item;
		++count_;
	}
	/// The ring must not be empty, also for drop_newest() and newest().
	void drop_oldest() {
		first_ = (first_ + 1) % CAPACITY;
		--count_;
	}
	void drop_newest() { --count_; }
	[[nodiscard]] const Item &newest() const { return (*this)[count_ - 1]; }
	void clear() { first_ = count_ = 0; }

	[[nodiscard]] Item &operator[](std::size_t i) { return items_[(first_ + i) % CAPACITY]; }
	[[nodiscard]] const Item &operator[](std::size_t i) const { return items_[(first_ + i) % CAPACITY]; }
	[[nodiscard]] std::size_t size() const { return count_; }
	[[nodiscard]] bool empty() const { return count_ == 0; }

private:
	std::array<Item, CAPACITY> items_{};
	std::size_t first_ = 0;
	std::size_t count_ = 0;
};

} // namespace steadyhand
