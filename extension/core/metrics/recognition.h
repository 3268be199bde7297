#pragma once

#include <cstddef>
#include <vector>

namespace steadyhand {

/// What was recognised against what was done: gestures 0 .. gestures - 1, and `none` as the last row and
/// column.
class ConfusionTable {
public:
	explicit ConfusionTable(std::size_t gestures) : classes_(gestures + 1), counts_(classes_ * classes_, 0) {}

	[[nodiscard]] std::size_t none() const { return classes_ - 1; }

	/// An index beyond the gestures counts as none.
	void add(std::size_t done, std::size_t recognised) { ++counts_[cell(done, recognised)]; }

	[[nodiscard]] std::size_t count(std::size_t done, std::size_t recognised) const {
		return counts_[cell(done, recognised)];
	}

	[[nodiscard]] std::size_t trials(std::size_t done) const {
		std::size_t sum = 0;
		for (std::size_t recognised = 0; recognised < classes_; ++recognised) {
			sum += count(done, recognised);
		}
		return sum;
	}

	/// Share of the trials of `done` that were taken for `recognised`; 0 if there were none.
	[[nodiscard]] double rate(std::size_t done, std::size_t recognised) const {
		const std::size_t all = trials(done);
		return all == 0 ? 0.0 : static_cast<double>(count(done, recognised)) / static_cast<double>(all);
	}

private:
	[[nodiscard]] std::size_t cell(std::size_t done, std::size_t recognised) const {
		const auto row = done < classes_ ? done : none();
		const auto column = recognised < classes_ ? recognised : none();
		return row * classes_ + column;
	}

	std::size_t classes_;
	std::vector<std::size_t> counts_;
};

/// Gestures recognised while none was made, per minute of such motion; 0 if there was no such motion.
[[nodiscard]] inline double false_alarms_per_minute(std::size_t alarms, double observed_s) {
	return observed_s > 0.0 ? 60.0 * static_cast<double>(alarms) / observed_s : 0.0;
}

} // namespace steadyhand
