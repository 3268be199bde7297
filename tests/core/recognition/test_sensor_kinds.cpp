#include "metrics/curve_comparison.h"
#include "minimum_jerk_drag.h"
#include "monitored_estimator.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace steadyhand;

// `phase` mode with sensors of several rates, noise levels, resolutions and clocks. Values are in amplitudes.

namespace {

struct Sensor {
	const char *name;
	double rate_hz = 113.0;
	double white = 2e-4;
	double resolution = 0.0; ///< rounding step; 0: none
	int reads = 1;           ///< number of readings of each frame
	double outliers = 0.0;   ///< fraction of the frames
	double tick_s = 0.0;     ///< resolution of its clock
};

struct Figures {
	double shown = 0.0, estimated = 0.0; ///< zero-lag R2
};

/// Means over drags of 0.7 to 1.2 s.
Figures figures(const Sensor &sensor) {
	const GestureModel &model = test::drag_model();
	constexpr int DRAGS = 20;
	constexpr int MS = 2600;
	Figures sum;
	for (int drag_number = 0; drag_number < DRAGS; ++drag_number) {
		const test::Drag drag{ .onset_s = 0.8, .duration_s = 0.7 + 0.025 * drag_number, .amplitude_m = 1.0 };
		std::mt19937_64 random(static_cast<unsigned>(drag_number));
		std::normal_distribution<double> normal;
		std::uniform_real_distribution<double> uniform;
		test::MonitoredEstimator estimator(model);
		std::vector<double> reference, shown, estimated;
		double seen = 0.0;
		int frames = 0;
		for (int ms = 0; ms < MS; ++ms) {
			const double t_s = ms / 1000.0;
			for (; frames / sensor.rate_hz <= t_s; ++frames) {
				if (frames % sensor.reads == 0) {
					seen = drag.x_m(frames / sensor.rate_hz) + sensor.white * normal(random);
					seen += uniform(random) < sensor.outliers ? 0.1 * normal(random) : 0.0;
					seen = sensor.resolution > 0.0 ? std::round(seen / sensor.resolution) * sensor.resolution
												   : seen;
				}
				const double frame_s = frames / sensor.rate_hz;
				estimator.push(
						sensor.tick_s > 0.0 ? std::floor(frame_s / sensor.tick_s) * sensor.tick_s : frame_s,
						seen);
			}
			reference.push_back(drag.x_m(t_s));
			shown.push_back(seen);
			estimated.push_back(estimator.at(t_s).value);
		}
		const UniformGrid grid{ 0.0, 1000.0 };
		const GestureSpan span{ drag.onset_s, drag.onset_s + drag.duration_s };
		sum.shown += compare_curves(reference, shown, grid, span).r2_zero / DRAGS;
		sum.estimated += compare_curves(reference, estimated, grid, span).r2_zero / DRAGS;
	}
	return sum;
}

} // namespace

TEST_CASE("phase mode is as accurate as the data of any sensor" * doctest::test_suite("figures")) {
	for (const Sensor &sensor : {
				 Sensor{ .name = "white noise of 2 mm in 20 cm", .white = 0.01 },
				 Sensor{ .name = "white noise of 10 mm", .white = 0.05 },
				 Sensor{ .name = "rounded to 1 mm", .resolution = 0.005 },
				 Sensor{ .name = "30 Hz, read four times", .rate_hz = 120.0, .reads = 4 },
				 Sensor{ .name = "one frame in fifty an outlier", .outliers = 0.02 },
				 Sensor{ .name = "15 Hz", .rate_hz = 15.0 },
				 Sensor{ .name = "1 kHz", .rate_hz = 1000.0 },
				 Sensor{ .name = "1 kHz, stamps of 4 ms", .rate_hz = 1000.0, .tick_s = 0.004 },
				 Sensor{ .name = "10 kHz", .rate_hz = 10000.0 },
		 }) {
		INFO(std::string(sensor.name));
		const Figures mean = figures(sensor);
		CAPTURE(mean.shown);
		CHECK(mean.estimated > mean.shown - 0.0006);
	}
}
