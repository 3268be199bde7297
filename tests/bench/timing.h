#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace steadyhand::bench {

/// Prevents the compiler from optimising the value away.
template <class Value> void keep(const Value &value) {
	asm volatile("" : : "r"(&value) : "memory");
}

/// Processor time of this thread for one call of f, ns. Time of other threads does not count.
template <class Function> double ns_of(Function f) {
	const auto now_ns = [] {
		timespec now{};
		clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
		return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
	};
	const double begin_ns = now_ns();
	f();
	return now_ns() - begin_ns;
}

inline double least(const std::vector<double> &values) {
	return *std::min_element(values.begin(), values.end());
}

inline double median(std::vector<double> values) {
	std::sort(values.begin(), values.end());
	return values[values.size() / 2];
}

} // namespace steadyhand::bench
