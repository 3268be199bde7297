#pragma once

#include "haptics/arrival_detector.h"
#include "haptics/effect.h"
#include "haptics/live_vibration.h"

#include <cstdint>

namespace godot {

/// Where a HapticSynth's vibration goes. A sink takes the motion either instant by instant, on the motion's
/// own clock, or live; what it has no use for it leaves alone. All on the scene's thread.
class HapticSink {
public:
	virtual ~HapticSink() = default;

	/// The effects' tables are kept as long as oldest_generation() is not above their generation.
	virtual void set_effects(const steadyhand::EffectSet &p_effects) = 0;
	virtual std::uint64_t oldest_generation() const = 0;

	/// Time starts anew.
	virtual void start_anew() {}
	/// At each control instant; `knot.moving` from there on. The last arrival and the last onset.
	virtual void advance(double, const steadyhand::MotionSnapshot::Knot &, double /*p_amplitude_m*/,
			const steadyhand::Arrival &, const steadyhand::Arrival & /*p_onset*/) {}

	/// Whether play() is wanted: the motion by now and soon costs some evaluations.
	virtual bool is_live() const { return false; }
	/// Once a frame.
	virtual void play(const steadyhand::LiveMotion &) {}
};

/// Samples of the live motion, made by another thread or at another's request.
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
