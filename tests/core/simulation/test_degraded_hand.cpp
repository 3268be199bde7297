// Each fault of DegradedHand, alone and with the others.

#include "simulation/degraded_hand.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double RATE_HZ = 100.0;
constexpr double MINUTE_S = 60.0;

/// All joints, hand and skeleton alike, in steady motion along x at 0.1 m/s from (0, 1, -0.3).
DeviceFrame sound_frame(int i) {
	DeviceFrame frame;
	const double t_s = 5.0 + i / RATE_HZ;
	for (std::size_t joint = 0; joint < SKELETON_JOINT_COUNT; ++joint) {
		frame.skeleton.set(static_cast<SkeletonJoint>(joint),
				{ 0.1 * (t_s - 5.0) + 0.01 * static_cast<double>(joint), 1.0, -0.3 });
		frame.skeleton.rotations[joint] = Eigen::Quaterniond::Identity();
	}
	frame.skeleton.rotated = frame.skeleton.positioned;
	frame.hand = hand_frame_of(frame.skeleton, t_s);
	frame.device_time_s = 1000.0 + t_s;
	return frame;
}

using Visit = std::function<void(int i, const std::optional<DeviceFrame> &frame)>;

/// The frames are not stored: streams of hours do not fit into memory.
void degrade(const DegradeSettings &settings, double length_s, const Visit &visit) {
	DegradedHand hand(settings);
	for (int i = 0; i < length_s * RATE_HZ; ++i) {
		visit(i, hand.apply(sound_frame(i)));
	}
}

using Frames = std::vector<std::optional<DeviceFrame>>;

Frames degraded(const DegradeSettings &settings, double length_s) {
	Frames frames;
	degrade(settings, length_s,
			[&](int, const std::optional<DeviceFrame> &frame) { frames.push_back(frame); });
	return frames;
}

bool same_bits(const Eigen::Vector3d &left, const Eigen::Vector3d &right) {
	return std::equal(left.begin(), left.end(), right.begin(), [](double one, double other) {
		return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
	});
}

/// Two frames have equal times, confidence, tracked joints and, to the last bit, positions.
bool is_same(const std::optional<DeviceFrame> &left, const std::optional<DeviceFrame> &right) {
	if (!left || !right) {
		return left.has_value() == right.has_value();
	}
	bool is_same = left->hand.t_s == right->hand.t_s && left->hand.tracked == right->hand.tracked &&
			left->hand.confidence == right->hand.confidence && left->device_time_s == right->device_time_s &&
			left->skeleton.positioned == right->skeleton.positioned &&
			left->skeleton.rotated == right->skeleton.rotated;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		is_same = is_same && same_bits(left->hand.positions_m[i], right->hand.positions_m[i]);
	}
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		is_same = is_same && same_bits(left->skeleton.positions_m[i], right->skeleton.positions_m[i]);
	}
	return is_same;
}

/// Displacement of the index tip from its position without faults. The skeleton's tip must have the same one.
Eigen::Vector3d offset_m(const DeviceFrame &frame, int i) {
	CHECK(frame.hand.position(Joint::INDEX) == frame.skeleton.position(SkeletonJoint::INDEX_TIP));
	return frame.hand.position(Joint::INDEX) - sound_frame(i).hand.position(Joint::INDEX);
}

/// Lengths of the runs of true.
std::vector<int> runs(const std::vector<bool> &is_on) {
	std::vector<int> lengths;
	int length = 0;
	for (const bool is_one : is_on) {
		if (!is_one && length > 0) {
			lengths.push_back(length);
		}
		length = is_one ? length + 1 : 0;
	}
	return lengths; // one at the end may be cut
}

/// Checks runs of Poisson faults of rate `per_minute` and duration `length_s`, within four standard
/// deviations. A fault that begins in another one lengthens it: runs begin at the process's rate outside of
/// faults.
void check_runs(const std::vector<int> &lengths, double per_minute, double length_s, double span_s) {
	const double per_s = per_minute / MINUTE_S;
	const double expected = per_s * std::exp(-per_s * length_s) * span_s;
	CHECK(std::abs(static_cast<double>(lengths.size()) - expected) < 4.0 * std::sqrt(expected));
	const int least = *std::min_element(lengths.begin(), lengths.end());
	CHECK(least >= std::floor(length_s * RATE_HZ));
	const auto single = std::count_if(lengths.begin(), lengths.end(),
			[&](int length) { return length <= std::ceil(length_s * RATE_HZ); });
	CHECK(static_cast<double>(single) > 0.8 * static_cast<double>(lengths.size()));
}

