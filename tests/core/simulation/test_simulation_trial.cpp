#include "near.h"
#include "simulation/gesture_motion.h"
#include "simulation/other_motion.h"
#include "simulation/synthetic_trial.h"
#include "tracking/track_csv.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

using namespace steadyhand;

namespace {

SyntheticTrial made(const SyntheticTrialRequest &request) {
	Result<SyntheticTrial> trial = make_synthetic_trial(request);
	REQUIRE_MESSAGE(trial.ok(), trial.error());
	return std::move(trial).value();
}

SyntheticTrialRequest request_of(const std::string &gesture, std::uint64_t seed) {
	SyntheticTrialRequest request;
	request.name = gesture;
	request.gesture = gesture;
	request.subject = draw_subject(Population::TUNE, 1);
	request.seed = seed;
	return request;
}

/// Radius of the circle through three points in the xy plane: a b c / (4 area).
double circumradius(const HandFrame &frame) {
	const Eigen::Vector2d thumb = frame.position(Joint::THUMB).head<2>();
	const Eigen::Vector2d index = frame.position(Joint::INDEX).head<2>();
	const Eigen::Vector2d middle = frame.position(Joint::MIDDLE).head<2>();
	const Eigen::Vector2d side = index - thumb;
	const Eigen::Vector2d other = middle - thumb;
	const double area_twice = std::abs(side.x() * other.y() - side.y() * other.x());
	return side.norm() * other.norm() * (index - middle).norm() / (2.0 * area_twice);
}

/// Motion element of the trial's gesture in units of its amplitude.
double element(const Trial &trial, const HandFrame &frame) {
	const double way_m = trial.has_axis() ? (frame.position(Joint::INDEX) - trial.start_m).dot(trial.axis)
										  : circumradius(frame) - trial.start_m.x();
	return way_m / trial.amplitude_m;
}

double reference_at(const SyntheticTrial &trial, double t_s) {
	const auto next = std::find_if(trial.reference.frames.begin(), trial.reference.frames.end(),
			[t_s](const HandFrame &frame) { return frame.t_s >= t_s; });
	REQUIRE(next != trial.reference.frames.end());
	return element(trial.trial, *next);
}

} // namespace

