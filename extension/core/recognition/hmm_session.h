#pragma once

#include "recognition/gesture_session.h"
#include "recognition/gesture_spotter.h"

namespace steadyhand {

/// Follows a gesture without a task in `paper` mode. A GestureSpotter says when it begins, ends and is
/// aborted. The states since its onset are decoded once it has begun. The motion is the way along the hand's
/// own direction; the model's mean amplitude stands in for the task's.
class HmmSession final : public GestureSession {
public:
	/// spotter: outlives the session, and is given each frame before the session is.
	HmmSession(const GestureModel &model, const Synthesis &synthesis, GestureSpotter &r_spotter);

	/// Whether the HMMs include the model's gesture, by the same feature.
	[[nodiscard]] static bool can_follow(const GestureModel &model, const ClassifierModel &hmms);

	[[nodiscard]] bool may_end() const override { return may_end_; }
	void end_gesture(double t_s) override;
	void ignore_before(double /*t_s*/) override {} // of an end the spotter forgets all onsets
	void abort(double t_s) override;
	void on_dropout(double t_s, const StrokeFinder &strokes) override;

private:
	GestureSpotter *spotter_;
	FeaturePlace start_ = FeaturePlace::Zero();
	FeaturePlace way_; ///< unit vector
	bool may_end_ = false;

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void begin_at_onset(double t_s, const StrokeFinder &strokes);
	void look_for_end(double t_s);
	void aim();
	[[nodiscard]] bool is_under_way() const {
		return spotter_->is_active() && spotter_->gesture() == model().gesture;
	}
	[[nodiscard]] double along(const FeaturePlace &place) const { return (place - start_).dot(way_); }
};

} // namespace steadyhand
