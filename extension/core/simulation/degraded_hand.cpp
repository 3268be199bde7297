#include "simulation/degraded_hand.h"

#include "simulation/random_direction.h"
#include "simulation/sensor_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace steadyhand {

namespace {

enum DrawnFrom : std::uint64_t { DROPOUT, FREEZE, JUMP, DRIFT, NOISE };

constexpr double MOST_PER_MINUTE = 6000.0;
constexpr double LONGEST_LATENCY_S = 2.0;
constexpr double FRAMES_PER_S = 1000.0;  // fastest tracker; gives the size of the history
constexpr double LONGEST_GAP_S = 3600.0; // after it a Poisson process starts again: it has no memory
constexpr double SLOT_SLACK = 1e-6;      // of a period: keeps frames at the limit of a slot in this slot

double positive(double value) {
	return value > 0.0 && std::isfinite(value) ? value : 0.0;
}

/// The settings with all values in their valid range.
DegradeSettings limited(DegradeSettings settings) {
	for (double *const value :
			{ &settings.dropout_s, &settings.freeze_s, &settings.jump_m, &settings.jump_s, &settings.drift_m,
					&settings.drift_s, &settings.rate_hz, &settings.rounding_m, &settings.noise_m }) {
		*value = std::min(positive(*value), FARTHEST_M); // so that sums stay finite
	}
	settings.latency_s = std::min(positive(settings.latency_s), LONGEST_LATENCY_S);
	settings.drift_s = settings.drift_s > 0.0 ? settings.drift_s : 1.0;
	return settings;
}

/// Calls change(position, joint of the skeleton) for each position of hand and skeleton.
template <class Change> void for_each_position(DeviceFrame &r_frame, Change change) {
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (r_frame.hand.has(static_cast<Joint>(i))) {
			change(r_frame.hand.positions_m[i], static_cast<std::size_t>(SKELETON_OF[i]));
		}
	}
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		if (r_frame.skeleton.has(static_cast<SkeletonJoint>(i))) {
			change(r_frame.skeleton.positions_m[i], i);
		}
	}
}

/// Interpolates from `r_frame` (share 0) to `next` (share 1). A joint that one of them does not have is not
/// changed.
void interpolate(const DeviceFrame &next, double share, DeviceFrame &r_frame) {
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (next.hand.has(static_cast<Joint>(i))) {
			Eigen::Vector3d &position_m = r_frame.hand.positions_m[i];
			position_m += share * (next.hand.positions_m[i] - position_m);
		}
	}
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		const std::uint32_t bit = HandSkeleton::bit(static_cast<SkeletonJoint>(i));
		if ((next.skeleton.positioned & bit) != 0) {
			Eigen::Vector3d &position_m = r_frame.skeleton.positions_m[i];
			position_m += share * (next.skeleton.positions_m[i] - position_m);
		}
		if ((next.skeleton.rotated & r_frame.skeleton.rotated & bit) != 0) {
			Eigen::Quaterniond &rotation = r_frame.skeleton.rotations[i];
			rotation = rotation.slerp(share, next.skeleton.rotations[i]);
		}
	}
}

} // namespace

DegradedHand::Faults::Faults(double per_minute, double length_s, std::uint64_t seed) :
		per_s_(length_s > 0.0 ? std::min(positive(per_minute), MOST_PER_MINUTE) / 60.0 : 0.0),
		length_s_(length_s), random_(seed), until_s_(-std::numeric_limits<double>::infinity()) {}

bool DegradedHand::Faults::advance(double t_s) {
	if (per_s_ == 0.0) {
		return false;
	}
	if (!is_started_ || t_s - last_s_ > LONGEST_GAP_S) {
		is_started_ = true;
		next_s_ = t_s + random_.waiting_time(per_s_);
	}
	last_s_ = t_s;
	bool has_begun = false;
	while (next_s_ <= t_s) {
		until_s_ = next_s_ + length_s_;
		next_s_ += random_.waiting_time(per_s_);
		has_begun = true;
	}
	return has_begun;
}

