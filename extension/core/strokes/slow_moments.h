#pragma once

#include <array>
#include <cstddef>

namespace steadyhand {

/// Moments after which the hand was never slower again, in the order of time and of speed. Moment has a
/// member speed_m_s. A moment whose speed is less than SPEED_RATIO times the one before is left out.
template <class Moment> class SlowMoments {
public:
	void clear() { count_ = 0; }
	void push(const Moment &now) {
		while (count_ > 0 && moments_[count_ - 1].speed_m_s >= now.speed_m_s) {
			--count_;
		}
		const bool is_faster = count_ == 0 || now.speed_m_s > SPEED_RATIO * moments_[count_ - 1].speed_m_s;
		if (is_faster && count_ < moments_.size()) {
			moments_[count_++] = now;
		}
	}
	/// The last moment below this speed; nullptr if there is none.
	[[nodiscard]] const Moment *last_slower_than(double speed_m_s) const {
		for (std::size_t i = count_; i > 0; --i) {
			if (moments_[i - 1].speed_m_s < speed_m_s) {
				return &moments_[i - 1];
			}
		}
		return nullptr;
	}

private:
	static constexpr double SPEED_RATIO = 1.1;
	static constexpr std::size_t MOST = 112; ///< from 1 mm/s to 40 m/s

	std::array<Moment, MOST> moments_{};
	std::size_t count_ = 0;
};

} // namespace steadyhand
