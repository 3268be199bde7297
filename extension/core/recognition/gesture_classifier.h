#pragma once

#include "gesture/classifier_model.h"
#include "gesture/hand_motion.h"
#include "gesture/symbol_clock.h"
#include "hmm/filler_filter.h"
#include "hmm/scaled_recursion.h"
#include "signal/ring.h"
#include "tracking/frame.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// How well what the hand does agrees with a gesture.
struct GestureCandidate {
	double posterior = 0.0; ///< among all gestures and the filler, over all onsets
	/// What follows is of the likeliest onset.
	double onset_s = 0.0;                              ///< the hand rested there, and moves since
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero(); ///< of the index tip
	double start_radius_m = 0.0;                       ///< of the three tips' circle
	Eigen::Vector3d axis =
			Eigen::Vector3d::Zero();     ///< unit vector from there to the tip; zero where it is there
	double log_likelihood_ratio = NEVER; ///< against the filler, nats
	double end_probability = 0.0;        ///< that the hand has arrived, if it makes the gesture
};

struct ClassifierOptions {
	/// Odds of an onset at a given instant, for each gesture. The threshold between misses and false alarms.
	double onset_prior = 3e-5;
	/// Radians, log_direction_ratio()'s: gestures may run 20 degrees off their axes.
	double direction_width = 0.42;
	double jitter_m = 0.005; ///< of a tracked tip
	/// A hand is at rest that has moved less far within REST_SYMBOLS; only there gestures begin.
	double rest_m = 0.015;
	/// What a symbol counts of an observation: velocities are slopes over HandMotionWindow::WINDOW_S, and
	/// symbols that share frames do not observe the hand anew.
	double evidence = SymbolClock::PERIOD_S / HandMotionWindow::WINDOW_S;
};

/// Finds in a stream of frames which gesture is under way, since when, and whether it has come to its end, by
/// the forward variables of HMMs against those of a filler model (Lee and Kim 1999, doi:10.1109/34.799904).
/// Several possible onsets are followed side by side, each with observations relative to the hand at that
/// onset. Causal; nothing is allocated but by construction; the cost of a frame does not depend on how long
/// the stream is.
class GestureClassifier {
public:
	/// gestures: names, each once; of one that the model does not have the posterior is 0.
	GestureClassifier(std::shared_ptr<const ClassifierModel> model, std::vector<std::string> gestures,
			const ClassifierOptions &options = {});

	/// From now on these; what is known of those that were expected before is kept. Allocates.
	void expect(std::vector<std::string> gestures);
	[[nodiscard]] const std::vector<std::string> &gestures() const { return gestures_; }

	/// A frame that is not after the last one is passed over.
	void push(const HandFrame &frame);
	void reset();
	/// Onsets before t_s are possible no longer: the gesture since then is over.
	void forget_before(double t_s);

	/// One for each gesture, in the order in which they were given, at time_s().
	[[nodiscard]] std::span<const GestureCandidate> candidates() const { return candidates_; }
	/// Probability that the hand makes none of the gestures.
	[[nodiscard]] double filler_posterior() const { return filler_posterior_; }
	/// The newest instant of the SymbolClock at which something was seen.
	[[nodiscard]] double time_s() const { return time_s_; }

private:
	/// Onsets that are followed at once; a new one is tried so many symbols after the last.
	static constexpr int ONSETS = 16, ONSET_STEP = 5;
	static constexpr std::size_t REST_SYMBOLS = 15;
	/// No gesture goes on after a longer gap, nor does the hand's rest.
	static constexpr double LONGEST_GESTURE_GAP_S = 10.0;

	struct Onset {
		bool is_used = false;
		int age = 0; ///< symbols
		double t_s = 0.0;
		MotionObserver observer; ///< holds the hand at the onset
		double weight = 0.0;     ///< of the likeliest gesture, against the filler
	};
	struct Hypothesis {
		std::size_t gesture;
		const DirectedHmm *model;
		Eigen::VectorXd pi;
		Eigen::MatrixXd b; ///< as LinearHmm's
		ScaledRecursion<ONSETS> forward;
		std::vector<double> emissions; ///< N x ONSETS, as ScaledRecursion::step() takes them
	};

	std::shared_ptr<const ClassifierModel> model_;
	ClassifierOptions options_;
	FillerModel filler_;
	FillerFilter<ONSETS> filler_filter_;
	std::vector<std::string> gestures_;
	std::vector<Hypothesis> hypotheses_;
	std::array<Onset, ONSETS> onsets_{};
	std::array<Eigen::Index, ONSETS> columns_{}; ///< of emissions, of each onset's newest symbol
	std::vector<GestureCandidate> candidates_;
	std::vector<double> greatest_; ///< of each candidate, the weight of its likeliest onset
	double filler_posterior_ = 1.0;
	SymbolClock clock_;
	HandMotionWindow window_;
	Ring<HandMotion, REST_SYMBOLS> recent_;
	bool has_started_ = false;
	bool is_new_ = false; ///< a frame since the last instant
	double last_s_ = 0.0, time_s_ = 0.0;
	int until_onset_ = 0;

	[[nodiscard]] Hypothesis hypothesis_of(std::size_t gesture, const DirectedHmm &model) const;
	void step(double t_s);
	void step_onsets(const HandMotion &motion);
	void start_onset(std::size_t lane, const HandMotion &motion);
	[[nodiscard]] bool is_at_rest() const;
	[[nodiscard]] std::size_t least_likely_onset() const;
	void evaluate(const HandMotion &motion);
	void weigh(const Hypothesis &hypothesis, std::size_t lane, const HandMotion &motion);
};

} // namespace steadyhand