DegradedHand::DegradedHand(const DegradeSettings &settings) :
		settings_(limited(settings)),
		dropouts_(settings.dropouts_per_minute, settings_.dropout_s, stream_seed(settings.seed, DROPOUT)),
		freezes_(settings.freezes_per_minute, settings_.freeze_s, stream_seed(settings.seed, FREEZE)),
		jumps_(settings_.jump_m > 0.0 ? settings.jumps_per_minute : 0.0, settings_.jump_s,
				stream_seed(settings.seed, JUMP)),
		drift_random_(stream_seed(settings.seed, DRIFT)),
		noise_random_(stream_seed(settings.seed, NOISE)), drift_{ Drift(settings_.drift_s, drift_random_),
			Drift(settings_.drift_s, drift_random_), Drift(settings_.drift_s, drift_random_) },
		history_(settings_.latency_s > 0.0 ? static_cast<std::size_t>(settings_.latency_s * FRAMES_PER_S) + 3
										   : 0) {}

std::optional<DeviceFrame> DegradedHand::apply(const DeviceFrame &frame) {
	const double t_s = frame.hand.t_s;
	// All random numbers are drawn for each frame, also if it is not delivered. So each kind of fault is
	// independent of the others.
	dropouts_.advance(t_s);
	freezes_.advance(t_s);
	if (jumps_.advance(t_s)) {
		jump_m_ = settings_.jump_m * random_direction(jumps_.random());
	}
	const DeviceFrame *const content = delayed(frame);
	DeviceFrame out = content != nullptr ? *content : frame;
	out.hand.t_s = t_s;
	out.device_time_s = frame.device_time_s;
	out.host_time_s = frame.host_time_s;
	displace(t_s, out);
	add_noise(out);
	round_positions(out);
	if (is_above_rate(t_s) || content == nullptr) {
		return std::nullopt;
	}
	if (freezes_.is_on(t_s) && has_last_) {
		out.hand = last_.hand;
		out.hand.t_s = t_s;
		out.skeleton = last_.skeleton;
	}
	last_ = out;
	has_last_ = true;
	if (dropouts_.is_on(t_s)) {
		if (settings_.dropouts_are_silent) {
			return std::nullopt;
		}
		out.hand.tracked = out.hand.inferred = 0;
		out.hand.positions_m.fill(Eigen::Vector3d::Zero());
		out.skeleton = HandSkeleton();
	}
	return out;
}

bool DegradedHand::is_above_rate(double t_s) {
	if (settings_.rate_hz == 0.0) {
		return false;
	}
	first_s_ = first_s_.value_or(t_s);
	const double slot = std::floor((t_s - *first_s_) * settings_.rate_hz + SLOT_SLACK);
	if (slot <= last_slot_) {
		return true;
	}
	last_slot_ = slot;
	return false;
}

const DeviceFrame *DegradedHand::delayed(const DeviceFrame &frame) {
	if (history_.empty()) {
		return &frame;
	}
	const auto at = [this](std::size_t i) -> DeviceFrame & {
		return history_[(oldest_ + i) % history_.size()];
	};
	if (count_ == history_.size()) {
		oldest_ = (oldest_ + 1) % history_.size();
		--count_;
	}
	at(count_++) = frame;
	const double seen_s = frame.hand.t_s - settings_.latency_s;
	while (count_ > 1 && at(1).hand.t_s <= seen_s) {
		oldest_ = (oldest_ + 1) % history_.size();
		--count_;
	}
	if (at(0).hand.t_s > seen_s) {
		return nullptr;
	}
	between_ = at(0);
	// When a joint appears or disappears, the earlier frame is delivered.
	const bool is_alike = count_ > 1 && at(1).hand.tracked == between_.hand.tracked &&
			at(1).skeleton.positioned == between_.skeleton.positioned;
	if (is_alike && at(0).hand.t_s < seen_s) {
		interpolate(at(1), (seen_s - at(0).hand.t_s) / (at(1).hand.t_s - at(0).hand.t_s), between_);
	}
	return &between_;
}