DegradeSettings all_faults() {
	DegradeSettings settings = *degrade_preset("unstable");
	settings.rounding_m = 1e-4;
	settings.seed = 3;
	return settings;
}

} // namespace

TEST_SUITE("degraded hand") {
	TEST_CASE("settings of 0 change no frame") {
		DegradeSettings none;
		none.seed = 17;
		DegradeSettings nonsense;
		nonsense.dropouts_per_minute = nonsense.drift_m = nonsense.latency_s = -1.0;
		nonsense.rate_hz = nonsense.noise_m = nonsense.rounding_m = std::nan("");
		nonsense.freezes_per_minute = nonsense.jumps_per_minute = 60.0; // without a duration
		for (const DegradeSettings &settings : { none, nonsense }) {
			const Frames frames = degraded(settings, 10.0);
			for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
				CHECK(is_same(frames[static_cast<std::size_t>(i)], sound_frame(i)));
			}
		}
		DeviceFrame negative_zero;
		negative_zero.hand.set(Joint::PALM, { -0.0, 0.0, -0.0 });
		const DeviceFrame back = *DegradedHand(none).apply(negative_zero);
		CHECK(std::signbit(back.hand.position(Joint::PALM).x()));
	}

	TEST_CASE("dropouts have the set rate and duration" * doctest::test_suite("figures")) {
		DegradeSettings settings;
		settings.dropouts_per_minute = 12.0;
		settings.dropout_s = 0.25;
		for (const bool is_silent : { false, true }) {
			settings.dropouts_are_silent = is_silent;
			const double span_s = 60.0 * MINUTE_S;
			std::vector<bool> is_lost;
			degrade(settings, span_s, [&](int i, const std::optional<DeviceFrame> &frame) {
				const bool has_hand = frame && frame->hand.tracked != 0;
				is_lost.push_back(!has_hand);
				CHECK(frame.has_value() == (has_hand || !is_silent));
				CHECK((!frame || has_hand == (frame->skeleton.positioned != 0)));
				CHECK((!has_hand || is_same(frame, sound_frame(i))));
			});
			check_runs(runs(is_lost), 12.0, 0.25, span_s);
		}
	}

	TEST_CASE("freezes repeat the last pose with new time stamps") {
		DegradeSettings settings;
		settings.freezes_per_minute = 20.0;
		settings.freeze_s = 0.2;
		const double span_s = 30.0 * MINUTE_S;
		std::vector<bool> is_frozen;
		std::optional<DeviceFrame> last;
		degrade(settings, span_s, [&](int i, const std::optional<DeviceFrame> &frame) {
			CHECK(frame->hand.t_s == sound_frame(i).hand.t_s);
			CHECK(frame->device_time_s == sound_frame(i).device_time_s);
			is_frozen.push_back(
					last && same_bits(frame->hand.position(Joint::PALM), last->hand.position(Joint::PALM)));
			last = frame;
		});
		check_runs(runs(is_frozen), 20.0, 0.2, span_s);
	}

	TEST_CASE("jumps displace the whole hand by jump_m in random directions") {
		DegradeSettings settings;
		settings.jumps_per_minute = 20.0;
		settings.jump_m = 0.05;
		settings.jump_s = 0.1;
		const double span_s = 30.0 * MINUTE_S;
		Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
		std::vector<bool> is_elsewhere;
		degrade(settings, span_s, [&](int i, const std::optional<DeviceFrame> &frame) {
			const Eigen::Vector3d off_m = offset_m(*frame, i);
			is_elsewhere.push_back(!off_m.isZero(0.0));
			CHECK((!is_elsewhere.back() || std::abs(off_m.norm() - 0.05) < 1e-9));
			sum_m += off_m;
		});
		const std::vector<int> lengths = runs(is_elsewhere);
		check_runs(lengths, 20.0, 0.1, span_s);
		CHECK(sum_m.norm() / (10.0 * static_cast<double>(lengths.size())) < 0.01);
	}

	TEST_CASE("drift has the set deviation and time constant, equal for all joints" *
			doctest::test_suite("figures")) {
		DegradeSettings settings;
		settings.drift_m = 4e-3;
		settings.drift_s = 2.0;
		std::vector<Eigen::Vector3d> offsets_m;
		DeviceFrame last;
		degrade(settings, 120.0 * MINUTE_S, [&](int i, const std::optional<DeviceFrame> &frame) {
			last = *frame;
			offsets_m.push_back(offset_m(last, i));
		});
		double square = 0.0, after_tau = 0.0;
		for (std::size_t i = 0; i < offsets_m.size(); ++i) {
			square += offsets_m[i].squaredNorm();
			after_tau += i >= 200 ? offsets_m[i].dot(offsets_m[i - 200]) : 0.0;
		}
		const double variance = square / (3.0 * static_cast<double>(offsets_m.size()));
		CHECK(std::sqrt(variance) == doctest::Approx(4e-3).epsilon(0.05));
		CHECK(after_tau / square == doctest::Approx(std::exp(-1.0)).epsilon(0.2));
		const DeviceFrame sound = sound_frame(static_cast<int>(offsets_m.size()) - 1);
		for (std::size_t joint = 0; joint < SKELETON_JOINT_COUNT; ++joint) {
			const Eigen::Vector3d off_m =
					last.skeleton.positions_m[joint] - sound.skeleton.positions_m[joint];
			CHECK((off_m - offsets_m.back()).norm() < 1e-12);
		}
	}

	TEST_CASE("a latency delays the hand, interpolated between frames") {
		for (const double latency_s : { 0.004, 0.05, 0.1234, 1.5 }) {
			DegradeSettings settings;
			settings.latency_s = latency_s;
			const Frames frames = degraded(settings, 4.0);
			for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
				const std::optional<DeviceFrame> &frame = frames[static_cast<std::size_t>(i)];
				if (i / RATE_HZ < latency_s - 1e-9) {
					CHECK_FALSE(frame);
				} else if (i / RATE_HZ > latency_s + 1e-9) {
					REQUIRE(frame);
					CHECK(frame->hand.t_s == sound_frame(i).hand.t_s);
					CHECK((offset_m(*frame, i) + Eigen::Vector3d(0.1 * latency_s, 0, 0)).norm() < 1e-12);
				}
			}
		}
	}

	TEST_CASE("rate_hz limits the frame rate, evenly if it divides the input's") {
		for (const double rate_hz : { 10.0, 50.0, 30.0, 70.0 }) {
			DegradeSettings settings;
			settings.rate_hz = rate_hz;
			const Frames frames = degraded(settings, 60.0);
			const auto kept = std::count_if(
					frames.begin(), frames.end(), [](const auto &frame) { return frame.has_value(); });
			CHECK(std::abs(static_cast<double>(kept) - 60.0 * rate_hz) <= 1.0);
			std::vector<bool> is_left_out;
			for (const std::optional<DeviceFrame> &frame : frames) {
				is_left_out.push_back(!frame);
			}
			const std::vector<int> gaps = runs(is_left_out);
			if (rate_hz <= 50.0 && 100.0 / rate_hz == std::round(100.0 / rate_hz)) {
				CHECK(std::all_of(gaps.begin(), gaps.end(),
						[&](int gap) { return gap + 1 == static_cast<int>(100.0 / rate_hz); }));
			}
		}
		DegradeSettings settings;
		settings.rate_hz = 240.0;
		for (const std::optional<DeviceFrame> &frame : degraded(settings, 5.0)) {
			CHECK(frame.has_value());
		}
	}

	TEST_CASE("positions are rounded to the nearest multiple") {
		DegradeSettings settings;
		settings.rounding_m = 2.5e-3;
		const Frames frames = degraded(settings, 10.0);
		for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
			const DeviceFrame &frame = *frames[static_cast<std::size_t>(i)];
			CHECK(offset_m(frame, i).cwiseAbs().maxCoeff() <= 1.25e-3 + 1e-12);
			const double steps = frame.hand.position(Joint::INDEX).x() / 2.5e-3;
			CHECK(std::abs(steps - std::round(steps)) < 1e-9);
		}
	}

	TEST_CASE("noise is white with the set deviation on each axis") {
		DegradeSettings settings;
		settings.noise_m = 1e-3;
		Eigen::Array3d square = Eigen::Array3d::Zero();
		double neighbours = 0.0, count = 0.0;
		Eigen::Vector3d last_m = Eigen::Vector3d::Zero();
		degrade(settings, 10.0 * MINUTE_S, [&](int i, const std::optional<DeviceFrame> &frame) {
			const Eigen::Vector3d off_m = offset_m(*frame, i);
			square += off_m.array().square();
			neighbours += off_m.dot(last_m);
			last_m = off_m;
			++count;
		});
		for (const double along : square) {
			CHECK(std::sqrt(along / count) == doctest::Approx(1e-3).epsilon(0.02));
		}
		CHECK(std::abs(neighbours / square.sum()) < 0.02);
	}

	TEST_CASE("equal seeds give equal bits, other seeds other faults") {
		DegradeSettings settings = all_faults();
		const Frames frames = degraded(settings, 30.0), again = degraded(settings, 30.0);
		CHECK(std::equal(frames.begin(), frames.end(), again.begin(), again.end(), is_same));
		settings.seed = 4;
		const Frames others = degraded(settings, 30.0);
		CHECK_FALSE(std::equal(frames.begin(), frames.end(), others.begin(), others.end(), is_same));
	}

	TEST_CASE("a cut stream gives the same frames before the cut") {
		const Frames whole = degraded(all_faults(), 20.0), cut = degraded(all_faults(), 11.0);
		CHECK(std::equal(cut.begin(), cut.end(), whole.begin(), is_same));
	}

	TEST_CASE("one kind of fault does not change the others") {
		DegradeSettings settings;
		settings.jumps_per_minute = 20.0;
		settings.jump_m = 0.05;
		settings.jump_s = 0.1;
		settings.drift_m = 4e-3;
		settings.drift_s = 2.0;
		settings.noise_m = 1e-3;
		const Frames before = degraded(settings, 60.0);
		settings.dropouts_per_minute = settings.freezes_per_minute = 30.0;
		settings.dropout_s = settings.freeze_s = 0.1;
		settings.rate_hz = 40.0;
		const Frames after = degraded(settings, 60.0);
		std::size_t same = 0, differing = 0;
		for (std::size_t i = 1; i < after.size(); ++i) {
			if (after[i] && after[i]->hand.tracked != 0) {
				++(is_same(before[i], after[i]) ? same : differing);
			}
		}
		CHECK(same > 2000);
		CHECK(differing < 300); // frozen: 5 %
	}

	TEST_CASE("frames years apart, or at equal times, give frames") {
		DegradeSettings settings = all_faults();
		settings.dropouts_per_minute = 1e300;
		DegradedHand hand(settings);
		DeviceFrame frame = sound_frame(0);
		for (const double t_s : { 0.0, 0.0, 1.0, 1e6, 1e12, 1e12 }) {
			frame.hand.t_s = t_s;
			const std::optional<DeviceFrame> out = hand.apply(frame);
			CHECK((!out || out->hand.t_s == t_s));
		}
	}

	TEST_CASE("presets have the means of their sensor profiles; other names have none") {
		const DegradeSettings stable = *degrade_preset("stable"), unstable = *degrade_preset("unstable");
		CHECK(stable.drift_m == doctest::Approx(2e-3));
		CHECK(stable.latency_s == doctest::Approx(0.02));
		CHECK(stable.dropouts_per_minute == doctest::Approx(0.6));
		CHECK(unstable.drift_m == doctest::Approx(12e-3));
		CHECK(unstable.latency_s == doctest::Approx(0.075));
		CHECK(unstable.jumps_per_minute > 10.0 * stable.jumps_per_minute);
		CHECK(unstable.rate_hz < stable.rate_hz);
		CHECK_FALSE(degrade_preset("Stable"));
		CHECK_FALSE(degrade_preset(""));
	}
}
