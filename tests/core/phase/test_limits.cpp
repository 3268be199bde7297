// What `phase` mode does not do, as docs/method.md says it: held from both sides, so that the page is changed
// with the code.

#include "follow.h"
#include "overlapping_drags.h"
#include "simulation/synthetic_trial.h"
#include "soundness/tracking_soundness.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

using namespace steadyhand;
using test::Drag, test::follow, test::PERIOD_S;

namespace {

constexpr double TREMBLING = 5e-4; ///< of a tracker that is right, amplitudes

/// Share of the frames of freezes, from 45 ms on, that are told as frozen; tremble: standard deviation,
/// amplitudes (0.005 is 1 mm of 20 cm); at: of the time, when the tracker freezes.
double share_told(double tremble, const std::vector<double> &at) {
	constexpr double ONSET_S = 0.6, FREEZES_FOR_S = 0.2, KNOWN_S = 0.045;
	int told = 0, frames = 0;
	for (const double share : at) {
		for (const double duration_s : { 0.5, 0.8, 1.2 }) {
			for (std::uint64_t seed = 0; seed < 40; ++seed) {
				const Drag drag{ .onset_s = ONSET_S, .duration_s = duration_s, .amplitude_m = 1.0 };
				const double lost_s = ONSET_S + share * duration_s;
				std::mt19937_64 random(seed);
				std::normal_distribution<double> trembling(0.0, tremble);
				TrackingSoundness soundness;
				for (int i = 0; i * PERIOD_S < lost_s + FREEZES_FOR_S; ++i) {
					const double t_s = i * PERIOD_S;
					soundness.push(t_s, drag.x_m(std::min(t_s, lost_s)) + trembling(random));
					frames += t_s > lost_s + KNOWN_S ? 1 : 0;
					told += t_s > lost_s + KNOWN_S && soundness.frozen() ? 1 : 0;
				}
			}
		}
	}
	return static_cast<double>(told) / frames;
}

/// Critically damped noise, as trackers' slow errors are, at PERIOD_S.
class Wandering {
public:
	Wandering(double deviation, double rate_per_s, std::uint64_t seed) :
			random_(seed), rate_per_s_(rate_per_s), deviation_(deviation), x_(deviation * normal_(random_)),
			v_(deviation * rate_per_s * normal_(random_)) {}

	double next() {
		constexpr int STEPS = 20;
		constexpr double STEP_S = PERIOD_S / STEPS;
		const double a = rate_per_s_, now = x_;
		for (int i = 0; i < STEPS; ++i) {
			x_ += v_ * STEP_S;
			v_ += (-2.0 * a * v_ - a * a * x_) * STEP_S +
					2.0 * a * deviation_ * std::sqrt(a * STEP_S) * normal_(random_);
		}
		return now;
	}

private:
	std::mt19937_64 random_;
	std::normal_distribution<double> normal_;
	double rate_per_s_, deviation_, x_, v_;
};

enum class Fault { NONE, GAP, FREEZE, JUMP };

/// By how much the estimate is ahead of the hand on its way, s, before a tracker that is on time but for one
/// fault, in the mean; from_onset_s: when that begins, since the onset.
double mean_lead_s(Fault fault, double from_onset_s, double duration_s) {
	constexpr double ONSET_S = 2.0;
	const double from_s = ONSET_S + from_onset_s, to_s = from_s + (fault == Fault::JUMP ? 0.05 : 0.25);
	const Drag drag{ .onset_s = ONSET_S, .duration_s = duration_s, .amplitude_m = 1.0 };
	double ahead = 0.0, gone = 0.0;
	for (std::uint64_t seed = 1; seed <= 10; ++seed) {
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(seed);
		std::normal_distribution<double> trembling(0.0, TREMBLING);
		double shown = 0.0;
		const auto show = [&](double t_s) -> std::optional<double> {
			const bool errs = fault != Fault::NONE && t_s > from_s && t_s < to_s;
			const double x = drag.x_m(t_s) + trembling(random);
			if (errs && fault == Fault::GAP) {
				return std::nullopt;
			}
			shown = errs && fault == Fault::FREEZE ? shown : x + (errs ? 0.25 : 0.0);
			return shown;
		};
		follow(estimator, ONSET_S + duration_s, show, [&](double t_s, double value) {
			const double hand = drag.x_m(t_s);
			if (t_s > to_s + 0.05 && hand > 0.2 && hand < 0.95) {
				ahead += value - hand;
				gone += (drag.x_m(t_s + 1e-3) - drag.x_m(t_s - 1e-3)) / 2e-3;
			}
		});
	}
	return ahead / gone;
}

} // namespace

