#pragma once

#include "signal/sample_clock.h"

#include <cmath>
#include <numbers>

namespace steadyhand {

/// The One Euro filter: a first-order low-pass whose cutoff rises with speed (Casiez, Roussel, Vogel, CHI
/// 2012, DOI 10.1145/2207676.2208639). Each step has its own length instead of a fixed rate. The speed is the
/// difference to the last filtered value, as in the article and in its authors' code since August 2023.
class OneEuro {
public:
	/// Tuned once on the synthetic people of the tuning population. A camera tracker's error is slow. So the
	/// zero-lag R^2 rises with beta until nothing is filtered (docs/method.md). At 20 Hz per m/s the filter
	/// still smooths a resting finger (1 Hz), and the R^2 of drags is within 0.01 of the best. At 90 Hz a
	/// hand at 0.4 m/s then has a lag of 10 ms.
	struct Tuning {
		double min_cutoff_hz = 1.0;   ///< > 0
		double beta_per_m = 20.0;     ///< increase of the cutoff in Hz per m/s; >= 0
		double speed_cutoff_hz = 1.0; ///< of the low-pass of the speed; the authors' constant; > 0
	};

	OneEuro() : OneEuro(Tuning{}) {}
	explicit OneEuro(const Tuning &tuning) : tuning_(tuning) {}

	/// Filtered position, m, at t_s. A sample that SampleClock ignores does not change the output. 0 before
	/// the first sample.
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
	/// Weight of the new sample in a low-pass: 1 / (1 + tau / step), tau = 1 / (2 pi cutoff).
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
