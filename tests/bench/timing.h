#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace steadyhand::bench {

/// Makes the compiler believe that the value is read.
template <class Value> void keep(const Value &value) {
	asm volatile("" : : "r"(&value) : "memory");
}

/// What calling f once takes.
template <class Function> double ns_of(Function f) {
	const auto begin = std::chrono::steady_clock::now();
	f();
	const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
	return spent.count();
}

inline double least(const std::vector<double> &values) {
	return *std::min_element(values.begin(), values.end());
}

inline double median(std::vector<double> values) {
	std::sort(values.begin(), values.end());
	return values[values.size() / 2];
}

} // namespace steadyhand::bench
