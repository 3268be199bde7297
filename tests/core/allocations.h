#pragma once

#include <cstddef>

namespace steadyhand::test {

/// Calls of operator new so far, by all threads.
[[nodiscard]] std::size_t allocations();

template <class Run> [[nodiscard]] std::size_t allocations_of(Run run) {
	const std::size_t before = allocations();
	run();
	return allocations() - before;
}

} // namespace steadyhand::test