TEST_CASE("the further a freeze trembles, the more often it is taken for a hand that stops") {
	const std::vector<double> on_way{ 0.4, 0.5, 0.6 };
	CHECK(share_told(0.0005, on_way) > 0.99);
	CHECK(std::abs(share_told(0.0025, on_way) - 0.75) < 0.1);
	CHECK(std::abs(share_told(0.005, on_way) - 0.5) < 0.1);
	CHECK(share_told(0.01, on_way) < 0.3);
	// Where the hand has hardly begun, or is there.
	CHECK(share_told(0.0005, { 0.05, 0.95 }) == 0.0);
}

TEST_CASE("a drag of 0.15 s that halts near its end is taken for a frozen tracker, the sparser its frames "
		  "the sooner" *
		doctest::test_suite("figures")) {
	constexpr int PHASES = 20;
	const auto followed = [](double rate_hz, double halts_at) {
		int good = 0, all = 0;
		for (int phase = 0; phase < PHASES; ++phase) {
			for (const double noise : { 2e-4, 1e-3 }) {
				const Drag drag{
					.onset_s = 0.8 + phase / (PHASES * rate_hz), .duration_s = 0.15, .amplitude_m = halts_at
				};
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(static_cast<std::uint64_t>(phase));
				std::normal_distribution<double> trembling(0.0, noise);
				double off = 0.0;
				follow(
						estimator, 1.6, [&](double t_s) { return drag.x_m(t_s) + trembling(random); },
						[&](double t_s, double value) {
							off = std::max(off, std::abs(value - drag.x_m(t_s)));
						},
						1.0 / rate_hz);
				good += off < 0.15 ? 1 : 0;
				++all;
			}
		}
		return static_cast<double>(good) / all;
	};
	for (const double halts_at : { 0.3, 0.4, 0.5 }) {
		CAPTURE(halts_at);
		CHECK(followed(60.0, halts_at) > 0.9);
		CHECK(followed(110.0, halts_at) == 1.0);
	}
	CHECK(std::abs(followed(60.0, 0.7) - 0.4) < 0.2);
	CHECK(followed(60.0, 0.9) < 0.2);
	CHECK(std::abs(followed(110.0, 0.9) - 0.4) < 0.2);
}

TEST_CASE("a tracker that errs smoothly, without a fault, is followed" * doctest::test_suite("figures")) {
	const Drag drag{ .onset_s = 1.0, .duration_s = 0.8, .amplitude_m = 1.0 };
	for (const double deviation : { 0.03, 0.06, 0.1 }) {
		CAPTURE(deviation);
		double off = 0.0, off_shown = 0.0; // sums of squares
		for (std::uint64_t seed = 1; seed <= 60; ++seed) {
			PhaseEstimator estimator(test::drag_model());
			Wandering error(deviation, 5.9, seed);
			double shown = 0.0;
			const auto show = [&](double t_s) { return shown = drag.x_m(t_s) + error.next(); };
			follow(estimator, 1.8, show, [&](double t_s, double value) {
				const double hand = drag.x_m(t_s);
				off += t_s > 1.0 ? (value - hand) * (value - hand) : 0.0;
				off_shown += t_s > 1.0 ? (shown - hand) * (shown - hand) : 0.0;
			});
		}
		CHECK(std::sqrt(off / off_shown) > 0.9);
		CHECK(std::sqrt(off / off_shown) < 1.05);
	}
}

TEST_CASE(
		"one fault of a tracker that is on time makes the estimate early" * doctest::test_suite("figures")) {
	for (const double duration_s : { 0.5, 0.8, 1.5, 3.0 }) {
		CAPTURE(duration_s);
		CHECK(std::abs(mean_lead_s(Fault::NONE, 0.0, duration_s)) < 0.01);
		CHECK(std::abs(mean_lead_s(Fault::JUMP, -0.8, duration_s) - 0.025) < 0.015);
		CHECK(std::abs(mean_lead_s(Fault::GAP, -0.8, duration_s) - 0.005) < 0.01);
		CHECK(std::abs(mean_lead_s(Fault::FREEZE, -0.8, duration_s)) < 0.01);
		for (const Fault fault : { Fault::GAP, Fault::JUMP }) {
			CAPTURE(static_cast<int>(fault));
			CHECK(std::abs(mean_lead_s(fault, 0.2 * duration_s, duration_s) - 0.045) < 0.02);
		}
	}
	for (const double duration_s : { 3.0, 4.0, 5.0 }) {
		CAPTURE(duration_s);
		CHECK(std::abs(mean_lead_s(Fault::FREEZE, 0.2 * duration_s, duration_s) - 0.09) < 0.02);
	}
}

