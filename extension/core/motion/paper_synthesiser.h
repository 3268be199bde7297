#pragma once

#include "gesture/gesture_model.h"
#include "motion/motion.h"
#include "motion/output_blend.h"

namespace steadyhand {

/// `paper` mode: plays the motion elements out state by state. Each element is spread over the time that its
/// state is expected to last: its mean duration, times how much longer than the mean the states before it
/// have lasted (paper, "the primitive motion elements are adaptively modulated by estimating the duration of
/// HMM states"). An element that is through before the next state is recognised waits at its end; one that is
/// interrupted is finished faster, within the next element's time. What would step all the same, the value at
/// the start and the velocity at each change, is blended. docs/method.md says where the paper is silent and
/// what is read here.
///
/// Between state changes the phase is a closed form of time: the motion does not depend on how often it is
/// asked for.
class PaperSynthesiser {
public:
	/// model must outlive the synthesiser.
	explicit PaperSynthesiser(const GestureModel &model) : model_(&model) {}

	/// The gesture has begun, in its first state, at this phase of the reference.
	void begin(double t_s, double phase);
	/// At t_s it is known that the HMM moved on to `state`, greater than the one before, at entered_s: then,
	/// or earlier, by a decoder that waits. The element is through when it would be, had it begun in time.
	void enter_state(int state, double entered_s, double t_s);

	/// Phase at t_s, not before the last change: 0..1.
	[[nodiscard]] double phase(double t_s) const;
	/// Motion at t_s for a task of this amplitude; it is held at FARTHEST_VALUE, whatever a model says.
	[[nodiscard]] Motion motion(double t_s, double amplitude_m) const;

private:
	const GestureModel *model_;
	int state_ = 0;
	double began_s_ = 0.0;   ///< when the first state was entered
	double entered_s_ = 0.0; ///< when the present one was
	double phase_at_entry_ = 0.0;
	double rate_per_s_ = 0.0; ///< d phase / dt while the element plays
	OutputBlend blend_;       ///< of the amplitude: what would step at the last change

	void play(double t_s, double phase_from, double element_duration_s);
	/// Without the blend, in amplitudes.
	[[nodiscard]] Motion played(double t_s) const;
	void blend_from(const Motion &before, double t_s);
	[[nodiscard]] const PrimitiveMotionElement &element(int state) const {
		return model_->elements[static_cast<std::size_t>(state)];
	}
};

} // namespace steadyhand
