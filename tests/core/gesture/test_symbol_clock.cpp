// Times of the symbols.

#include "gesture/symbol_clock.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

TEST_CASE("the symbol clock's first instant is at or after its start") {
	constexpr double A_LITTLE_S = 1e-9;
	for (int i = -200; i < 2000; ++i) {
		CAPTURE(i);
		const double instant_s = i * SymbolClock::PERIOD_S;
		SymbolClock clock;
		clock.start(instant_s);
		CHECK(clock.next_s() == instant_s);
		CHECK(clock.due(instant_s));
		clock.start(instant_s - A_LITTLE_S);
		CHECK(clock.next_s() == instant_s);
		clock.start(instant_s + A_LITTLE_S);
		CHECK(clock.next_s() == (i + 1) * SymbolClock::PERIOD_S);
	}
}

TEST_CASE("the symbol clock advances by 0.01 s") {
	SymbolClock clock;
	clock.start(0.065);
	for (int i = 7; i < 1000; ++i) {
		CHECK(clock.next_s() == i * SymbolClock::PERIOD_S);
		CHECK_FALSE(clock.due(std::nextafter(clock.next_s(), 0.0)));
		clock.advance();
	}
}