TEST_CASE("a hand at rest that is lost before a tracker that wanders goes on in few cases" *
		doctest::test_suite("figures")) {
	const auto share_led_away = [](double deviation) {
		int led = 0;
		constexpr int HANDS = 100;
		for (int hand = 0; hand < HANDS; ++hand) {
			PhaseEstimator estimator(test::drag_model());
			Wandering error(deviation, 6.0, static_cast<std::uint64_t>(hand));
			double furthest = 0.0;
			const auto show = [&](double t_s) {
				return t_s < 1.5 ? std::optional(error.next()) : std::nullopt;
			};
			follow(estimator, 2.0, show, [&](double t_s, double value) {
				furthest = t_s > 1.5 ? std::max(furthest, std::abs(value)) : 0.0;
			});
			led += furthest > 0.3 ? 1 : 0;
		}
		return static_cast<double>(led) / HANDS;
	};
	CHECK(share_led_away(0.01) == 0.0); // 2 mm of 20 cm
	CHECK(share_led_away(0.03) < 0.1);
	CHECK(std::abs(share_led_away(0.05) - 0.04) < 0.03);
}

TEST_CASE("a hand that turns back half-way after a fault is shown beside itself for a while") {
	const auto furthest_off = [](bool was_lost, double &r_off_for_s) {
		const std::vector<Drag> drags{ { 1.0, 0.4, 0.5 }, { 1.42, 0.4, -0.5 } };
		PhaseEstimator estimator(test::drag_model());
		std::mt19937_64 random(3);
		std::normal_distribution<double> trembling(0.0, TREMBLING);
		double furthest = 0.0;
		const auto show = [&](double t_s) -> std::optional<double> {
			const bool is_lost = was_lost && t_s > 0.95 && t_s < 1.1;
			return is_lost ? std::nullopt : std::optional(test::x_m(drags, t_s) + trembling(random));
		};
		follow(estimator, 2.5, show, [&](double t_s, double value) {
			const double off = std::abs(value - test::x_m(drags, t_s));
			furthest = std::max(furthest, off);
			r_off_for_s += off > 0.05 ? 1e-3 : 0.0;
		});
		return furthest;
	};
	double off_for_s = 0.0, never_off_for_s = 0.0;
	CHECK(std::abs(furthest_off(true, off_for_s) - 0.065) < 0.025);
	CHECK(std::abs(off_for_s - 0.16) < 0.06);
	CHECK(furthest_off(false, never_off_for_s) < 0.03);
}

TEST_CASE("of taps that go through their surface a few are taken for the tracker's error" *
		doctest::test_suite("figures")) {
	const Feature &feature = *find_feature("index_along_axis");
	const auto taps = [](Population population, std::uint32_t subjects) {
		SyntheticSetOptions options;
		options.population = population;
		options.subjects = subjects;
		options.repetitions = 4;
		options.gestures = { "tap" };
		options.positions = { HandPosition::STABLE };
		options.paces = { 1.0, 0.6, 0.4, 1.6 };
		std::vector<SyntheticTrial> trials;
		for (const SyntheticTrialRequest &request : plan_synthetic_set(options)) {
			trials.push_back(make_synthetic_trial(request).value());
		}
		return trials;
	};
	const auto task_of = [](const Trial &trial) {
		return Task{ trial.start_m, trial.axis, trial.amplitude_m };
	};
	std::vector<TrainingRecording> recordings;
	for (const SyntheticTrial &trial : taps(Population::TRAIN, 12)) {
		recordings.push_back({ trial.trial.trial, task_of(trial.trial), trial.trial.start_s,
				trial.trial.end_s, trial.measured, trial.reference });
	}
	const GestureModel model = train("tap", "index_along_axis", recordings, {}).value();

	int beside = 0, all = 0;
	for (const SyntheticTrial &trial : taps(Population::TUNE, 40)) {
		const Task task = task_of(trial.trial);
		PhaseEstimator estimator(model, {}, USUAL_SENSOR_LATENCY_S);
		double furthest = 0.0; // of the estimate from a hand beyond the end
		std::size_t next = 0;
		for (const HandFrame &frame : trial.reference.frames) {
			const std::vector<HandFrame> &measured = trial.measured.frames;
			for (; next < measured.size() && measured[next].t_s <= frame.t_s; ++next) {
				if (const std::optional<double> x_m = feature.measure(measured[next], task)) {
					estimator.push(measured[next].t_s, *x_m / task.amplitude_m);
				}
			}
			const double hand = feature.measure(frame, task).value_or(0.0) / task.amplitude_m;
			const double off = std::abs(estimator.at(frame.t_s).value - hand);
			furthest = hand > 1.05 ? std::max(furthest, off) : furthest;
		}
		beside += furthest > 0.15 ? 1 : 0;
		++all;
	}
	CHECK(all == 160);
	CHECK(std::abs(beside - 6) <= 3);
}
