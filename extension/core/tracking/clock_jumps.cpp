#include "tracking/clock_jumps.h"

#include "tracking/csv_text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace steadyhand {

namespace {

constexpr std::size_t WARNINGS_MAX = 10; // jumps with a warning of their own

bool is_jump(double step_s) {
	return step_s > LONGEST_STEP_S;
}

std::vector<double> steps_s(const std::vector<HandFrame> &frames) {
	std::vector<double> steps;
	steps.reserve(frames.size());
	for (std::size_t i = 1; i < frames.size(); ++i) {
		steps.push_back(frames[i].t_s - frames[i - 1].t_s);
	}
	return steps;
}

/// Median of at least one value; of an even count, the lower of the two in the middle.
double median(std::vector<double> values) {
	const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
	std::nth_element(values.begin(), middle, values.end());
	return *middle;
}

/// The number with six significant digits.
std::string rounded(double number) {
	std::array<char, 32> digits;
	const auto written = std::to_chars(
			digits.data(), digits.data() + digits.size(), number, std::chars_format::general, 6);
	return { digits.data(), written.ptr };
}

} // namespace

std::vector<std::string> close_clock_jumps(
		std::vector<HandFrame> &r_frames, std::string_view source, std::size_t first_line) {
	std::vector<std::string> warnings;
	const auto warn = [&](std::size_t frame, std::string_view what) {
		warnings.push_back(error_at(source, first_line + frame, "t", what).message);
	};
	const std::vector<double> steps = steps_s(r_frames);
	const auto jumps = static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), is_jump));
	if (jumps == 0) {
		return warnings;
	}
	const double period_s = median(steps);
	if (is_jump(period_s)) {
		warn(1, "most rows are more than an hour apart; times must be in seconds");
		return warnings;
	}
	double removed_s = 0.0;
	std::size_t passed = 0;
	for (std::size_t i = 1; i < r_frames.size(); ++i) {
		if (const double step_s = steps[i - 1]; is_jump(step_s)) {
			removed_s = r_frames[i].t_s - (r_frames[i - 1].t_s + period_s);
			if (++passed <= WARNINGS_MAX) {
				warn(i,
						"the clock jumps by " + rounded(step_s) + " s; this row is read as " +
								rounded(period_s) + " s after the row above");
			} else if (passed == jumps) {
				warn(i, std::to_string(jumps - WARNINGS_MAX) + " more clock jumps up to this line");
			}
		}
		// Rounding must not make a time smaller than the one before.
		r_frames[i].t_s = std::max(r_frames[i].t_s - removed_s, r_frames[i - 1].t_s);
	}
	return warnings;
}

} // namespace steadyhand
