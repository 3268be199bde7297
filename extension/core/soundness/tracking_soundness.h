#pragma once

#include "gesture/feature.h"
#include "soundness/skipped_frames.h"
#include "soundness/tracker_noise.h"
#include "soundness/tracker_silence.h"
#include "soundness/tracker_standstill.h"
#include "soundness/way_shape.h"

#include <cmath>
#include <optional>

namespace steadyhand {

/// How far a tracker is to be believed, judged by the motion alone, because it says little about its own
/// errors: gaps between stamps, values that repeat or stop dead, steps that no hand makes, in whichever
/// direction. Evidence fades over seconds.
class TrackingSoundness {
public:
	/// x: the motion element; place: where the hand is, from any origin that stays, always zero where the
	/// feature has no place. Both in amplitudes.
	void push(double t_s, double x, const FeaturePlace &place = FeaturePlace::Zero());

	/// 0: nothing wrong has been seen .. 1.
	[[nodiscard]] double unsoundness() const { return 1.0 - std::exp(-evidence_.now); }
	/// The same, remembered for longer: what is known of this tracker, not of this moment.
	[[nodiscard]] double lasting_unsoundness() const { return 1.0 - std::exp(-evidence_.lasting); }
	/// How far the tracker is to be taken for a late one, for as long: 0..1. Most of all where it loses the
	/// hand.
	[[nodiscard]] double lateness() const { return 1.0 - std::exp(-evidence_.late); }
	/// Evidence that the newest frame adds, 1: as bad as a jump. Below 0 where it takes the one before back,
	/// which was a single frame elsewhere.
	[[nodiscard]] double fault() const { return fault_.now; }
	/// What of it says that the hand has been lost: a gap before the newest frame, or a freeze.
	[[nodiscard]] double loss() const { return loss_; }
	/// What of it takes back.
	[[nodiscard]] double taken_back() const { return taken_back_.now; }
	/// All frames after this one, but for the newest, showed the hand elsewhere, and are as if they had not
	/// been; infinite where there are none of these.
	[[nodiscard]] double forgotten_since_s() const { return forgotten_since_s_; }
	/// The newest frame is off the way, as jumped(), in whichever direction.
	[[nodiscard]] bool leapt() const { return jumped_ || strayed_; }
	/// When a hand at rest was last shown in its place to the last bit: if it is there again soon, all that
	/// was shown since will be forgotten. Infinite where that is too long ago.
	[[nodiscard]] double held_s() const {
		const Held *const held = held_of_late();
		return held != nullptr ? held->shown_s : INFINITY;
	}
	[[nodiscard]] bool frozen() const { return silence_.is_frozen(); }
	/// The newest frame shows where the hand is.
	[[nodiscard]] bool told() const { return silence_.told(); }
	/// The newest value is off the way that the ones before it were on, further than a hand can bend it.
	[[nodiscard]] bool jumped() const { return jumped_; }
	/// The newest frame is the first in a while that tells where the hand is: what it did since news_s() is
	/// not known.
	[[nodiscard]] bool returned() const { return returned_; }
	/// How much the values shake from frame to frame: standard deviation of the white noise that would do so.
	[[nodiscard]] double jitter() const { return jitter_; }
	/// How long the hand has been slower than one that goes anywhere, by the frames that told where it is.
	[[nodiscard]] double slow_for_s() const { return standstill_.slow_for_s(); }
	/// How much likelier frames that were left out one at a time, and the shape of the way, are of a tracker
	/// that errs, as a logarithm; 0 and more.
	[[nodiscard]] double log_ratio() const { return skipped_.log_ratio() + way_shape_.log_ratio(); }
	/// What the newest frame has changed that by.
	[[nodiscard]] double log_ratio_news() const { return log_ratio_news_; }
	/// Evidence of the gap since the newest frame, if none came until t_s: what fault() would then say of it.
	[[nodiscard]] double missing(double t_s) const { return frames_ > 0 ? gap_fault(t_s - t_s_) : 0.0; }
	/// When a frame last told something new; not of the newest frame while that has jumped() or returned().
	[[nodiscard]] double news_s() const { return news_s_; }

private:
	/// The velocity that a hand would go on with.
	template <typename Velocity> struct Way {
		Velocity before_leap; ///< a leap says nothing of the hand's velocity,
		Velocity latest;      ///< but two in a row that agree do

		void go(const Velocity &velocity, bool leapt) {
			latest = velocity;
			before_leap = leapt ? before_leap : velocity;
		}
	};
	/// Of a fault, or of all so far.
	struct Evidence {
		double now = 0.0;
		double lasting = 0.0;
		double late = 0.0;

		void fade(double dt_s);
		void add(const Evidence &other, double sign = 1.0);
	};
	/// The frame before the newest that told something: from which that may have leapt away.
	struct Leap {
		double t_s = 0.0;
		double x = 0.0;
		FeaturePlace place = FeaturePlace::Zero();
		Evidence fault;
		TrackerSilence silence; ///< with that frame
	};

	/// A hand at rest that the tracker showed again, to the last bit.
	struct Held {
		double shown_s = 0.0; ///< the last time
		double x = 0.0;
		FeaturePlace place = FeaturePlace::Zero();
		TrackerSilence silence;
		TrackerStandstill standstill;
	};

	double t_s_ = 0.0;
	double x_ = 0.0; ///< of the newest frame that does not repeat the one before
	FeaturePlace place_ = FeaturePlace::Zero();
	TrackerSilence silence_;
	TrackerStandstill standstill_;
	TrackerNoise noise_;
	TrackerNoise place_noise_; ///< in the first coordinate of the place
	SkippedFrames skipped_;
	WayShape way_shape_;
	double log_ratio_news_ = 0.0;
	double news_s_ = 0.0;
	double period_s_ = 0.01; ///< between frames
	Evidence evidence_;
	Evidence fault_;
	Evidence taken_back_; ///< of it
	double forgotten_since_s_ = INFINITY;
	double loss_ = 0.0;
	double way_s_ = 0.0; ///< of the newest frame that the ways took in
	Way<double> step_way_{ 0.0, 0.0 };
	Way<FeaturePlace> place_way_{ FeaturePlace::Zero(), FeaturePlace::Zero() };
	Leap leap_;
	std::optional<Held> held_;
	Evidence freeze_;    ///< of the one that goes on, what has not faded
	bool leapt_ = false; ///< the newest frame that told something did
	double jitter_ = 0.0;
	int frames_ = 0;
	bool jumped_ = false;
	bool returned_ = false;
	bool strayed_ = false; ///< as jumped_, in any direction

	[[nodiscard]] double gap_fault(double frame_s) const;
	template <typename Step>
	[[nodiscard]] double bend_of(const Way<Step> &way, const Step &step, double dt_s) const;
	void weigh(double frame_s, double x, const FeaturePlace &place);
	void count_fault(bool repeats, bool is_still);
	void stand(bool repeats);
	void rest();
	[[nodiscard]] Evidence needless_of_freeze(double x);
	/// Null where that is too long ago.
	[[nodiscard]] const Held *held_of_late() const {
		return held_ && t_s_ - held_->shown_s < TrackerSilence::BACK_S ? &*held_ : nullptr;
	}
	bool forget_elsewhere(double x, const FeaturePlace &place, bool stands);
	[[nodiscard]] bool was_outlier(double x, const FeaturePlace &place) const;
	void forget_outlier();
	void forget_all_since(const Held &held);
	void follow(double x, const FeaturePlace &place);
	void judge(double dt_s, double step, const FeaturePlace &place_step);
};

} // namespace steadyhand
