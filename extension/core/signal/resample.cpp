#include "signal/resample.h"

#include "signal/sample_clock.h"

#include <algorithm>
#include <limits>

namespace steadyhand {

namespace {

constexpr double INFINITY_S = std::numeric_limits<double>::infinity();

struct Sample {
	double t_s;
	double value;
};

/// Reads the usable samples of a stream, with one sample of look-ahead.
class SampleReader {
public:
	SampleReader(std::span<const double> times_s, std::span<const double> values) :
			times_s_(times_s), values_(values), count_(std::min(times_s.size(), values.size())) {
		find_next();
	}

	/// Advances to the last sample at or before t_s.
	void advance_to(double t_s) {
		while (next_.t_s <= t_s) {
			current_ = next_;
			find_next();
		}
	}

	[[nodiscard]] bool has_current() const { return current_.t_s > -INFINITY_S; }
	[[nodiscard]] bool has_next() const { return next_.t_s < INFINITY_S; }
	[[nodiscard]] const Sample &current() const { return current_; }
	[[nodiscard]] const Sample &next() const { return next_; }

private:
	void find_next() {
		for (; index_ < count_; ++index_) {
			if (is_usable(times_s_[index_]) && is_usable(values_[index_]) &&
					times_s_[index_] >= current_.t_s) {
				next_ = Sample{ times_s_[index_], values_[index_] };
				++index_;
				return;
			}
		}
		next_ = Sample{ INFINITY_S, 0.0 };
	}

	std::span<const double> times_s_;
	std::span<const double> values_;
	std::size_t count_;
	std::size_t index_ = 0;
	Sample current_{ -INFINITY_S, 0.0 };
	Sample next_{ INFINITY_S, 0.0 };
};

} // namespace

void resample_hold(std::span<const double> times_s, std::span<const double> values, double before,
		const UniformGrid &grid, std::span<double> out) {
	SampleReader reader(times_s, values);
	for (std::size_t i = 0; i < out.size(); ++i) {
		reader.advance_to(grid.time_s(i));
		out[i] = reader.has_current() ? reader.current().value : before;
	}
}

void resample_linear(std::span<const double> times_s, std::span<const double> values, const UniformGrid &grid,
		std::span<double> out) {
	SampleReader reader(times_s, values);
	for (std::size_t i = 0; i < out.size(); ++i) {
		const double t_s = grid.time_s(i);
		reader.advance_to(t_s);
		const Sample &from = reader.current();
		const Sample &to = reader.next();
		if (reader.has_current() && reader.has_next()) {
			const double share = (t_s - from.t_s) / (to.t_s - from.t_s);
			out[i] = from.value + share * (to.value - from.value);
		} else {
			out[i] = reader.has_current() ? from.value : to.value;
		}
	}
}

} // namespace steadyhand
