#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace steadyhand {

/// Standard deviation of white noise whose second differences have these sizes, one and more, whose order is
/// lost: by their median, because half of them, whose deviation is s sqrt(6), are within 0.6745 of that.
[[nodiscard]] inline double deviation_of_bends(std::span<double> r_sizes) {
	constexpr double DEVIATION_PER_MEDIAN = 0.6053; // 1 / (0.6745 sqrt(6))
	const auto middle = r_sizes.begin() + static_cast<std::ptrdiff_t>(r_sizes.size() / 2);
	std::nth_element(r_sizes.begin(), middle, r_sizes.end());
	return DEVIATION_PER_MEDIAN * *middle;
}

/// The noise of a tracker that shakes from frame to frame, told by its latest bends: how much each step
/// differs from going on as before. Jumps are rare, and do not count.
class TrackerNoise {
public:
	/// Signed.
	void push(double bend) { bends_[count_++ % bends_.size()] = bend; }

	/// deviation_of_bends; 0 where they do not turn against the one before half of the time: those of white
	/// noise do in 0.73, those of a hand on its way do not. Infinite as long as there are too few.
	[[nodiscard]] double deviation() const {
		const std::size_t count = std::min(count_, bends_.size());
		if (count < FEWEST) {
			return INFINITY;
		}
		std::array<double, MOST> sizes{};
		std::size_t turns = 0;
		for (std::size_t i = 0; i < count; ++i) {
			sizes[i] = std::abs(bends_[i]);
			turns += bends_[i] * bends_[i > 0 ? i - 1 : count - 1] < 0.0 ? 1 : 0;
		}
		if (2 * turns < count) {
			return 0.0;
		}
		return deviation_of_bends(std::span(sizes).first(count));
	}

private:
	static constexpr std::size_t FEWEST = 6, MOST = 16;

	std::array<double, MOST> bends_{};
	std::size_t count_ = 0;
};

} // namespace steadyhand
