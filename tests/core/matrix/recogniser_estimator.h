#pragma once

#include "estimator.h"
#include "shown_changes.h"
#include "tracking/frame_filter.h"

#include <memory>

namespace steadyhand::matrix {

/// `phase` mode as a scene runs it: HandTracker's door, then a GestureRecogniser of one gesture.
class RecogniserEstimator : public Estimator {
public:
	RecogniserEstimator(
			const std::shared_ptr<const GestureModel> &model, const Task &task, double latency_s) :
			recogniser_({ { model, task } }, { .latency_s = latency_s }) {}

	void push(const HandFrame &frame) override {
		DeviceFrame shown;
		shown.hand = frame;
		filter_.clean(shown);
		recogniser_.push(shown.hand);
	}

	Output advance(double t_s) override {
		recogniser_.advance(t_s);
		const GestureChanges happened = shown_.next(recogniser_);
		const Motion motion = recogniser_.motion(MotionSource::SYNTHESISED);
		return { motion.value_m, motion.velocity_m_s, happened.started, happened.ended, happened.aborted };
	}

private:
	FrameFilter filter_;
	GestureRecogniser recogniser_;
	test::ShownChanges shown_;
};

} // namespace steadyhand::matrix
