#include "motion/paper_synthesiser.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

void PaperSynthesiser::play(double t_s, double phase_from, double element_duration_s) {
	entered_s_ = t_s;
	phase_at_entry_ = phase_from;
	rate_per_s_ = (element(state_).phase_end - phase_from) / element_duration_s;
}

void PaperSynthesiser::begin(double t_s, double phase) {
	state_ = 0;
	const PrimitiveMotionElement &first = element(0);
	phase = std::clamp(phase, 0.0, first.phase_end);
	// The pace is not known yet. The first state gets its mean duration, and the begin at which a hand of the
	// mean pace reaches this phase now.
	const double seconds_per_phase = first.duration_mean_s / (first.phase_end - first.phase_begin);
	began_s_ = t_s - seconds_per_phase * (phase - first.phase_begin);
	play(t_s, phase, std::max(seconds_per_phase * (first.phase_end - phase), 1e-3));
	blend_from({}, t_s);
}

void PaperSynthesiser::enter_state(int state, double entered_s, double t_s) {
	double expected_s = 0.0;
	for (int i = 0; i < state; ++i) {
		expected_s += element(i).duration_mean_s;
	}
	const double slower = (entered_s - began_s_) / expected_s;
	const double phase_now = phase(t_s);
	const Motion before = motion(t_s, 1.0);
	state_ = state;
	const double late_s = t_s - entered_s;
	play(t_s, phase_now, std::max(slower * element(state).duration_mean_s - late_s, 1e-3));
	blend_from(before, t_s);
}

void PaperSynthesiser::blend_from(const Motion &before, double t_s) {
	blend_.start(t_s, before, played(t_s), parameters::FRAME_BLEND_PER_S);
}

double PaperSynthesiser::phase(double t_s) const {
	return std::min(phase_at_entry_ + rate_per_s_ * (t_s - entered_s_), element(state_).phase_end);
}

Motion PaperSynthesiser::played(double t_s) const {
	const double now = phase(t_s), end = element(state_).phase_end;
	const CurvePoint point = evaluate(*model_, now);
	const Motion playing{ point.value, point.slope * rate_per_s_, point.curvature * rate_per_s_ * rate_per_s_,
		now };
	if (now < end || rate_per_s_ <= 0.0) {
		return playing;
	}
	// The element is over and waits at its end. Its end velocity decays.
	OutputBlend stop;
	stop.start(entered_s_ + (end - phase_at_entry_) / rate_per_s_, 0.0, playing.velocity_m_s,
			parameters::FRAME_BLEND_PER_S);
	return stop.completed({ point.value, 0.0, 0.0, now }, t_s);
}

Motion PaperSynthesiser::motion(double t_s, double amplitude_m) const {
	const Motion motion = blend_.completed(played(t_s), t_s);
	if (!(std::abs(motion.value_m) <= FARTHEST_VALUE)) {
		return { std::copysign(FARTHEST_VALUE, motion.value_m) * amplitude_m, 0.0, 0.0, motion.progress };
	}
	return { amplitude_m * motion.value_m, amplitude_m * motion.velocity_m_s,
		amplitude_m * motion.acceleration_m_s2, motion.progress };
}

} // namespace steadyhand
