#pragma once

#include "tracking/frame.h"

namespace steadyhand::matrix {

/// The motion put out at one instant, and what has happened since the instant before.
struct Output {
	double value_m = 0.0;
	double velocity_m_s = 0.0;
	int started = 0, ended = 0, aborted = 0; ///< how many gestures

	bool operator==(const Output &) const = default;
};

/// What the matrix measures: one gesture, whose task is known, followed through a stream of frames.
class Estimator {
public:
	Estimator() = default;
	Estimator(const Estimator &) = delete;
	Estimator &operator=(const Estimator &) = delete;
	virtual ~Estimator() = default;

	virtual void push(const HandFrame &frame) = 0;
	/// t_s: not before an earlier one, nor before the last frame; called once a millisecond.
	virtual Output advance(double t_s) = 0;
};

} // namespace steadyhand::matrix
