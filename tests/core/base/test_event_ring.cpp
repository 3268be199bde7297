#include "base/event_ring.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <thread>

using namespace steadyhand;

TEST_CASE("event ring: a full ring refuses and keeps what it has") {
	EventRing<std::string, 4> ring;
	std::string event;
	CHECK_FALSE(ring.pop(event));
	for (const char *text : { "a", "b", "c", "d" }) {
		CHECK(ring.push(text));
	}
	std::string refused = "e";
	CHECK_FALSE(ring.push(std::move(refused)));
	CHECK(refused == "e"); // NOLINT(bugprone-use-after-move): a refused event stays as it was
	for (const char *text : { "a", "b", "c", "d" }) {
		CHECK(ring.pop(event));
		CHECK(event == text);
	}
	CHECK_FALSE(ring.pop(event));
}

TEST_CASE("event ring: spare slots stay free for more important events") {
	EventRing<int, 8> ring;
	int pushed = 0;
	while (ring.push(0, 3)) {
		++pushed;
	}
	CHECK(pushed == 5);
	CHECK(ring.push(5));
	CHECK(ring.push(6));
	CHECK(ring.push(7));
	CHECK_FALSE(ring.push(8));
}

TEST_CASE("event ring: events of another thread come whole and in order") {
	struct Event {
		std::uint64_t a = 0, b = 0;
	};
	EventRing<Event, 16> ring;
	constexpr std::uint64_t COUNT = 100000;
	std::thread writer([&ring] {
		for (std::uint64_t i = 1; i <= COUNT;) {
			if (ring.push({ i, ~i })) {
				++i;
			} else {
				std::this_thread::yield();
			}
		}
	});
	std::uint64_t expected = 1, wrong = 0;
	while (expected <= COUNT) {
		Event event;
		if (ring.pop(event)) {
			wrong += event.a == expected && event.b == ~expected ? 0 : 1;
			++expected;
		} else {
			std::this_thread::yield();
		}
	}
	writer.join();
	CHECK(wrong == 0);
}
