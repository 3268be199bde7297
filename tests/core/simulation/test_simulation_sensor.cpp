#include "near.h"
#include "simulation/drift.h"
#include "simulation/sensor.h"
#include "simulation/sensor_profile.h"
#include "tracking/track_csv.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;

namespace {

const SensorProfile &profile_named(std::string_view name) {
	const SensorProfile *const profile = find_sensor_profile(name);
	REQUIRE(profile != nullptr);
	return *profile;
}

/// All joints at `velocity_m_s` times t, 20 cm in front of the sensor.
TrueMotion steady_motion(const Eigen::Vector3d &velocity_m_s, double severity, double span_s) {
	TrueMotion motion;
	motion.span_s = span_s;
	motion.severity = [severity](double) { return severity; };
	motion.hand = [velocity_m_s](double t_s) {
		HandFrame frame;
		frame.t_s = t_s;
		for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
			frame.set(static_cast<Joint>(joint), Eigen::Vector3d(0.0, 0.0, -0.2) + t_s * velocity_m_s);
		}
		return frame;
	};
	return motion;
}

SensorProfile without_drift(SensorProfile profile) {
	profile.drift_m = 0.0;
	profile.joint_drift_m = 0.0;
	return profile;
}

SensorProfile without_faults(SensorProfile profile) {
	profile.freeze_per_s = 0.0;
	profile.dropout_per_s = 0.0;
	profile.jump_per_s = 0.0;
	return profile;
}

SensorProfile without_noise(SensorProfile profile) {
	profile.noise_m = 0.0;
	profile.noise_y_m = 0.0;
	return profile;
}

std::vector<double> intervals_s(const Track &track) {
	std::vector<double> intervals;
	for (std::size_t i = 1; i < track.frames.size(); ++i) {
		intervals.push_back(track.frames[i].t_s - track.frames[i - 1].t_s);
	}
	return intervals;
}

double median_of(std::vector<double> sample) {
	const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
	std::nth_element(sample.begin(), middle, sample.end());
	return *middle;
}

/// Checks the number of events of a Poisson process with dead time, within 4 standard deviations.
void check_count(int count, double per_s, double mean_length_s, double span_s) {
	const double expected = per_s * span_s / (1.0 + per_s * mean_length_s);
	CHECK(std::abs(count - expected) < 4.0 * std::sqrt(expected));
}

} // namespace

