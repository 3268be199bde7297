// Hands, faults, task lengths and frame rates: the bounds that today's core holds (bounds.h).

#include "bounds.h"
#include "measures.h"
#include "recogniser_estimator.h"
#include "replay.h"
#include "scenarios.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::matrix;

namespace {

const std::vector<Scenario> &scenarios() {
	static const std::vector<Scenario> all = Scenarios().all();
	return all;
}

std::unique_ptr<Estimator> make_estimator(const Scenario &scenario) {
	return std::make_unique<RecogniserEstimator>(test::shared_drag_model(), scenario.task, 0.0);
}

std::string description(const Scenario &scenario) {
	return scenario.group + " / " + scenario.hand.name + " / " +
			std::to_string(static_cast<int>(1e3 * scenario.task.amplitude_m)) + " mm / " +
			scenario.rate.name + " / " + scenario.noise.name + " / " + scenario.fault.name + " / seed " +
			std::to_string(scenario.seed);
}

bool is_asserted(const Scenario &scenario, const Bound &bound) {
	return bound.standing == Standing::ASSERTED && applies(bound, scenario);
}

/// Puts out where the hand is, or was lateness_s ago.
class Oracle : public Estimator {
public:
	Oracle(const Scenario &scenario, double lateness_s) : scenario_(scenario), lateness_s_(lateness_s) {}
	void push(const HandFrame & /*frame*/) override {}
	Output advance(double t_s) override {
		constexpr double STEP_S = 1e-6;
		const double shown_s = t_s - lateness_s_, amplitude_m = scenario_.task.amplitude_m;
		const double slope =
				(scenario_.truth(shown_s + STEP_S) - scenario_.truth(shown_s - STEP_S)) / (2 * STEP_S);
		const bool ends = scenario_.hand.ends == 1 && !has_ended_ && shown_s >= scenario_.hand.to_s;
		has_ended_ = has_ended_ || ends;
		return { amplitude_m * scenario_.truth(shown_s), amplitude_m * slope, ends, ends, 0 };
	}

private:
	const Scenario &scenario_;
	double lateness_s_;
	bool has_ended_ = false;
};

} // namespace

TEST_SUITE("figures") {
	TEST_CASE("every asserted bound of the matrix holds") {
		for (const Scenario &scenario : scenarios()) {
			if (std::ranges::none_of(BOUNDS, [&](const Bound &one) { return is_asserted(scenario, one); })) {
				continue;
			}
			INFO(description(scenario));
			const Measures measures = measure(scenario, *make_estimator(scenario));
			for (const Bound &bound : BOUNDS) {
				if (is_asserted(scenario, bound)) {
					INFO(name_of(bound.metric));
					CHECK(value_of(bound.metric, scenario, measures) <= bound.limit);
				}
			}
		}
	}

	TEST_CASE("the matrix finds no error in the hand's own motion") {
		for (const Scenario &scenario : scenarios()) {
			INFO(description(scenario));
			Oracle oracle(scenario, 0.0);
			const Measures measures = measure(scenario, oracle);
			for (const Bound &bound : BOUNDS) {
				// The velocity of a hand that stops dead jumps between two outputs.
				if (applies(bound, scenario) && bound.metric != Metric::VALUE_JUMP_PERCENT) {
					INFO(name_of(bound.metric));
					CHECK(value_of(bound.metric, scenario, measures) <= bound.limit);
				}
			}
		}
	}
}

TEST_CASE("every bound of the matrix has scenarios and every scenario a bound") {
	for (const Bound &bound : BOUNDS) {
		CAPTURE(std::string(bound.group));
		CHECK(std::ranges::any_of(scenarios(), [&](const Scenario &one) { return applies(bound, one); }));
	}
	for (const Scenario &scenario : scenarios()) {
		CAPTURE(scenario.group);
		CHECK(std::ranges::any_of(BOUNDS, [&](const Bound &one) { return one.group == scenario.group; }));
	}
}

TEST_CASE("a track of the matrix cut off leaves every output before the cut as it was") {
	for (std::size_t i = 0; i < scenarios().size(); i += 41) {
		const Scenario &scenario = scenarios()[i];
		INFO(description(scenario));
		const std::vector<HandFrame> whole = frames_of(scenario);
		const double cut_s = scenario.fault_s() + 0.15;
		std::vector<HandFrame> part = whole;
		std::erase_if(part, [&](const HandFrame &frame) { return frame.t_s > cut_s; });
		const std::vector<Output> before = replay(part, cut_s, *make_estimator(scenario));
		const std::vector<Output> all = replay(whole, scenario.record_s(), *make_estimator(scenario));
		bool are_equal = true;
		for (std::size_t ms = 0; ms < before.size(); ++ms) {
			are_equal &= before[ms] == all[ms];
		}
		CHECK(are_equal);
	}
}

TEST_CASE("the matrix measures a motion that is 40 ms late as 40 ms late") {
	for (std::size_t i = 0; i < scenarios().size(); i += 41) {
		const Scenario &scenario = scenarios()[i];
		if (scenario.hand.ends == 1) {
			INFO(description(scenario));
			Oracle oracle(scenario, 0.04);
			CHECK(measure(scenario, oracle).t_diff_s == doctest::Approx(-0.04).epsilon(1e-3));
		}
	}
}

TEST_CASE("a fault of the matrix lasts as long as its name says") {
	const Task task = task_of(Gesture::HORIZONTAL_DRAG, 0.2);
	const Scenario sound{ "move", Gesture::HORIZONTAL_DRAG, task, reaching(task, 0.9), RATES[5] };
	const std::vector<HandFrame> right = frames_of(sound);
	const auto wrong_frames = [&](const Fault &fault) {
		Scenario scenario = sound;
		scenario.fault = fault;
		const std::vector<HandFrame> frames = frames_of(scenario);
		std::ptrdiff_t wrong = 0;
		for (std::size_t i = 0; i < frames.size(); ++i) {
			CHECK(frames[i].t_s == right[i].t_s);
			wrong += frames[i].repeats(right[i]) ? 0 : 1;
		}
		return wrong;
	};
	constexpr std::array FRAMES{ 10, 30, 20, 50, 6, 1, 30 };
	for (std::size_t i = 0; i < PASSING_FAULTS.size(); ++i) {
		CAPTURE(PASSING_FAULTS[i].name);
		CHECK(wrong_frames(PASSING_FAULTS[i]) == FRAMES[i]);
	}
}
