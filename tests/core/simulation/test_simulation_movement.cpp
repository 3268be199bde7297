#include "base/random.h"
#include "near.h"
#include "simulation/gesture_motion.h"
#include "simulation/oscillation.h"
#include "simulation/other_motion.h"
#include "simulation/progress.h"
#include "simulation/subject.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace steadyhand;

namespace {

/// Kolmogorov-Smirnov distance of a sample from a distribution, times sqrt(n): beyond 1.95 with probability
/// 0.001.
double kolmogorov(std::vector<double> sample, const std::function<double(double)> &distribution) {
	std::sort(sample.begin(), sample.end());
	const auto count = static_cast<double>(sample.size());
	double distance = 0.0;
	for (std::size_t i = 0; i < sample.size(); ++i) {
		const double expected = distribution(sample[i]);
		distance = std::max({ distance, expected - static_cast<double>(i) / count,
				static_cast<double>(i + 1) / count - expected });
	}
	return distance * std::sqrt(count);
}

struct Moments {
	double mean = 0.0;
	double deviation = 0.0;
};

Moments moments_of(const std::vector<double> &sample) {
	Moments moments;
	for (const double x : sample) {
		moments.mean += x / static_cast<double>(sample.size());
	}
	for (const double x : sample) {
		moments.deviation += (x - moments.mean) * (x - moments.mean) / static_cast<double>(sample.size() - 1);
	}
	moments.deviation = std::sqrt(moments.deviation);
	return moments;
}

std::vector<double> instants(double from, double to, double step) {
	std::vector<double> points(static_cast<std::size_t>((to - from) / step));
	for (std::size_t i = 0; i < points.size(); ++i) {
		points[i] = from + static_cast<double>(i) * step;
	}
	return points;
}

double rate_of(const std::function<double(double)> &curve, double t) {
	constexpr double STEP = 1e-5;
	return (curve(t + STEP) - curve(t - STEP)) / (2.0 * STEP);
}

/// Time of the peak speed of a single submovement, as a fraction of the duration, by brute force.
double peak_fraction_of(double bend) {
	const Progress progress(0.0, { { 0.0, 1.0, 1.0, bend } }, {});
	double best_t = 0.0;
	double best_rate = 0.0;
	for (const double t : instants(0.0, 1.0, 1e-4)) {
		const double rate = rate_of([&progress](double s) { return progress.at(s); }, t);
		if (rate > best_rate) {
			best_rate = rate;
			best_t = t;
		}
	}
	return best_t;
}

} // namespace

TEST_SUITE("random numbers") {
	TEST_CASE("SplitMix64's first number for seed 0 is the published one") {
		CHECK(mix_bits(0) == 0xE220A8397B1DCDAFU);
		static_assert(mix_bits(1) != mix_bits(0));
		CHECK(stream_seed(1, 0) != stream_seed(0, 1));
	}

	TEST_CASE("uniform, normal and waiting times follow their distributions") {
		Random random(20261121);
		std::vector<double> uniform;
		std::vector<double> normal;
		std::vector<double> waiting;
		for (int i = 0; i < 20000; ++i) {
			uniform.push_back(random.uniform());
			normal.push_back(random.normal());
			waiting.push_back(random.waiting_time(4.0));
		}
		CHECK(kolmogorov(uniform, [](double x) { return x; }) < 1.95);
		CHECK(kolmogorov(normal, [](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }) < 1.95);
		CHECK(kolmogorov(waiting, [](double x) { return 1.0 - std::exp(-4.0 * x); }) < 1.95);
		CHECK(std::isinf(random.waiting_time(0.0)));
	}

	TEST_CASE("equal seeds give equal numbers, neighbouring ones unrelated numbers") {
		Random first(1);
		Random again(1);
		Random neighbour(2);
		double correlation = 0.0;
		for (int i = 0; i < 10000; ++i) {
			const double x = first.normal();
			CHECK(x == again.normal());
			correlation += x * neighbour.normal() / 10000.0;
		}
		CHECK(std::abs(correlation) < 0.04); // 4 deviations
	}
}

