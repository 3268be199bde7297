#include "haptics/live_vibration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

using namespace steadyhand;

// Built with ThreadSanitizer: a race ends the program with its own exit status.

namespace {

MotionSnapshot at(double time_s) {
	MotionSnapshot snapshot;
	snapshot.time_s = time_s;
	snapshot.period_s = 0.01;
	snapshot.count = 11;
	snapshot.amplitude_m = 0.2;
	snapshot.knots.fill({ 0.5 + 0.5 * std::sin(time_s), 0.0, 0.0, true });
	snapshot.arrival = { static_cast<std::uint32_t>(time_s * 10.0), time_s, 0.5 };
	return snapshot;
}

} // namespace

TEST_CASE("no reader sees half a value while another thread writes") {
	using Values = std::array<std::uint64_t, 100>;
	LatestValue<Values> box;
	constexpr std::uint64_t LAST = 20000;
	std::thread writer([&box] {
		Values values{};
		for (std::uint64_t i = 1; i <= LAST; ++i) {
			values.fill(i);
			box.publish(values);
		}
	});
	std::uint64_t before = 0, torn = 0, backwards = 0;
	while (before < LAST) {
		if (const Values *const values = box.take()) {
			torn += std::count_if(values->begin(), values->end(),
							[&](std::uint64_t value) { return value != values->front(); }) != 0
					? 1
					: 0;
			backwards += values->front() <= before ? 1 : 0;
			before = values->front();
		}
	}
	writer.join();
	CHECK(torn == 0);
	CHECK(backwards == 0);
}

TEST_CASE("the audio thread mixes while the scene's changes motion and effects, and frees old tables") {
	const auto link = std::make_shared<VibrationLink>();
	LiveVibration vibration(link, 48000.0, 2);
	std::atomic<bool> over = false;
	float largest = 0.0F;
	std::thread audio([&] {
		std::vector<float> frames(1024);
		while (!over) {
			vibration.render(frames);
			for (const float sample : frames) {
				largest = std::max(largest, std::abs(sample));
			}
		}
	});
	std::vector<std::pair<std::uint64_t, std::vector<float>>> tables;
	std::size_t most_tables = 0;
	for (std::uint64_t generation = 1; generation <= 3000; ++generation) {
		const double time_s = 0.016 * static_cast<double>(generation);
		if (generation % 3 == 0) {
			tables.emplace_back(generation, std::vector<float>(100, 0.5F));
			Effect effect = impulse_effect();
			effect.shape = Shape::SAMPLES;
			effect.table = { tables.back().second.data(), 100 };
			EffectSet effects = effects_of_gesture("horizontal_drag");
			effects.add(effect);
			effects.generation = generation;
			link->effects.publish(effects);
			const std::uint64_t oldest = link->oldest_generation.load(std::memory_order_acquire);
			std::erase_if(tables, [&](auto &table) {
				if (table.first < oldest) {
					std::fill(table.second.begin(), table.second.end(), 1000.0F);
				}
				return table.first < oldest;
			});
			most_tables = std::max(most_tables, tables.size());
		}
		link->motion.publish({ at(time_s), time_s });
		std::this_thread::yield();
	}
	over = true;
	audio.join();
	CHECK(largest <= 1.0F);
	CHECK(most_tables > 0);
}