TEST_SUITE("synthetic trial") {
	TEST_CASE("a trial's times, start, axis and amplitude match its reference") {
		for (const SimulatedGesture &gesture : simulated_gestures()) {
			if (gesture.is_example) {
				continue; // its element is no stateless function of a frame
			}
			for (std::uint64_t seed = 0; seed < 30; ++seed) {
				SyntheticTrialRequest request = request_of(std::string(gesture.name), seed);
				request.position = seed % 2 == 0 ? HandPosition::STABLE : HandPosition::UNSTABLE;
				const SyntheticTrial trial = made(request);
				CHECK(trial.trial.gesture == gesture.name);
				CHECK(trial.trial.subject == "tune_1");
				CHECK(trial.trial.start_s >= 0.5);
				CHECK(trial.reference.frames.back().t_s - trial.trial.end_s > 0.75);
				CHECK(trial.measured.frames.front().t_s < 0.1);
				// Up to the onset the hand is at the start, except for sway and the error of the start.
				CHECK(std::abs(reference_at(trial, 0.1)) < 0.06);
				CHECK(std::abs(reference_at(trial, trial.trial.start_s)) < 0.06);
				const double level = reference_at(trial, trial.trial.end_s);
				CHECK(level == test::near(1.0).epsilon(gesture.through_max_m > 0.0 ? 0.04 : 0.2));
				if (gesture.through_max_m == 0.0) {
					CHECK(std::abs(reference_at(trial, trial.trial.end_s + 0.7) - level) < 0.05);
				}
				// The end is the first time at 95 % of the level at end_s. It is within the span.
				double end_s = trial.trial.start_s;
				while (reference_at(trial, end_s) < 0.95 * level) {
					end_s += 1.0 / 240.0;
				}
				CHECK(end_s <= trial.trial.end_s + 1.0 / 240.0);
				CHECK(end_s > 0.5 * (trial.trial.start_s + trial.trial.end_s));
			}
		}
	}

	TEST_CASE("a circle goes once counterclockwise around its centre, seen by the user") {
		for (std::uint64_t seed = 0; seed < 30; ++seed) {
			SyntheticTrialRequest request = request_of("circle", seed);
			request.position = seed % 2 == 0 ? HandPosition::STABLE : HandPosition::UNSTABLE;
			const SyntheticTrial trial = made(request);
			CHECK(trial.trial.amplitude_m == test::near(2.0 * std::numbers::pi * 0.06));
			// It begins at the top, to the left.
			CHECK(trial.trial.axis == Eigen::Vector3d(-1.0, 0.0, 0.0));
			const Eigen::Vector2d centre = trial.trial.start_m.head<2>() - Eigen::Vector2d(0.0, 0.06);
			double turned_rad = 0.0;
			Eigen::Vector2d last = trial.trial.start_m.head<2>() - centre;
			for (const HandFrame &frame : trial.reference.frames) {
				if (frame.t_s > trial.trial.end_s) {
					break;
				}
				const Eigen::Vector2d now = frame.position(Joint::INDEX).head<2>() - centre;
				CHECK(now.norm() == test::near(0.06).epsilon(0.5));
				turned_rad += std::atan2(last.x() * now.y() - last.y() * now.x(), last.dot(now));
				last = now;
				if (frame.t_s < trial.trial.start_s) {
					CHECK(std::abs(turned_rad) < 0.5);
				}
			}
			CHECK(turned_rad == test::near(2.0 * std::numbers::pi).epsilon(0.2));
		}
	}

	TEST_CASE("a set's rows and tracks read back from their files") {
		SyntheticSetOptions options;
		options.subjects = 2;
		options.repetitions = 2;
		const std::vector<SyntheticTrialRequest> requests = plan_synthetic_set(options);
		CHECK(requests.size() == 2 * 5 * 2 * 2);
		std::set<std::string> names;
		std::vector<Trial> rows;
		for (const SyntheticTrialRequest &request : requests) {
			CHECK(names.insert(request.name).second);
			const SyntheticTrial trial = made(request);
			rows.push_back(trial.trial);
			const std::string measured = format_track_csv(trial.measured);
			const Result<Track> again = parse_track_csv(measured, request.name);
			REQUIRE_MESSAGE(again.ok(), again.error());
			CHECK(format_track_csv(again.value()) == measured);
		}
		const Result<TrialTable> again = parse_trials_csv(format_trials_csv(rows), "trials.csv");
		REQUIRE_MESSAGE(again.ok(), again.error());
		CHECK(format_trials_csv(again.value().trials) == format_trials_csv(rows));
	}

	TEST_CASE("equal requests give equal trials to the last bit in any set") {
		SyntheticSetOptions small;
		small.subjects = 1;
		small.repetitions = 1;
		small.gestures = { "tap" };
		const SyntheticTrialRequest alone = plan_synthetic_set(small).front();
		const std::vector<SyntheticTrialRequest> all =
				plan_synthetic_set({ .subjects = 2, .repetitions = 3 });
		const auto same = std::find_if(
				all.begin(), all.end(), [&alone](const auto &request) { return request.name == alone.name; });
		REQUIRE(same != all.end());
		const SyntheticTrial left = made(alone);
		const SyntheticTrial right = made(*same);
		CHECK(format_track_csv(left.measured) == format_track_csv(right.measured));
		CHECK(format_track_csv(left.reference) == format_track_csv(right.reference));
		CHECK(format_trials_csv({ left.trial }) == format_trials_csv({ right.trial }));
		SyntheticTrialRequest other = alone;
		++other.seed;
		CHECK(format_track_csv(left.measured) != format_track_csv(made(other).measured));
	}

	TEST_CASE("pace stretches the same movement") {
		SyntheticSetOptions options;
		options.subjects = 1;
		options.repetitions = 2;
		options.gestures = { "horizontal_drag" };
		options.positions = { HandPosition::STABLE };
		const std::vector<SyntheticTrialRequest> natural = plan_synthetic_set(options);
		options.paces = { 1.0, 0.5 };
		const std::vector<SyntheticTrialRequest> paced = plan_synthetic_set(options);
		const auto duration_s = [](const SyntheticTrialRequest &request) {
			const Trial trial = made(request).trial;
			return trial.end_s - trial.start_s;
		};
		CHECK(duration_s(paced[0]) == duration_s(natural[0]));
		CHECK(duration_s(paced[1]) == test::near(0.5 * duration_s(natural[1])).epsilon(0.05));
	}

	TEST_CASE("earlier rounds repeat the movement and return without a step") {
		constexpr std::uint32_t ROUNDS = 3;
		for (const char *gesture : { "horizontal_drag", "tap", "zoom" }) {
			CAPTURE(gesture);
			SyntheticTrialRequest request = request_of(gesture, 4);
			const SyntheticTrial once = made(request);
			request.earlier_rounds = ROUNDS;
			const SyntheticTrial last = made(request);
			const double earlier_s = last.trial.start_s - once.trial.start_s;
			CHECK(last.trial.end_s - once.trial.end_s == test::near(earlier_s));
			// A round: movement, return, and half a second at each end.
			const double gesture_s = once.trial.end_s - once.trial.start_s;
			CHECK(earlier_s ==
					test::near(ROUNDS * (1.0 + gesture_s + std::max(gesture_s, 0.4))).epsilon(0.02));
			const auto at = [](const SyntheticTrial &trial, double t_s) {
				const auto &frames = trial.reference.frames;
				return std::min_element(frames.begin(), frames.end(), [t_s](const auto &a, const auto &b) {
					return std::abs(a.t_s - t_s) < std::abs(b.t_s - t_s);
				})->position(Joint::INDEX);
			};
			const double middle_s = 0.5 * (once.trial.start_s + once.trial.end_s);
			for (std::uint32_t round = 0; round <= ROUNDS; ++round) {
				const double shift_s = earlier_s * round / ROUNDS;
				for (const double t_s : { once.trial.start_s, middle_s, once.trial.end_s }) {
					CHECK((at(last, t_s + shift_s) - at(once, t_s)).norm() < 0.006);
				}
			}
			for (std::size_t i = 1; i < last.reference.frames.size(); ++i) {
				const HandFrame &before = last.reference.frames[i - 1], &frame = last.reference.frames[i];
				const double step_m = (frame.position(Joint::INDEX) - before.position(Joint::INDEX)).norm();
				REQUIRE(step_m < 5.0 * (frame.t_s - before.t_s));
			}
		}
	}

	TEST_CASE("the sensor does not change the reference") {
		SyntheticTrialRequest request = request_of("horizontal_drag", 4);
		const SyntheticTrial leap = made(request);
		request.sensor = "openxr";
		const SyntheticTrial openxr = made(request);
		CHECK(format_track_csv(leap.reference) == format_track_csv(openxr.reference));
		CHECK(leap.measured.has_confidence);
		CHECK_FALSE(openxr.measured.has_confidence);
	}

	TEST_CASE("the measured curve is near the reference only at stable positions") {
		for (const SimulatedGesture &gesture : simulated_gestures()) {
			if (gesture.is_example) {
				continue; // its element is no stateless function of a frame
			}
			double squares[2] = { 0.0, 0.0 };
			int counts[2] = { 0, 0 };
			for (std::uint64_t seed = 0; seed < 40; ++seed) {
				SyntheticTrialRequest request = request_of(std::string(gesture.name), seed);
				request.position = seed % 2 == 0 ? HandPosition::STABLE : HandPosition::UNSTABLE;
				const SyntheticTrial trial = made(request);
				for (const HandFrame &frame : trial.measured.frames) {
					if (frame.tracked != 0 && frame.t_s >= trial.trial.start_s &&
							frame.t_s <= trial.trial.end_s) {
						squares[seed % 2] +=
								std::pow(element(trial.trial, frame) - reference_at(trial, frame.t_s), 2);
						++counts[seed % 2];
					}
				}
			}
			const double stable = std::sqrt(squares[0] / counts[0]);
			const double unstable = std::sqrt(squares[1] / counts[1]);
			INFO(gesture.name, " stable ", stable, " unstable ", unstable);
			CHECK(stable < 0.15); // a tap covers a tenth of its way during the lag
			CHECK(unstable > 1.5 * stable);
			CHECK(unstable < 0.6);
		}
	}

	TEST_CASE("a trial of \"none\" has a kind, a span and no task") {
		for (const OtherMotion &kind : other_motions()) {
			SyntheticTrialRequest request = request_of("none", 2);
			request.kind = kind.name;
			request.duration_s = 5.0;
			const SyntheticTrial trial = made(request);
			CHECK(trial.trial.start_s == 0.5);
			CHECK(trial.trial.end_s == 4.5);
			CHECK(trial.trial.amplitude_m == 0.0);
			CHECK_FALSE(trial.trial.has_axis());
			CHECK(trial.measured.metadata.back() ==
					std::pair<std::string, std::string>("kind", std::string(kind.name)));
		}
	}

	TEST_CASE("an unknown name is an error that lists the known names") {
		CHECK(make_synthetic_trial(request_of("wave", 1)).error() ==
				"no synthetic gesture 'wave', there are: horizontal_drag vertical_drag tap zoom "
				"circle none");
		SyntheticTrialRequest request = request_of("tap", 1);
		request.sensor = "kinect";
		CHECK(make_synthetic_trial(request).error() ==
				"no synthetic sensor 'kinect', there are: leap_stable leap_unstable leap_loaded openxr "
				"liberty");
		request = request_of("none", 1);
		request.kind = "sleeping";
		CHECK(make_synthetic_trial(request).error() ==
				"no synthetic kind of other motion 'sleeping', there are: idle fidgeting reaching "
				"typing circling wandering");
	}
}

