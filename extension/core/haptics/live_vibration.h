#pragma once

#include "haptics/latest_value.h"
#include "haptics/vibration.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace steadyhand {

/// The motion by now and soon.
struct LiveMotion {
	MotionSnapshot snapshot;
	double heard_s = 0.0; ///< time of the motion's that a sample made now will be felt at
};

/// All that passes between the thread that knows the motion and the one that makes its vibration.
struct VibrationLink {
	LatestValue<LiveMotion> motion;
	LatestValue<EffectSet> effects;
	/// Tables of earlier generations are no longer in use; written by the reader.
	std::atomic<std::uint64_t> oldest_generation = 0;
	/// Number of the only LiveVibration that reads: of the last one made.
	std::atomic<std::uint32_t> reader = 0;
	/// Kept for as long as there is a reader: the tables' owner. The writer's.
	std::shared_ptr<const void> tables;
};

/// The vibration of a live motion, on the thread that needs its samples.
class LiveVibration {
public:
	LiveVibration(std::shared_ptr<VibrationLink> link, double sample_rate_hz, int channels) :
			link_(std::move(link)), number_(++link_->reader), vibration_(sample_rate_hz, channels) {}

	/// The next samples, as Vibration::render, of what is known by now.
	void render(std::span<float> frames) {
		if (link_->reader.load(std::memory_order_relaxed) == number_) {
			take_up();
		}
		vibration_.render(frames);
	}

private:
	std::shared_ptr<VibrationLink> link_;
	std::uint32_t number_;
	Vibration vibration_;

	void take_up() {
		if (const EffectSet *const effects = link_->effects.take()) {
			vibration_.set_effects(*effects);
		}
		link_->oldest_generation.store(vibration_.oldest_generation(), std::memory_order_release);
		if (const LiveMotion *const motion = link_->motion.take()) {
			vibration_.set_motion(motion->snapshot);
			vibration_.follow(
					motion->heard_s + static_cast<double>(vibration_.ahead()) / vibration_.sample_rate_hz());
		}
	}
};

} // namespace steadyhand
