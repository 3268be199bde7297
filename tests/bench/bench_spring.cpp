// What a sample of the spring waveform costs, beside std::sin and memset on the same machine in the same run.
// Rounds of the three alternate and the median counts, so that a busy machine slows all alike.

#include "haptics/spring.h"
#include "timing.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

namespace {

using namespace steadyhand::bench;

constexpr std::size_t BLOCK = 512;
constexpr int BLOCKS = 4000;
constexpr int ROUNDS = 15;

std::array<float, BLOCK> block;

template <class Fill> double ns_per_sample(Fill fill) {
	const double ns = ns_of([&] {
		for (int i = 0; i < BLOCKS; ++i) {
			fill(i);
			keep(block);
		}
	});
	return ns / (static_cast<double>(BLOCK) * BLOCKS);
}

} // namespace

int main() {
	steadyhand::SpringWaveform spring(48000.0);
	double sine_phase = 0.0;
	std::vector<double> spring_ns;
	std::vector<double> sine_ns;
	std::vector<double> memset_ns;
	for (int round = 0; round < ROUNDS; ++round) {
		spring_ns.push_back(ns_per_sample([&](int i) { spring.render(block, i % 2 == 0 ? 0.3 : 0.8); }));
		sine_ns.push_back(ns_per_sample([&](int) {
			for (float &sample : block) {
				sample = static_cast<float>(0.5 * std::sin(sine_phase));
				sine_phase += 2.0 * std::numbers::pi * 180.0 / 48000.0;
			}
		}));
		memset_ns.push_back(ns_per_sample([&](int) { std::memset(block.data(), 0, sizeof(block)); }));
	}
	const double spring_median = median(spring_ns);
	std::printf("ns a sample at 48 kHz, blocks of %zu, median of %d rounds\n", BLOCK, ROUNDS);
	std::printf("  spring    %7.3f\n", spring_median);
	std::printf("  std::sin  %7.3f  (%.1f x spring)\n", median(sine_ns), median(sine_ns) / spring_median);
	std::printf("  memset    %7.3f  (%.2f x spring)\n", median(memset_ns), median(memset_ns) / spring_median);
	return 0;
}
