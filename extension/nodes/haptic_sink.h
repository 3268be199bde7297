#pragma once

#include "haptics/arrival_detector.h"
#include "haptics/effect.h"
#include "haptics/live_vibration.h"

#include <cstdint>

namespace godot {

/// An output of a HapticSynth. A sink uses the motion either at each control instant, on the motion's clock
/// (advance), or live (play). Called by the scene's thread only.
class HapticSink {
public:
	virtual ~HapticSink() = default;

	/// The effects' tables are kept until oldest_generation() is above their generation.
	virtual void set_effects(const steadyhand::EffectSet &p_effects) = 0;
	virtual std::uint64_t oldest_generation() const = 0;

	/// The motion has ended. The next one has no connection to it.
	virtual void restart() {}
	/// Called at each control instant, with the last arrival and the last onset. `knot.moving` holds from
	/// this instant.
	virtual void advance(double, const steadyhand::MotionSnapshot::Knot &, double /*p_amplitude_m*/,
			const steadyhand::Arrival &, const steadyhand::Arrival & /*p_onset*/) {}

	/// Whether play() is used. Its motion takes several evaluations.
	virtual bool is_live() const { return false; }
	/// Called once a frame.
	virtual void play(const steadyhand::LiveMotion &) {}
};

/// A sink whose samples are made later, by another thread or for a script.
class LiveSink : public HapticSink {
public:
	LiveSink() : link_(std::make_shared<steadyhand::VibrationLink>()) {}

	void set_effects(const steadyhand::EffectSet &p_effects) override { link_->effects.publish(p_effects); }
	std::uint64_t oldest_generation() const override {
		return link_->oldest_generation.load(std::memory_order_acquire);
	}
	bool is_live() const override { return true; }
	void play(const steadyhand::LiveMotion &p_motion) override { link_->motion.publish(p_motion); }

	const std::shared_ptr<steadyhand::VibrationLink> &link() const { return link_; }

private:
	std::shared_ptr<steadyhand::VibrationLink> link_;
};

} // namespace godot