TEST_SUITE("simulated sensor") {
	TEST_CASE("the Ornstein-Uhlenbeck process has deviation 1 and its autocorrelation for any step") {
		Random random(3);
		const double tau_s = 0.7;
		OrnsteinUhlenbeck process(tau_s, random);
		const int count = 400000;
		double square = 0.0;
		double short_product = 0.0;
		double long_product = 0.0;
		double previous = process.step(0.0, random);
		for (int i = 0; i < count; ++i) {
			const bool is_long = i % 2 == 0;
			const double value = process.step(is_long ? 0.5 : 0.02, random);
			square += value * value / count;
			(is_long ? long_product : short_product) += value * previous / (0.5 * count);
			previous = value;
		}
		// Var(mean of squares) = 2 tau / T for T = 104 000 s.
		const double tolerance = 4.0 * std::sqrt(2.0 * tau_s / (0.26 * count));
		CHECK(std::abs(square - 1.0) < tolerance);
		CHECK(std::abs(short_product - std::exp(-0.02 / tau_s)) < 2.0 * tolerance);
		CHECK(std::abs(long_product - std::exp(-0.5 / tau_s)) < 2.0 * tolerance);
	}

	TEST_CASE("drift has deviation 1 and no jitter from frame to frame") {
		Random random(5);
		const double tau_s = 1.0;
		const double low_pass_s = 0.1;
		Drift drift(tau_s, random);
		const double dt_s = 0.009;
		const int lag = 50;
		std::vector<double> values;
		values.reserve(1000000);
		for (int i = 0; i < 1000000; ++i) {
			values.push_back(drift.step(dt_s, random));
		}
		double square = 0.0;
		double product = 0.0;
		double second_difference = 0.0;
		const auto count = static_cast<double>(values.size() - lag);
		for (std::size_t i = lag; i < values.size(); ++i) {
			square += values[i] * values[i] / count;
			product += values[i] * values[i - lag] / count;
			second_difference += std::pow(values[i] - 2.0 * values[i - 1] + values[i - 2], 2) / count;
		}
		// Autocovariance of exp(-t / a) after a low pass of b, scaled to variance 1.
		const double lag_s = lag * dt_s;
		const double expected =
				(tau_s * std::exp(-lag_s / tau_s) - low_pass_s * std::exp(-lag_s / low_pass_s)) /
				(tau_s - low_pass_s);
		const double tolerance = 4.0 * std::sqrt(2.0 * tau_s / (dt_s * count)) + dt_s / low_pass_s;
		CHECK(std::abs(square - 1.0) < tolerance);
		CHECK(std::abs(product - expected) < tolerance);
		// At 3 mm, its second differences must be as small as those of the white noise of resting fingers,
		// about 0.02 mm. The second difference of white noise has sqrt(6) times its deviation.
		CHECK(3e-3 * std::sqrt(second_difference / 6.0) < 0.03e-3);
	}

	TEST_CASE("simulated period, jitter and skipped frames equal those of real recordings") {
		for (const std::string_view name : { "leap_stable", "leap_loaded" }) {
			const SensorProfile profile = without_faults(profile_named(name));
			for (std::uint64_t seed = 0; seed < 5; ++seed) {
				const std::vector<double> intervals =
						intervals_s(record_track(steady_motion({ 0, 0, 0 }, 0.0, 60.0), profile, seed));
				const double period_s = median_of(intervals);
				CHECK(period_s > 8.65e-3);
				CHECK(period_s < 9.10e-3); // the longer intervals push the median up
				int skipped = 0;
				std::vector<double> single_s;
				for (const double interval_s : intervals) {
					const double periods = std::round(interval_s / period_s);
					CHECK(std::abs(interval_s - periods * period_s) < 0.6e-3);
					CHECK(periods <= 4.0);
					skipped += periods > 1.5 ? 1 : 0;
					if (periods < 1.5) {
						single_s.push_back(interval_s);
					}
				}
				const Eigen::Map<const Eigen::ArrayXd> single(
						single_s.data(), static_cast<Eigen::Index>(single_s.size()));
				const auto count = static_cast<double>(intervals.size());
				CHECK(std::sqrt((single - single.mean()).square().mean()) ==
						test::near(0.08e-3).epsilon(0.05));
				const double spread =
						4.0 * std::sqrt(profile.skip_fraction * (1.0 - profile.skip_fraction) / count);
				CHECK(std::abs(skipped / count - profile.skip_fraction) < spread);
			}
		}
	}

	TEST_CASE("the Liberty reports three tips at 240 Hz with 5 um noise") {
		const TrueMotion motion = steady_motion({ 0.02, 0, 0 }, 0.0, 5.0); // within 25 cm
		const Track track = record_track(motion, profile_named("liberty"), 1);
		CHECK(track.frames.size() >= 1200);
		CHECK(track.joints == 0b0000111);
		for (const double interval_s : intervals_s(track)) {
			CHECK(interval_s == test::near(1.0 / 240.0).epsilon(1e-9));
		}
		double square = 0.0;
		for (const HandFrame &frame : track.frames) {
			CHECK(frame.tracked == 0b0000111);
			square += std::pow(
					frame.position(Joint::INDEX).x() - motion.hand(frame.t_s).position(Joint::INDEX).x(), 2);
		}
		CHECK(std::sqrt(square / static_cast<double>(track.frames.size())) == test::near(5e-6).epsilon(0.1));
	}

	TEST_CASE("noise is larger along y and doubles far from the sensor") {
		const SensorProfile profile = without_faults(without_drift(profile_named("leap_stable")));
		for (const double far : { 0.0, 1.0 }) {
			TrueMotion motion = steady_motion({ 0, 0, 0 }, 0.0, 60.0);
			motion.hand = [hand = motion.hand, far](double t_s) {
				HandFrame frame = hand(t_s);
				frame.positions_m[1].z() -= 0.1 * far;
				return frame;
			};
			const Track track = record_track(motion, profile, 2);
			Eigen::Vector3d square = Eigen::Vector3d::Zero();
			const auto count = static_cast<double>(track.frames.size());
			for (const HandFrame &frame : track.frames) {
				const Eigen::Vector3d error_m =
						frame.position(Joint::INDEX) - motion.hand(0.0).position(Joint::INDEX);
				square += error_m.cwiseAbs2() / count;
			}
			CHECK(std::sqrt(square.x()) == test::near((1.0 + far) * 0.02e-3).epsilon(0.05));
			CHECK(std::sqrt(square.y()) == test::near((1.0 + far) * 0.05e-3).epsilon(0.05));
			CHECK(std::sqrt(square.z()) == test::near((1.0 + far) * 0.02e-3).epsilon(0.05));
		}
	}

	TEST_CASE("lag is constant when stable, up to 0.25 s when unstable") {
		for (const double severity : { 0.0, 1.0 }) {
			double longest_s = 0.0;
			for (std::uint64_t seed = 0; seed < 40; ++seed) {
				const SensorProfile profile =
						without_faults(without_noise(without_drift(profile_named("leap_unstable"))));
				const Track track = record_track(steady_motion({ 1, 0, 0 }, severity, 3.0), profile, seed);
				double previous_m = -1.0;
				for (const HandFrame &frame : track.frames) {
					const double content_s = frame.position(Joint::PALM).x();
					CHECK(content_s >= previous_m);
					previous_m = content_s;
				}
				const double lag_s = track.frames.back().t_s - previous_m;
				CHECK(lag_s > 0.0099);
				CHECK(lag_s < (severity > 0.0 ? 0.2501 : 0.0301));
				longest_s = std::max(longest_s, lag_s);
			}
			CHECK(longest_s > (severity > 0.0 ? 0.2 : 0.02));
		}
	}

	TEST_CASE("freezes, dropouts and jumps have the profile's rates and durations" *
			doctest::test_suite("figures")) {
		const double span_s = 1500.0;
		const SensorProfile profile = without_drift(profile_named("leap_unstable"));
		for (const double severity : { 0.0, 1.0 }) {
			const double growth = 1.0 + profile.fault_growth * severity;

			SensorProfile freezing = without_faults(profile);
			freezing.freeze_per_s = profile.freeze_per_s;
			int freezes = 0;
			const Track frozen = record_track(steady_motion({ 1e-3, 0, 0 }, severity, span_s), freezing, 6);
			double frozen_since_s = -1.0;
			for (std::size_t i = 1; i < frozen.frames.size(); ++i) {
				const bool repeats = frozen.frames[i].positions_m == frozen.frames[i - 1].positions_m;
				if (repeats && frozen_since_s < 0.0) {
					frozen_since_s = frozen.frames[i].t_s;
					++freezes;
				} else if (!repeats && frozen_since_s >= 0.0) {
					CHECK(frozen.frames[i].t_s - frozen_since_s >= profile.freeze_min_s);
					CHECK(frozen.frames[i].t_s - frozen_since_s <=
							2.0 * profile.freeze_max_s + 0.06); // two in a row
					frozen_since_s = -1.0;
				}
			}
			check_count(freezes, growth * profile.freeze_per_s, 0.175, span_s);

			SensorProfile losing = without_faults(profile);
			losing.dropout_per_s = profile.dropout_per_s;
			losing.skip_fraction = 0.0;
			int silent = 0;
			int empty = 0;
			const Track lost = record_track(steady_motion({ 0, 0, 0 }, severity, span_s), losing, 7);
			for (std::size_t i = 1; i < lost.frames.size(); ++i) {
				silent += lost.frames[i].t_s - lost.frames[i - 1].t_s > 0.045 ? 1 : 0;
				empty += lost.frames[i].tracked == 0 && lost.frames[i - 1].tracked != 0 ? 1 : 0;
			}
			check_count(silent, 0.5 * growth * profile.dropout_per_s, 0.55, span_s);
			check_count(empty, 0.5 * growth * profile.dropout_per_s, 0.55, span_s);

			SensorProfile jumping = without_noise(without_faults(profile));
			jumping.jump_per_s = profile.jump_per_s;
			int jumps = 0;
			int frames = 0;
			for (const HandFrame &frame :
					record_track(steady_motion({ 0, 0, 0 }, severity, span_s), jumping, 8).frames) {
				const Eigen::Vector3d jump_m = frame.position(Joint::INDEX) - Eigen::Vector3d(0.0, 0.0, -0.2);
				if (jump_m.norm() < 1e-9) {
					frames = 0;
					continue;
				}
				jumps += frames == 0 ? 1 : 0;
				++frames;
				CHECK(frames <= 20); // two in a row at most
				CHECK(jump_m.norm() > 0.0099);
				CHECK(jump_m.norm() < 0.0601);
				CHECK(frame.position(Joint::WRIST) == frame.position(Joint::INDEX));
			}
			check_count(jumps, growth * profile.jump_per_s, 0.06, span_s);
		}
	}

	TEST_CASE("drift has the profile's deviation and growth, independent of the confidence") {
		const SensorProfile profile = without_faults(profile_named("leap_unstable"));
		for (const double severity : { 0.0, 1.0 }) {
			const TrueMotion motion = steady_motion({ 0, 0, 0 }, severity, 2000.0);
			double square = 0.0;
			double confidence_mean = 0.0;
			double error_mean = 0.0;
			double product = 0.0;
			const Track track = record_track(motion, profile, 10);
			const auto count = static_cast<double>(track.frames.size());
			for (const HandFrame &frame : track.frames) {
				const Eigen::Vector3d error_m =
						frame.position(Joint::INDEX) - Eigen::Vector3d(0.0, 0.0, -0.2);
				square += error_m.squaredNorm() / 3.0 / count;
				confidence_mean += frame.confidence / count;
				error_mean += error_m.norm() / count;
				product += frame.confidence * error_m.norm() / count;
			}
			// Drift of the hand and of the joint, both times the growth; about 1500 independent values.
			const double expected_m = (1.0 + 2.0 * severity) * std::hypot(6e-3, 1e-3);
			CHECK(std::sqrt(square) == test::near(expected_m).epsilon(0.1));
			CHECK(std::abs(product - confidence_mean * error_mean) < 0.1 * 0.15 * expected_m);
		}
	}

	TEST_CASE("equal seeds give equal tracks to the last bit") {
		for (const SensorProfile &profile : sensor_profiles()) {
			const TrueMotion motion = steady_motion({ 0.1, 0, 0 }, 0.5, 3.0);
			const std::string first = format_track_csv(record_track(motion, profile, 1));
			CHECK(first == format_track_csv(record_track(motion, profile, 1)));
			CHECK(first != format_track_csv(record_track(motion, profile, 2)));
		}
	}

	TEST_CASE("a live sensor delivers the same frames one by one") {
		const TrueMotion motion = steady_motion({ 0.1, 0, 0 }, 1.0, 3.0);
		const Track track = record_track(motion, profile_named("leap_unstable"), 3);
		SimulatedSensor sensor(profile_named("leap_unstable"), 3);
		for (const HandFrame &frame : track.frames) {
			const HandFrame live = sensor.next(motion);
			CHECK(live.t_s == frame.t_s);
			CHECK(live.tracked == frame.tracked);
			CHECK(live.positions_m == frame.positions_m);
		}
	}
}