void DegradedHand::displace(double t_s, DeviceFrame &r_frame) {
	Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
	if (settings_.drift_m > 0.0) {
		const double dt_s = has_time_ ? std::max(t_s - last_s_, 0.0) : 0.0;
		for (Eigen::Index axis = 0; axis < 3; ++axis) {
			offset_m[axis] =
					settings_.drift_m * drift_[static_cast<std::size_t>(axis)].step(dt_s, drift_random_);
		}
		has_time_ = true;
		last_s_ = t_s;
	}
	const bool is_elsewhere = jumps_.is_on(t_s);
	if (is_elsewhere) {
		offset_m += jump_m_;
	}
	if (is_elsewhere || settings_.drift_m > 0.0) {
		for_each_position(
				r_frame, [&](Eigen::Vector3d &r_position_m, std::size_t) { r_position_m += offset_m; });
	}
}

void DegradedHand::add_noise(DeviceFrame &r_frame) {
	if (settings_.noise_m == 0.0) {
		return;
	}
	for (Eigen::Vector3d &noise_m : noise_m_) {
		for (double &along_m : noise_m) {
			along_m = settings_.noise_m * noise_random_.normal();
		}
	}
	for_each_position(r_frame,
			[this](Eigen::Vector3d &r_position_m, std::size_t joint) { r_position_m += noise_m_[joint]; });
}

void DegradedHand::round_positions(DeviceFrame &r_frame) const {
	if (settings_.rounding_m == 0.0) {
		return;
	}
	for_each_position(r_frame, [this](Eigen::Vector3d &r_position_m, std::size_t) {
		for (double &along_m : r_position_m) {
			const double steps = std::round(along_m / settings_.rounding_m);
			along_m = std::isfinite(steps) ? settings_.rounding_m * steps : along_m;
		}
	});
}

std::optional<DegradeSettings> degrade_preset(std::string_view name) {
	if (name != "stable" && name != "unstable") {
		return std::nullopt;
	}
	const SensorProfile &leap = *find_sensor_profile("leap_" + std::string(name));
	constexpr double SEVERITY = 0.5;
	constexpr double JUMP_FRAMES = 5.5; // a simulated jump lasts 1..10
	const auto mean = [](double least, double most) { return 0.5 * (least + most); };
	const double faults = 1.0 + leap.fault_growth * SEVERITY;
	const double period_s = mean(leap.period_min_s, leap.period_max_s);
	DegradeSettings settings;
	settings.dropouts_per_minute = 60.0 * faults * leap.dropout_per_s;
	settings.dropout_s = mean(leap.dropout_min_s, leap.dropout_max_s);
	settings.freezes_per_minute = 60.0 * faults * leap.freeze_per_s;
	settings.freeze_s = mean(leap.freeze_min_s, leap.freeze_max_s);
	settings.jumps_per_minute = 60.0 * faults * leap.jump_per_s;
	settings.jump_m = mean(leap.jump_min_m, leap.jump_max_m);
	settings.jump_s = JUMP_FRAMES * period_s;
	settings.drift_m = (1.0 + leap.drift_growth * SEVERITY) * leap.drift_m;
	settings.drift_s = mean(leap.drift_tau_min_s, leap.drift_tau_max_s);
	settings.latency_s = mean(leap.lag_min_s, leap.lag_max_s) + SEVERITY * mean(0.0, leap.lag_growth_max_s);
	settings.rate_hz = 1.0 / period_s;
	settings.noise_m = std::sqrt((2.0 * leap.noise_m * leap.noise_m + leap.noise_y_m * leap.noise_y_m) / 3.0);
	return settings;
}

} // namespace steadyhand
