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
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// State of one gesture in a GestureClassifier.
struct GestureCandidate {
	double posterior = 0.0; ///< among all gestures and the filler, over all onsets
	/// The other members are for the likeliest onset.
	double onset_s = 0.0;                              ///< last instant at which the hand probably rested
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero(); ///< index tip at the onset
	double start_radius_m = 0.0;                       ///< radius of the three fingertips at the onset
	/// Unit vector from start_m to the index tip; zero if they are equal.
	Eigen::Vector3d axis = Eigen::Vector3d::Zero();
	bool is_radius = false; ///< of its HMM
	double reach =
			0.0; ///< greatest distance from the start, or growth of the radius, in DirectedHmm::reach_m
	double log_likelihood_ratio = NEVER; ///< gesture to filler, nats
	double end_probability = 0.0;        ///< P(the gesture has ended | the hand makes it)
};

struct ClassifierOptions {
	/// Prior odds of an onset at an instant, for each gesture. A higher value gives fewer misses and more
	/// false alarms.
	double onset_prior = 4e-4;
	/// Prior odds of the same movement in any direction, with any bow and of any length, to each gesture; of
	/// the growth of the radius to any length.
	double elsewhere = 0.3, elsewhere_radius = 0.16;
	/// Width for log_direction_ratio(), radians: gestures may deviate by 20 degrees from their axes.
	double direction_width = 0.42;
	double bow_width = 0.12; ///< for log_bow_ratio()
	/// Least standard deviation of the logarithm of reaches above the median: people often reach too far.
	double farther = 0.3;
	double jitter_m = 0.005; ///< of a tracked tip
	/// A hand whose index tip and radius have moved less than this within REST_S is at rest. Gestures
	/// begin only at rest.
	double rest_m = 0.025, rest_radius_m = 0.005;
	/// Standard deviations of the motion before the onset, in reaches: of a hand at rest, and of any hand,
	/// per second.
	double rest_motion = 0.11, other_motion_per_s = 1.5;
	/// A gesture may be repeated without a rest for this time after its end. Later the hand may do anything.
	double repetition_s = 3.0;
	/// Exponent of the likelihood of a symbol. Symbols are independent after twice
	/// HandMotionWindow::WINDOW_S: velocities are slopes over this time, and the tracker's errors last.
	double evidence = 0.5 * SymbolClock::PERIOD_S / HandMotionWindow::WINDOW_S;
};

/// Finds the present gesture in a stream of frames, its onset, and whether it has ended. It compares the
/// forward variables of HMMs with those of a filler model (Lee and Kim 1999, doi:10.1109/34.799904). It
/// follows several possible onsets in parallel. Each has observations relative to the hand at that onset.
/// Causal. Only the constructor and expect() allocate. The cost of a frame is constant.
class GestureClassifier {
public:
	/// model: of the codebook and the filler. gestures: different names, with HMMs over this codebook. The
	/// posterior of a gesture without HMMs is 0.
	GestureClassifier(std::shared_ptr<const ClassifierModel> model, std::vector<GestureHmms> gestures,
			const ClassifierOptions &options = {});

	/// Replaces the gestures. The same HMMs as before keep their state. Allocates.
	void expect(std::vector<GestureHmms> gestures);
	[[nodiscard]] const std::vector<GestureHmms> &gestures() const { return gestures_; }

	/// A frame that is not later than the last one is ignored.
	void push(const HandFrame &frame);
	void reset();
	/// Deletes the onsets before t_s.
	void forget_before(double t_s);
	/// A gesture has ended and may be repeated: for a short time, onsets near its start need no rest.
	void expect_repetition_of(const GestureCandidate &gesture);

	/// One for each of gestures(), in this order, at time_s().
	[[nodiscard]] std::span<const GestureCandidate> candidates() const { return candidates_; }
	/// The newest instant of the SymbolClock with a new frame.
	[[nodiscard]] double time_s() const { return time_s_; }

private:
	/// Number of onsets in parallel, and symbols between two of them.
	static constexpr int ONSETS = 16, ONSET_STEP = 5;
	static constexpr double REST_S = 0.4;
	/// Rests of 1 to RESTS times REST_S are measured before an onset.
	static constexpr std::size_t RESTS = 4;
	/// Greatest distances of the hand from its place at an onset, in the time before it.
	struct Rest {
		double tip_m = 0.0, radius_m = 0.0;
		double tracked_s = 0.0;
	};
	struct Onset {
		bool is_used = false;
		int age = 0; ///< symbols
		double t_s = 0.0;
		MotionObserver observer; ///< holds the hand at the onset
		std::array<Rest, RESTS> rests{};
		/// Ages at which the index tip was farthest, and the radius greatest.
		int farthest_age = 0, growth_age = 0;
		double weight = 0.0; ///< of the likeliest gesture, relative to the filler
	};
	struct Hypothesis {
		std::size_t gesture;
		const DirectedHmm *model; ///< of GestureHmms::hmms
		double share;             ///< prior probability of its pace
		double elsewhere;         ///< prior odds of its movement anywhere, to a gesture
		Eigen::VectorXd pi;
		Eigen::MatrixXd b; ///< as in LinearHmm
		ScaledRecursion<ONSETS> forward;
		std::vector<double> emissions; ///< N x ONSETS, for ScaledRecursion::step()
		/// Last instants at which the first state was likelier than all others.
		std::array<double, ONSETS> rested_s{};
	};

	std::shared_ptr<const ClassifierModel> model_;
	ClassifierOptions options_;
	FillerModel filler_;
	FillerFilter<ONSETS> filler_filter_;
	std::vector<GestureHmms> gestures_;
	std::vector<Hypothesis> hypotheses_;
	std::array<Onset, ONSETS> onsets_{};
	std::array<Eigen::Index, ONSETS> columns_{}; ///< newest symbol of each onset
	std::vector<GestureCandidate> candidates_;
	double elsewhere_ = 0.0;       ///< weight of movements that are no gesture, relative to the filler
	std::vector<double> greatest_; ///< weight of the likeliest onset of each candidate
	SymbolClock clock_;
	HandMotionWindow window_;
	struct Recent {
		double t_s = 0.0;
		HandMotion motion;
	};
	Ring<Recent, 160> recent_; ///< for RESTS * REST_S
	bool has_started_ = false;
	bool is_new_ = false; ///< a frame came since the last instant
	double last_s_ = 0.0, time_s_ = 0.0;
	double seen_s_ = 0.0; ///< last frame with an index tip, or the first frame
	int until_onset_ = 0;
	GestureCandidate repeated_; ///< of expect_repetition_of()
	double repeated_until_s_ = -INFINITY;

	[[nodiscard]] Hypothesis hypothesis_of(std::size_t gesture, const DirectedHmm &model) const;
	void step(double t_s);
	void step_onsets(const HandMotion &motion);
	void start_onset(std::size_t lane, const HandMotion &motion, const std::array<Rest, RESTS> &rests);
	[[nodiscard]] bool is_at_repeated_start(const HandMotion &motion) const;
	[[nodiscard]] std::array<Rest, RESTS> rests_before_now() const;
	[[nodiscard]] double rest_ratio(const Hypothesis &hypothesis, std::size_t lane) const;
	[[nodiscard]] std::size_t least_likely_onset() const;
	void evaluate();
	void weigh(Hypothesis &r_hypothesis, std::size_t lane, double bow);
};

} // namespace steadyhand