TEST_CASE("a placed gesture is the unplaced one, turned and shifted") {
	for (const char *const gesture : { "horizontal_drag", "vertical_drag", "tap" }) {
		SyntheticTrialRequest request{ .name = "placed", .gesture = gesture };
		request.subject = draw_subject(Population::EVALUATE, 3);
		request.seed = 5;
		const SyntheticTrial free = make_synthetic_trial(request).value();
		const Eigen::Vector3d start_m(3.0, -1.0, 2.0), axis = Eigen::Vector3d(1.0, 2.0, -2.0) / 3.0;
		request.place = { start_m, axis, free.trial.amplitude_m, 0.0 };
		const SyntheticTrial placed = make_synthetic_trial(request).value();
		CHECK(placed.trial.start_m == start_m);
		CHECK(placed.trial.axis == axis);
		REQUIRE(placed.measured.frames.size() == free.measured.frames.size());
		for (std::size_t i = 0; i < free.measured.frames.size(); ++i) {
			const HandFrame &one = free.measured.frames[i], &other = placed.measured.frames[i];
			REQUIRE(one.t_s == other.t_s);
			REQUIRE(one.tracked == other.tracked);
			if (!one.has_all(joint_bits({ Joint::INDEX, Joint::THUMB }))) {
				continue;
			}
			const Eigen::Vector3d from_start = one.position(Joint::INDEX) - free.trial.start_m;
			const Eigen::Vector3d placed_from_start = other.position(Joint::INDEX) - start_m;
			// A rigid motion keeps the movement along the axis, distances and the shape of the hand.
			REQUIRE(placed_from_start.dot(axis) ==
					doctest::Approx(from_start.dot(free.trial.axis)).epsilon(1e-9));
			REQUIRE(placed_from_start.norm() == doctest::Approx(from_start.norm()).epsilon(1e-9));
			REQUIRE((other.position(Joint::INDEX) - other.position(Joint::THUMB)).norm() ==
					doctest::Approx((one.position(Joint::INDEX) - one.position(Joint::THUMB)).norm()));
		}
	}
}

TEST_CASE("a placed gesture has the requested amplitude and radius") {
	SyntheticTrialRequest request{ .name = "placed", .gesture = "zoom" };
	request.subject = draw_subject(Population::EVALUATE, 3);
	request.place = { Eigen::Vector3d(1.0, 1.0, 1.0), Eigen::Vector3d::Zero(), 0.04, 0.02 };
	const SyntheticTrial made = make_synthetic_trial(request).value();
	CHECK(made.trial.start_m.x() == 0.02);
	CHECK(made.trial.amplitude_m == 0.04);
}
