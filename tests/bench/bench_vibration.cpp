// Time for a sample of the vibration, with its amplitude from the motion, compared with std::sin and memset
// in the same run. Rounds alternate and the median counts, so that other load affects all rows alike. A frame
// of two channels counts as one sample.

#include "haptics/vibration.h"
#include "timing.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

constexpr std::size_t BLOCK = 512;
static_assert(BLOCK == MOST_RUNS * RUN);
constexpr int BLOCKS = 100;
constexpr int ROUNDS = 201;
constexpr double RATE_HZ = 48000.0;
constexpr double BLOCK_S = static_cast<double>(BLOCK) / RATE_HZ;

alignas(64) std::array<float, 2 * BLOCK> block;

template <class Fill> double ns_per_sample(Fill fill) {
	const double ns = ns_of([&] {
		for (int i = 0; i < BLOCKS; ++i) {
			fill(i);
			keep(block);
		}
	});
	return ns / (static_cast<double>(BLOCK) * BLOCKS);
}

/// A hand that swings between 0.1 and 0.9 of its amplitude.
MotionSnapshot swinging(double from_s, std::uint32_t arrivals) {
	MotionSnapshot snapshot;
	snapshot.time_s = from_s;
	snapshot.period_s = 0.01;
	snapshot.count = 11;
	snapshot.amplitude_m = 0.2;
	snapshot.arrival = { arrivals, from_s, 1.0 };
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		const double w = 6.0;
		const double phase = w * (from_s + 0.01 * static_cast<double>(i));
		snapshot.knots[i] = { 0.5 - 0.4 * std::cos(phase), 0.4 * w * std::sin(phase),
			0.4 * w * w * std::cos(phase), true };
	}
	snapshot.fit();
	return snapshot;
}

/// Time with a new snapshot for each block. at_arrivals: an arrival every 40 ms. is_live: as on the audio
/// thread, with two channels, a clock that follows the game's, and 12 ms of latency compensation.
double ns_of_effect(const Effect &effect, bool at_arrivals, bool is_live = false) {
	Vibration vibration(RATE_HZ, is_live ? 2 : 1);
	EffectSet effects;
	effects.add(effect);
	vibration.set_effects(effects);
	vibration.seek(0.0);
	std::vector<MotionSnapshot> snapshots;
	for (int i = 0; i < BLOCKS; ++i) {
		const auto arrivals = static_cast<std::uint32_t>(at_arrivals ? 1 + i * BLOCK_S / 0.04 : 0);
		snapshots.push_back(swinging(i * BLOCK_S, arrivals));
	}
	const std::span<float> frames = std::span(block).first(is_live ? 2 * BLOCK : BLOCK);
	return ns_per_sample([&](int i) {
		vibration.set_motion(snapshots[static_cast<std::size_t>(i)]);
		if (is_live) {
			const double jitter_s = 1e-4 * (i * 7 % 5);
			vibration.follow(i * BLOCK_S + 0.012 + jitter_s);
		}
		vibration.render(frames);
	});
}

/// Time for the waveform alone, with a cubic amplitude.
double ns_of_spring_waveform() {
	Carrier carrier;
	carrier.set_step(phase_step(180.0, RATE_HZ));
	const Level level = Level::hermite(0.1, 0.01, 0.11, 0.01, MOST_RUNS);
	return ns_per_sample([&](int) {
		write_sine(block.data(), 1, carrier, level, 0, BLOCK / RUN);
		carrier.advance(BLOCK / RUN);
	});
}

double ns_of_impulse_waveform() {
	Run decay;
	decay.fill(0.9F);
	Mix mix;
	Carrier carrier;
	carrier.set_step(phase_step(300.0, RATE_HZ));
	return ns_per_sample([&](int) {
		clear(mix);
		for (std::size_t run = 0; run < BLOCK / RUN; ++run) {
			add_decaying_sine(mix, carrier, 0.1, decay, 0, run);
			keep(mix);
		}
		carrier.advance(BLOCK / RUN);
	});
}

} // namespace

int main() {
	double phase = 0.0;
	const auto sine = [&] {
		return ns_per_sample([&](int) {
			for (float &sample : std::span(block).first(BLOCK)) {
				sample = static_cast<float>(0.5 * std::sin(phase));
				phase += 2.0 * std::numbers::pi * 180.0 / RATE_HZ;
			}
		});
	};
	struct Row {
		const char *name;
		std::function<double()> measure;
		std::vector<double> ns;
	};
	std::vector<Row> rows{
		{ "spring, waveform", ns_of_spring_waveform, {} },
		{ "impulse, waveform", ns_of_impulse_waveform, {} },
		{ "spring", [] { return ns_of_effect(spring_effect(), false); }, {} },
		{ "spring, live", [] { return ns_of_effect(spring_effect(), false, true); }, {} },
		{ "impulse", [] { return ns_of_effect(impulse_effect(), true); }, {} },
		{ "inertial-viscous", [] { return ns_of_effect(inertial_viscous_effect(), true); }, {} },
		{ "silence", [] { return ns_of_effect(impulse_effect(), false); }, {} },
		{ "std::sin", sine, {} },
		{ "memset",
				[] {
					return ns_per_sample([](int) { std::memset(block.data(), 0, BLOCK * sizeof(float)); });
				},
				{} },
	};
	for (int round = 0; round < ROUNDS; ++round) {
		for (Row &row : rows) {
			row.ns.push_back(row.measure());
		}
	}
	const double sine_ns = median(rows[rows.size() - 2].ns), memset_ns = median(rows.back().ns);
	std::printf(
			"ns per sample at 48 kHz, a snapshot of the motion for each block of %zu, median of %d rounds\n",
			BLOCK, ROUNDS);
	for (const Row &row : rows) {
		const double ns = median(row.ns);
		std::printf("  %-17s %7.3f  %6.3f x std::sin  %6.1f x memset\n", row.name, ns, ns / sine_ns,
				ns / memset_ns);
	}
	return 0;
}
