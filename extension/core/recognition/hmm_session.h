#pragma once

#include "recognition/gesture_session.h"
#include "recognition/gesture_spotter.h"

namespace steadyhand {

/// A gesture without a task. A GestureSpotter detects its begin, end and abort. At the begin the frames since
/// the onset are replayed and decoded. The motion element is measured along the hand's own direction. The
/// amplitude is the model's mean.
class HmmSession final : public GestureSession {
public:
	/// r_spotter must outlive the session, and must get each frame before the session.
	HmmSession(const GestureModel &model, const Synthesis &synthesis, GestureSpotter &r_spotter);

	/// The model's own HMMs; if it has none, those of own_classifier().
	[[nodiscard]] static GestureHmms hmms_of(const std::shared_ptr<const GestureModel> &model);
	/// True if hmms_of() includes the model's gesture, with the same feature.
	[[nodiscard]] static bool can_follow(const std::shared_ptr<const GestureModel> &model);

	[[nodiscard]] bool may_end() const override { return may_end_; }
	void end_gesture(double t_s) override;
	void ignore_before(double /*t_s*/) override {} // the spotter deletes all onsets at an end
	void abort(double t_s) override;

private:
	GestureSpotter *spotter_;
	FeaturePlace start_ = FeaturePlace::Zero();
	FeaturePlace direction_;  ///< unit vector
	double farthest_m_ = 0.0; ///< of the motion element since the onset
	/// Last place to which the hand moved, and its time.
	FeaturePlace moved_to_ = FeaturePlace::Zero();
	double moved_s_ = -INFINITY;
	bool may_end_ = false;

	std::optional<double> measure(const HandFrame &frame, const FeatureTrack &track) override;
	void update_stage(double t_s, const FeatureTrack &track) override;
	void begin_at_onset(double t_s, const FeatureTrack &track);
	void look_for_end(double t_s, const FeatureTrack &track);
	void decide(double t_s, double least);
	void aim_at(const GestureCandidate *candidate, const FeatureTrack &track);
	void follow_hand_path(double t_s, double noise_m);
	[[nodiscard]] bool is_spotted() const {
		return spotter_->is_active() && spotter_->gesture() == model().gesture;
	}
	[[nodiscard]] double along(const FeaturePlace &place) const { return (place - start_).dot(direction_); }
};

} // namespace steadyhand
