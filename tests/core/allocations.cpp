// Apart from code that allocates: GCC warns of a mismatch where it inlines only one of these.
#include "allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocated = 0;

} // namespace

std::size_t steadyhand::test::allocations() {
	return allocated;
}

void *operator new(std::size_t size) {
	++allocated;
	if (void *const memory = std::malloc(size)) {
		return memory;
	}
	throw std::bad_alloc();
}

void *operator new(std::size_t size, const std::nothrow_t & /*tag*/) noexcept {
	++allocated;
	return std::malloc(size);
}

void operator delete(void *memory) noexcept {
	std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept {
	std::free(memory);
}
