#pragma once

#include "gesture/gesture_model.h"
#include "motion/motion.h"
#include "motion/output_blend.h"

namespace steadyhand {

/// `paper` mode: plays the motion elements, one for each state of the HMM (paper, "the primitive motion
/// elements are adaptively modulated by estimating the duration of HMM states").
///
/// - An element lasts as long as its state is expected to: the mean duration of the state, times the duration
///   of the earlier states relative to their mean.
/// - If an element is over before the next state is recognised, it waits at its end.
/// - If the next state is recognised first, the rest of the element plays within the next element's time.
/// - Steps of the value at the start, and of the velocity at each state change, are blended.
///
/// Between state changes the phase is a closed form of time, so the rate of the calls does not matter.
/// docs/method.md has the departures from the paper.
class PaperSynthesiser {
public:
	/// model must outlive the synthesiser.
	explicit PaperSynthesiser(const GestureModel &model) : model_(&model) {}

	/// The gesture begins at t_s in its first state, at this phase of the reference curve.
	void begin(double t_s, double phase);
	/// Plays the element of `state` from t_s on. `state` is greater than the last one, and the HMM entered it
	/// at entered_s <= t_s (earlier if the decoder has a lag). The element ends as if it had begun at
	/// entered_s.
	void enter_state(int state, double entered_s, double t_s);

	/// Phase at t_s, 0..1. t_s must not be before the last change.
	[[nodiscard]] double phase(double t_s) const;
	/// Motion at t_s for a task of this amplitude. The value is limited to +-FARTHEST_VALUE amplitudes.
	[[nodiscard]] Motion motion(double t_s, double amplitude_m) const;

private:
	const GestureModel *model_;
	int state_ = 0;
	double began_s_ = 0.0;   ///< begin of the first state
	double entered_s_ = 0.0; ///< begin of the element that plays
	double phase_at_entry_ = 0.0;
	double rate_per_s_ = 0.0; ///< d phase / dt while the element plays
	OutputBlend blend_;       ///< of the step at the last change, amplitudes

	void play(double t_s, double phase_from, double element_duration_s);
	/// Motion without blend_, in amplitudes.
	[[nodiscard]] Motion played(double t_s) const;
	void blend_from(const Motion &before, double t_s);
	[[nodiscard]] const PrimitiveMotionElement &element(int state) const {
		return model_->elements[static_cast<std::size_t>(state)];
	}
};

} // namespace steadyhand
