#include "simulation/sensor.h"

#include "simulation/random_direction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace steadyhand {

namespace {

constexpr double LAG_SETTLING_S = 0.3;          // a tracker falls behind gradually
constexpr double NOISE_DOUBLING_RANGE_M = 0.25; // Guna et al. 2014: accuracy drops beyond
constexpr double CONFIDENCE_TAU_S = 1.0;

/// 2, 3 or 4 periods in the proportions of the recordings' gaps.
double skipped_periods(Random &r_random) {
	const double share = r_random.uniform();
	return share < 0.70 ? 2.0 : share < 0.92 ? 3.0 : 4.0;
}

} // namespace

SimulatedSensor::SimulatedSensor(const SensorProfile &profile, std::uint64_t seed) :
		profile_(profile), random_(seed),
		period_s_(random_.uniform(profile.period_min_s, profile.period_max_s)),
		t_s_(-period_s_ * random_.uniform()),
		lag_target_s_(random_.uniform(profile.lag_min_s, profile.lag_max_s)),
		lag_growth_s_(profile.lag_growth_max_s * random_.uniform()), lag_s_(lag_target_s_),
		content_t_s_(t_s_ - lag_s_), confidence_(CONFIDENCE_TAU_S, random_), freeze_{ profile.freeze_per_s,
			profile.freeze_min_s, profile.freeze_max_s },
		dropout_{ profile.dropout_per_s, profile.dropout_min_s, profile.dropout_max_s }, jump_{
			profile.jump_per_s
		} {
	for (std::size_t i = 0; i < 3 * (1 + JOINT_COUNT); ++i) {
		drifts_.emplace_back(random_.uniform(profile.drift_tau_min_s, profile.drift_tau_max_s), random_);
	}
	drift_values_.resize(drifts_.size());
	for (Fault *fault : { &freeze_, &dropout_, &jump_ }) {
		fault->candidate_s = random_.waiting_time(fault->per_s * (1.0 + profile_.fault_growth));
	}
}

void SimulatedSensor::advance_clock() {
	const double periods = random_.chance(profile_.skip_fraction) ? skipped_periods(random_) : 1.0;
	const double jitter_s = profile_.jitter_s * random_.normal();
	// The limit keeps time increasing. Half a period is 50 standard deviations of the jitter.
	dt_s_ = std::max(periods * period_s_ + jitter_s, 0.5 * period_s_);
	t_s_ += dt_s_;
}

bool SimulatedSensor::begins(Fault &r_fault, double severity) {
	// Thinning (Lewis and Shedler 1979): candidates at the highest rate, accepted with the present rate / the
	// highest one.
	const double rate_max = r_fault.per_s * (1.0 + profile_.fault_growth);
	bool begun = false;
	while (r_fault.candidate_s <= t_s_) {
		r_fault.candidate_s += random_.waiting_time(rate_max);
		const double share = (1.0 + profile_.fault_growth * severity) / (1.0 + profile_.fault_growth);
		if (random_.chance(share) && t_s_ >= r_fault.until_s) {
			r_fault.until_s = t_s_ + random_.uniform(r_fault.min_s, r_fault.max_s);
			begun = true;
		}
	}
	return begun;
}

void SimulatedSensor::draw_drift(double dt_s) {
	for (std::size_t i = 0; i < drifts_.size(); ++i) {
		drift_values_[i] = drifts_[i].step(dt_s, random_);
	}
}

HandFrame SimulatedSensor::distorted(HandFrame frame, double severity) {
	const double growth = 1.0 + profile_.drift_growth * severity;
	const Eigen::Map<const Eigen::Matrix<double, 3, 1 + JOINT_COUNT>> drift(drift_values_.data());
	frame.tracked &= profile_.joints;
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		Eigen::Vector3d &position_m = frame.positions_m[joint];
		const double noise = position_m.norm() > NOISE_DOUBLING_RANGE_M ? 2.0 : 1.0;
		position_m += growth *
				(profile_.drift_m * drift.col(0) +
						profile_.joint_drift_m * drift.col(1 + static_cast<Eigen::Index>(joint)));
		position_m.x() += noise * profile_.noise_m * random_.normal();
		position_m.y() += noise * profile_.noise_y_m * random_.normal();
		position_m.z() += noise * profile_.noise_m * random_.normal();
		if (jump_frames_left_ > 0) {
			position_m += jump_m_;
		}
	}
	return frame;
}

HandFrame SimulatedSensor::next(const TrueMotion &motion) {
	for (;;) {
		advance_clock();
		const double severity = std::clamp(motion.severity(t_s_), 0.0, 1.0);
		lag_s_ += -std::expm1(-dt_s_ / LAG_SETTLING_S) * (lag_target_s_ + lag_growth_s_ * severity - lag_s_);
		content_t_s_ = std::max(content_t_s_, t_s_ - lag_s_);
		draw_drift(dt_s_);
		const double confidence = std::clamp(0.8 + 0.15 * confidence_.step(dt_s_, random_), 0.13, 1.0);

		if (begins(jump_, severity)) {
			jump_frames_left_ = 1 + static_cast<int>(random_.index(10));
			jump_m_ = random_direction(random_);
			jump_m_ *= random_.uniform(profile_.jump_min_m, profile_.jump_max_m);
		}
		begins(freeze_, severity);
		if (begins(dropout_, severity)) {
			dropout_is_silent_ = random_.chance(0.5);
		}

		HandFrame frame = distorted(motion.hand(content_t_s_), severity);
		jump_frames_left_ = std::max(jump_frames_left_ - 1, 0);
		if (t_s_ < freeze_.until_s && has_last_) {
			frame = last_;
		}
		frame.t_s = t_s_;
		frame.confidence = profile_.reports_confidence ? confidence : 1.0;
		last_ = frame;
		has_last_ = true;
		if (t_s_ >= dropout_.until_s) {
			return frame;
		}
		if (!dropout_is_silent_) {
			frame.tracked = 0;
			return frame;
		}
	}
}

Track record_track(const TrueMotion &motion, const SensorProfile &profile, std::uint64_t seed) {
	Track track;
	track.joints = profile.joints;
	track.has_confidence = profile.reports_confidence;
	track.metadata = { { "sensor", std::string(profile.name) } };
	track.frames.reserve(static_cast<std::size_t>(motion.span_s / profile.period_min_s) + 2);
	SimulatedSensor sensor(profile, seed);
	for (HandFrame frame = sensor.next(motion); frame.t_s <= motion.span_s; frame = sensor.next(motion)) {
		track.frames.push_back(frame);
	}
	return track;
}

} // namespace steadyhand
