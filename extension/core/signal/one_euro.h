#pragma once

#include "signal/sample_clock.h"

#include <cmath>
#include <numbers>

namespace steadyhand {

/// The One Euro filter: a first-order low-pass whose cutoff rises with speed (Casiez, Roussel, Vogel, CHI
/// 2012, DOI 10.1145/2207676.2208639), with each step's own length in place of a fixed rate. As in the
/// article and in its authors' code since August 2023, speed is taken against the last filtered value.
class OneEuro {
public:
	/// Tuned once, on synthetic subjects made for tuning, and the same everywhere. A camera tracker's error
	/// is slow, so R^2 at zero lag goes on rising with beta until nothing is filtered (docs/method.md); 20 Hz
	/// per m/s is where a resting finger is still smoothed (1 Hz) and a drag was within 0.01 of the best
	/// then. At 90 Hz a hand at 0.4 m/s is then seen 10 ms late.
	struct Tuning {
		double min_cutoff_hz = 1.0;   ///< > 0
		double beta_per_m = 20.0;     ///< cutoff in Hz added per m/s; >= 0
		double speed_cutoff_hz = 1.0; ///< of the low-pass on the speed; the authors' constant; > 0
	};

	OneEuro() : OneEuro(Tuning{}) {}
	explicit OneEuro(const Tuning &tuning) : tuning_(tuning) {}

	/// Filtered position (m) at t_s. What SampleClock ignores leaves the last output; 0 before any.
	double push(double t_s, double x_m) {
		switch (clock_.judge(t_s, x_m)) {
			case SampleClock::Verdict::IGNORE:
				break;
			case SampleClock::Verdict::START:
				output_m_ = x_m;
				speed_m_s_ = 0.0;
				break;
			case SampleClock::Verdict::ADVANCE: {
				const double step_s = clock_.step_s();
				const double raw_speed_m_s = (x_m - output_m_) / step_s;
				speed_m_s_ += weight(tuning_.speed_cutoff_hz, step_s) * (raw_speed_m_s - speed_m_s_);
				const double cutoff_hz = tuning_.min_cutoff_hz + tuning_.beta_per_m * std::abs(speed_m_s_);
				output_m_ += weight(cutoff_hz, step_s) * (x_m - output_m_);
				break;
			}
		}
		return output_m_;
	}

	[[nodiscard]] double output() const { return output_m_; }

private:
	/// The new sample's share in a low-pass: 1 / (1 + tau / step), tau = 1 / (2 pi cutoff).
	static double weight(double cutoff_hz, double step_s) {
		const double step_in_tau = 2.0 * std::numbers::pi * cutoff_hz * step_s;
		return step_in_tau / (1.0 + step_in_tau);
	}

	Tuning tuning_;
	SampleClock clock_;
	double output_m_ = 0.0;
	double speed_m_s_ = 0.0;
};

} // namespace steadyhand