TEST_SUITE("simulated movement") {
	TEST_CASE("progress without bend has the closed form of minimum jerk") {
		// Flash and Hogan 1985: peak velocity 1.875 A / D half way, peak acceleration 5.77 A / D^2 at (3 -
		// sqrt 3) / 6.
		const double amplitude = 0.2;
		const double duration_s = 1.3;
		const Progress progress(0.0, { { 0.0, duration_s, amplitude, 0.0 } }, {});
		const auto at = [&progress](double t) { return progress.at(t); };
		const auto velocity = [&at](double t) { return rate_of(at, t); };
		CHECK(velocity(0.5 * duration_s) == test::near(1.875 * amplitude / duration_s).epsilon(1e-6));
		CHECK(progress.at(0.5 * duration_s) == test::near(0.5 * amplitude).epsilon(1e-12));
		const double steepest_s = (3.0 - std::sqrt(3.0)) / 6.0 * duration_s;
		CHECK(rate_of(velocity, steepest_s) ==
				test::near(10.0 / std::sqrt(3.0) * amplitude / (duration_s * duration_s)).epsilon(1e-4));
		CHECK(progress.at(-1.0) == 0.0);
		CHECK(progress.at(9.0) == test::near(amplitude));
	}

	TEST_CASE("bend_for_peak gives the requested time of the peak velocity") {
		CHECK(bend_for_peak(0.5) == test::near(0.0));
		for (const double peak : { 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7 }) {
			CHECK(peak_fraction_of(bend_for_peak(peak)) == test::near(peak).epsilon(2e-3));
		}
	}

	TEST_CASE("progress has no step in position, velocity or acceleration") {
		const Progress progress(0.01,
				{ { 0.0, 1.0, 0.9, 0.4 }, { 0.9, 0.2, 0.08, 0.0 }, { 1.1, 0.15, -0.02, 0.0 } },
				{ { 0.4, 0.1 } });
		CHECK(progress.duration_s() == test::near(1.35));
		// The largest third derivative of these submovements is 60 A / D^3 = 600 /s^3 (0.08 in 0.2 s), and a
		// hesitation increases it: the acceleration changes by less than 2000 /s^3 times the step.
		const double step_s = 1e-4;
		double previous = 0.0;
		for (const double t_s : instants(-0.1, 1.5, step_s)) {
			const double acceleration =
					(progress.at(t_s + step_s) - 2.0 * progress.at(t_s) + progress.at(t_s - step_s)) /
					(step_s * step_s);
			CHECK(std::abs(acceleration - previous) < 2000.0 * step_s);
			previous = acceleration;
		}
	}

	TEST_CASE("a hesitation almost stops the hand and delays the end by lost_s") {
		const Progress steady(0.0, { { 0.0, 1.0, 1.0, 0.0 } }, {});
		const Progress hesitant(0.0, { { 0.0, 1.0, 1.0, 0.0 } }, { { 0.4, 0.2 } });
		CHECK(hesitant.at(0.4) == steady.at(0.4));
		CHECK(hesitant.at(1.0) == test::near(steady.at(0.8)));
		double slowest = 1e9;
		for (const double t_s : instants(0.41, 0.79, 1e-3)) {
			slowest = std::min(slowest, rate_of([&hesitant](double t) { return hesitant.at(t); }, t_s));
		}
		CHECK(slowest > 0.0);
		CHECK(slowest < 0.15 * 1.875);
	}

	TEST_CASE("crossing_s and settling_s agree with a scan") {
		const Progress progress(0.02, { { 0.0, 1.0, 0.92, 0.3 }, { 0.95, 0.2, 0.06, 0.0 } }, {});
		double crossed_s = 0.0;
		while (progress.at(crossed_s) < 0.8) {
			crossed_s += 1e-5;
		}
		CHECK(progress.crossing_s(0.8) == test::near(crossed_s).epsilon(2e-5));
		double settled_s = 2.0;
		while (std::abs(progress.at(settled_s) - 1.0) <= 0.02) {
			settled_s -= 1e-5;
		}
		CHECK(progress.settling_s(0.02) == test::near(settled_s).epsilon(2e-5));
		CHECK(progress.crossing_s(2.0) == progress.duration_s());
		CHECK(progress.stretched(3.0).at(2.1) == test::near(progress.at(0.7)));
		CHECK(progress.stretched(3.0).settling_s(0.02) == test::near(3.0 * settled_s).epsilon(2e-5));
	}

	TEST_CASE("tremor has the set deviation and frequency band") {
		Random random(4);
		const Oscillation tremor(8.0, 12.0, 1e-4, random);
		double square = 0.0;
		int crossings = 0;
		const int count = 200000;
		for (int i = 0; i < count; ++i) {
			const double x = tremor.at(i * 1e-3).x();
			square += x * x / count;
			crossings += (x > 0.0) != (tremor.at((i + 1) * 1e-3).x() > 0.0) ? 1 : 0;
		}
		CHECK(std::sqrt(square) == test::near(1e-4).epsilon(0.05));
		CHECK(crossings / 2 > 8 * 200);
		CHECK(crossings / 2 < 12 * 200);
	}

	TEST_CASE("durations over people and trials are the paper's") {
		// 400 people, 3 trials each. Standard deviation of the mean of a log-normal whose variance is mostly
		// between people.
		for (const auto &[name, mean_s, deviation_s] : { std::tuple{ "horizontal_drag", 1.26, 0.25 },
					 { "zoom", 0.88, 0.12 }, { "tap", 0.35, 0.15 } }) {
			const SimulatedGesture *const gesture = find_simulated_gesture(name);
			REQUIRE(gesture != nullptr);
			Random random(8);
			std::vector<double> durations_s;
			for (std::uint32_t person = 0; person < 400; ++person) {
				const Subject subject = draw_subject(Population::TRAIN, person);
				for (int i = 0; i < 3; ++i) {
					const GestureTask task = draw_task(*gesture, HandPosition::STABLE, random);
					const TrueMotion motion =
							make_gesture_motion(*gesture, task, HandPosition::STABLE, subject, 0.0, random);
					durations_s.push_back(motion.end_s - motion.start_s);
				}
			}
			const Moments moments = moments_of(durations_s);
			CHECK(std::abs(moments.mean - mean_s) < 4.0 * deviation_s / std::sqrt(400.0));
			CHECK(moments.deviation == test::near(deviation_s).epsilon(0.2));
		}
	}

	TEST_CASE("a requested duration holds from onset to end, within the limits") {
		for (const SimulatedGesture &gesture : simulated_gestures()) {
			for (const double asked_s : { 0.01, 0.15, 0.5, 1.26, 4.0, 60.0 }) {
				Random random(9);
				const GestureTask task = draw_task(gesture, HandPosition::UNSTABLE, random);
				const Subject subject = draw_subject(Population::TUNE, 3);
				const TrueMotion motion =
						make_gesture_motion(gesture, task, HandPosition::UNSTABLE, subject, asked_s, random);
				CHECK(motion.end_s - motion.start_s == test::near(std::clamp(asked_s, 0.15, 4.0)));
				CHECK(motion.start_s >= 0.5);
				CHECK(motion.span_s - motion.end_s >= 0.8);
			}
		}
	}

	TEST_CASE("aimed gestures stay at their end; strikes pass it and return") {
		for (const SimulatedGesture &gesture : simulated_gestures()) {
			for (std::uint32_t person = 0; person < 50; ++person) {
				Random random(person);
				const Subject subject = draw_subject(Population::TUNE, person);
				const Progress progress = make_progress(gesture, subject, 0.8, random);
				CHECK(std::abs(progress.at(0.0)) < 0.05);
				double deepest = 0.0;
				for (const double t_s : instants(0.0, 5.0, 1e-3)) {
					deepest = std::max(deepest, progress.at(t_s));
				}
				if (gesture.through_max_m > 0.0) {
					CHECK(progress.at(0.8) == test::near(1.0));
					CHECK(rate_of([&progress](double t) { return progress.at(t); }, 0.8) > 0.3);
					CHECK((deepest - 1.0) * gesture.amplitude_m > 0.008);
					CHECK((deepest - 1.0) * gesture.amplitude_m < 0.042);
					CHECK(progress.at(5.0) < 0.6);
				} else {
					const double last = progress.at(5.0);
					CHECK(last > 0.75);
					CHECK(last < 1.25);
					for (const double t_s : instants(0.801, 2.0, 1e-3)) {
						CHECK(std::abs(progress.at(t_s) - last) <= 0.0201);
					}
				}
			}
		}
	}

	TEST_CASE("a drag moves along its axis in either direction") {
		Random random(12);
		const SimulatedGesture *const gesture = find_simulated_gesture("vertical_drag");
		REQUIRE(gesture != nullptr);
		int upward = 0;
		for (int i = 0; i < 100; ++i) {
			const GestureTask task = draw_task(*gesture, HandPosition::STABLE, random);
			CHECK(std::abs(task.axis.y()) == 1.0);
			upward += task.axis.y() > 0.0 ? 1 : 0;
			const Subject subject = draw_subject(Population::TUNE, 1);
			const TrueMotion motion =
					make_gesture_motion(*gesture, task, HandPosition::STABLE, subject, 0.0, random);
			const Eigen::Vector3d way_m = motion.hand(motion.end_s).position(Joint::INDEX) -
					motion.hand(motion.start_s).position(Joint::INDEX);
			CHECK(way_m.dot(task.axis) == test::near(0.2).epsilon(0.25));
			CHECK((motion.hand(0.0).position(Joint::INDEX) - task.start_m).norm() < 0.03);
		}
		CHECK(upward > 30);
		CHECK(upward < 70);
		CHECK(find_simulated_gesture("wave") == nullptr);
	}

	TEST_CASE("other motions have the properties of their kinds") {
		const Subject subject = draw_subject(Population::TUNE, 2);
		for (const OtherMotion &kind : other_motions()) {
			double way_m = 0.0;
			double along_m = 0.0;
			double farthest_m = 0.0;
			double palm_m = 0.0, spread_m = 0.0; ///< by which palm, and index from thumb, change places
			for (std::uint64_t seed = 0; seed < 20; ++seed) {
				Random random(seed);
				const TrueMotion motion = make_other_motion(kind, HandPosition::STABLE, subject, 6.0, random);
				CHECK(motion.span_s == 6.0);
				const HandFrame first = motion.hand(0.0);
				const Eigen::Vector3d place_m = first.position(Joint::INDEX);
				const auto span_m = [](const HandFrame &hand) {
					return (hand.position(Joint::INDEX) - hand.position(Joint::THUMB)).norm();
				};
				Eigen::Vector3d previous_m = place_m;
				for (const double t_s : instants(0.01, 6.0, 0.01)) {
					const HandFrame hand = motion.hand(t_s);
					const Eigen::Vector3d now_m = hand.position(Joint::INDEX);
					palm_m = std::max(
							palm_m, (hand.position(Joint::PALM) - first.position(Joint::PALM)).norm());
					spread_m = std::max(spread_m, std::abs(span_m(hand) - span_m(first)));
					way_m += (now_m - previous_m).norm() / 20.0;
					along_m = std::max(along_m, (now_m - previous_m).norm() / 0.01);
					farthest_m = std::max(farthest_m, (now_m - place_m).norm());
					previous_m = now_m;
				}
			}
			CHECK(along_m < 3.0); // m/s: faster than a hand
			CHECK(farthest_m < 0.5);
			if (kind.name == "idle") {
				CHECK(farthest_m < 0.01);
			} else {
				CHECK(way_m > 0.2);
			}
			CHECK((palm_m < 0.01) == (kind.name == "idle" || kind.name == "fidgeting"));
			CHECK((spread_m > 0.02) == (kind.name == "fidgeting"));
		}
		CHECK(find_other_motion("sleeping") == nullptr);
	}

	TEST_CASE("populations have different people, equal on every call") {
		for (std::uint32_t i = 0; i < 20; ++i) {
			const Subject train = draw_subject(Population::TRAIN, i);
			const Subject evaluate = draw_subject(Population::EVALUATE, i);
			CHECK(train.id == "train_" + std::to_string(i));
			CHECK(train.id != evaluate.id);
			CHECK(train.peak_fraction != evaluate.peak_fraction);
			CHECK(train.peak_fraction == draw_subject(Population::TRAIN, i).peak_fraction);
			CHECK(train.peak_fraction >= 0.35);
			CHECK(train.peak_fraction <= 0.5);
		}
	}
}
