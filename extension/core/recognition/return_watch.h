#pragma once

#include "strokes/stroke_finder.h"

#include <cmath>

namespace steadyhand {

/// Tells when a hand has come back after a gesture whose task is not known. Ways are in metres along the
/// gesture's: `gone` without the steps that no hand makes, `shown` with them.
class ReturnWatch {
public:
	/// A gesture has begun.
	void begin(double shown_m) { furthest_shown_m_ = shown_m; }
	/// At each frame in which the hand has a place. amplitude_m: of the gesture.
	void see(const StrokeFinder &strokes, double gone_m, double shown_m, double amplitude_m);
	/// The gesture is over.
	void end(double t_s, double gone_m);
	/// Since the end.
	[[nodiscard]] bool has_returned() const;

private:
	double ended_s_ = 0.0;
	double gone_m_ = 0.0, shown_m_ = 0.0;
	double furthest_m_ = 0.0;       ///< since the end
	double furthest_shown_m_ = 0.0; ///< since the beginning
	double news_s_ = -INFINITY;     ///< when the hand was last seen
	double speed_m_s_ = 0.0;        ///< how fast it was then
	double found_s_ = -INFINITY;    ///< when one that was lost on its way was seen again
};

} // namespace steadyhand
