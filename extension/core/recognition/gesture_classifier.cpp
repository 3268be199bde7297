#include "recognition/gesture_classifier.h"

#include "base/parameters.h"
#include "gesture/task.h"
#include "hmm/linear_hmm.h"
#include "recognition/path_densities.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace steadyhand {
namespace {

/// Range of the log of the length of other motion, which is log-uniform from 1 cm to 1 m: ln 100.
constexpr double OTHER_REACHES = 4.605;
/// Symbols. A younger onset is not replaced, because its weight is not yet known.
constexpr int YOUNG = 30;
/// Onsets closer together belong to the same rest.
constexpr double SAME_REST_M = 0.005;

/// The emissions to the power `evidence`.
LinearHmm tempered(DiscreteHmm hmm, double evidence) {
	hmm.log_b *= evidence;
	return LinearHmm(hmm);
}

/// a / b, at most 2^900, so that sums are finite.
double quotient(const ScaledNumber &a, const ScaledNumber &b) {
	constexpr std::int64_t MOST = 900;
	return a.mantissa / b.mantissa * power_of_two(std::min(a.exponent - b.exponent, MOST));
}

double normal_density(double off, double deviation) {
	const double x = off / deviation;
	return std::exp(-0.5 * x * x) / (deviation * std::sqrt(2.0 * std::numbers::pi));
}

/// Likelihood ratio, gesture to other motion, of an end at this reach. The density of its logarithm is a
/// normal one whose standard deviation differs below and above the median.
double reach_ratio(const DirectedHmm &model, double reach_m, const ClassifierOptions &options) {
	const double off = std::log(std::max(reach_m, SMALLEST_AMPLITUDE_M) / model.reach_m);
	const double below = model.reach_deviation, above = std::max(below, options.farther);
	const double deviation = off < 0.0 ? below : above;
	return OTHER_REACHES * normal_density(off, deviation) * 2.0 * deviation / (below + above);
}

/// Likelihood ratio, gesture to other motion, of the direction. The jitter of the tip turns short
/// displacements.
double direction_ratio(const Eigen::Vector3d &displacement_m, const Eigen::Vector3d &axis,
		const ClassifierOptions &options) {
	const double distance_m = displacement_m.norm();
	const double width = std::hypot(options.direction_width, options.jitter_m / distance_m);
	return std::isfinite(width)
			? std::exp(log_direction_ratio((displacement_m / distance_m - axis).norm(), width))
			: 1.0;
}

/// Likelihood ratio, gesture to other motion, of the bow. The path's jitter bends short displacements.
double bow_ratio(const MotionObserver &observer, const ClassifierOptions &options) {
	const double width = std::hypot(options.bow_width, options.jitter_m / observer.farthest_m().norm());
	return std::isfinite(width) ? std::exp(log_bow_ratio(observer.bow(), width)) : 1.0;
}

} // namespace

GestureClassifier::GestureClassifier(std::shared_ptr<const ClassifierModel> model,
		std::vector<GestureHmms> gestures, const ClassifierOptions &options) :
		model_(std::move(model)),
		options_(options), filler_(filler_of(*model_, options.evidence)), filler_filter_(filler_) {
	expect(std::move(gestures));
}

void GestureClassifier::expect(std::vector<GestureHmms> gestures) {
	// The old HMMs must outlive the old hypotheses.
	const std::vector<GestureHmms> gestures_before = std::exchange(gestures_, std::move(gestures));
	candidates_.resize(gestures_.size());
	greatest_.resize(gestures_.size());
	std::vector<Hypothesis> before = std::exchange(hypotheses_, {});
	for (std::size_t i = 0; i < gestures_.size(); ++i) {
		for (const DirectedHmm &model : *gestures_[i].hmms) {
			if (model.gesture != gestures_[i].gesture) {
				continue;
			}
			const auto known = std::ranges::find(before, &model, &Hypothesis::model);
			hypotheses_.push_back(known != before.end() ? std::move(*known) : hypothesis_of(i, model));
			hypotheses_.back().gesture = i;
		}
	}
	for (Hypothesis &hypothesis : hypotheses_) {
		const auto alike = std::ranges::count_if(hypotheses_, [&](const Hypothesis &other) {
			return other.model->is_radius == hypothesis.model->is_radius;
		});
		hypothesis.elsewhere =
				(hypothesis.model->is_radius ? options_.elsewhere_radius : options_.elsewhere) /
				static_cast<double>(alike);
	}
	evaluate();
}

/// A new hypothesis takes part in later onsets only.
GestureClassifier::Hypothesis GestureClassifier::hypothesis_of(
		std::size_t gesture, const DirectedHmm &model) const {
	LinearHmm linear = tempered(model.hmm, options_.evidence);
	const std::vector<double> emissions(static_cast<std::size_t>(linear.states()) * ONSETS, 1.0);
	ScaledRecursion<ONSETS> forward(linear.a, linear.b);
	const std::size_t alike = paces(*gestures_[gesture].hmms, model);
	return { gesture, &model, 1.0 / static_cast<double>(alike), 0.0, std::move(linear.pi),
		std::move(linear.b), std::move(forward), emissions };
}

void GestureClassifier::reset() {
	has_started_ = is_new_ = false;
	until_onset_ = 0;
	window_.reset();
	recent_.clear();
	repeated_until_s_ = -INFINITY;
	for (Onset &onset : onsets_) {
		onset.is_used = false;
	}
	std::ranges::fill(candidates_, GestureCandidate());
}

void GestureClassifier::forget_before(double t_s) {
	for (Onset &onset : onsets_) {
		onset.is_used = onset.is_used && onset.t_s >= t_s;
	}
	evaluate();
}

void GestureClassifier::expect_repetition_of(const GestureCandidate &gesture) {
	repeated_ = gesture;
	repeated_until_s_ = time_s_ + options_.repetition_s;
}

void GestureClassifier::push(const HandFrame &frame) {
	if (has_started_ && !(frame.t_s > last_s_)) {
		return;
	}
	// The hand may be elsewhere after a long dropout.
	if (has_started_ && frame.t_s - seen_s_ > parameters::LONG_DROPOUT_S) {
		reset();
	}
	if (!has_started_) {
		clock_.start(frame.t_s);
		has_started_ = true;
		seen_s_ = frame.t_s;
	}
	seen_s_ = frame.has(Joint::INDEX) ? frame.t_s : seen_s_;
	last_s_ = frame.t_s;
	// Instants before this frame use earlier frames only.
	for (; clock_.due(std::nextafter(frame.t_s, -INFINITY)); clock_.advance()) {
		step(clock_.next_s());
		is_new_ = false;
	}
	is_new_ = window_.push(frame) || is_new_;
}

void GestureClassifier::step(double t_s) {
	const HandMotion motion = window_.motion();
	step_onsets(motion);
	--until_onset_;
	if (!is_new_) {
		return;
	}
	time_s_ = t_s;
	recent_.push({ t_s, motion });
	if (until_onset_ <= 0) {
		const std::array<Rest, RESTS> rests = rests_before_now();
		if (rests[0].tip_m <= options_.rest_m && rests[0].radius_m <= options_.rest_radius_m) {
			until_onset_ = ONSET_STEP;
			start_onset(least_likely_onset(), motion, rests);
		}
	}
	evaluate();
}

void GestureClassifier::step_onsets(const HandMotion &motion) {
	for (std::size_t lane = 0; lane < ONSETS; ++lane) {
		Onset &onset = onsets_[lane];
		columns_[lane] = filler_.b.cols() - 1;
		if (!onset.is_used) {
			continue;
		}
		++onset.age;
		if (is_new_) {
			const double distance_m2 = onset.observer.farthest_m().squaredNorm();
			const double growth_m = onset.observer.growth_m();
			columns_[lane] = model_->codebook.symbol(onset.observer.observe(motion));
			onset.farthest_age =
					onset.observer.farthest_m().squaredNorm() > distance_m2 ? onset.age : onset.farthest_age;
			onset.growth_age = onset.observer.growth_m() > growth_m ? onset.age : onset.growth_age;
		}
		const int still = onset.age - std::max(onset.farthest_age, onset.growth_age);
		// The movement is over, and any end has been detected: the next movement is another one.
		onset.is_used = still * SymbolClock::PERIOD_S < parameters::PAUSE_S + parameters::DETECTION_S;
		filler_filter_.step(static_cast<int>(lane), filler_.b.col(columns_[lane]).data());
	}
	for (Hypothesis &hypothesis : hypotheses_) {
		double *emission = hypothesis.emissions.data();
		for (Eigen::Index j = 0; j < hypothesis.b.rows(); ++j) {
			for (const Eigen::Index column : columns_) {
				*emission++ = hypothesis.b(j, column);
			}
		}
		hypothesis.forward.step(hypothesis.emissions.data(), hypothesis.emissions.data());
	}
}

bool GestureClassifier::is_at_repeated_start(const HandMotion &motion) const {
	return time_s_ < repeated_until_s_ && (motion.tip_m - repeated_.start_m).norm() <= options_.rest_m &&
			std::abs(motion.radius_m - repeated_.start_radius_m) <= options_.rest_radius_m;
}

std::array<GestureClassifier::Rest, GestureClassifier::RESTS> GestureClassifier::rests_before_now() const {
	std::array<Rest, RESTS> rests{};
	const HandMotion &now = recent_.newest().motion;
	const bool needs_rest = !is_at_repeated_start(now);
	Rest rest;
	for (std::size_t i = recent_.size(); i > 0; --i) {
		const auto &[t_s, then] = recent_[i - 1];
		if (needs_rest) {
			rest.tip_m = std::max(rest.tip_m, (then.tip_m - now.tip_m).norm());
			rest.radius_m = std::max(rest.radius_m, std::abs(then.radius_m - now.radius_m));
		}
		rest.tracked_s = recent_.newest().t_s - t_s;
		const double longer = (rest.tracked_s + 0.5 * SymbolClock::PERIOD_S) / REST_S; // than this many rests
		std::fill(rests.begin() + static_cast<std::ptrdiff_t>(std::min<double>(longer, RESTS)), rests.end(),
				rest);
	}
	return rests;
}

/// Likelihood ratio, gesture to other motion, of the motion before the onset, for a time as long as the hand
/// moved since, up to its farthest place: a hand that wanders slowly hardly moves where it turns.
double GestureClassifier::rest_ratio(const Hypothesis &hypothesis, std::size_t lane) const {
	const DirectedHmm &model = *hypothesis.model;
	const Onset &onset = onsets_[lane];
	const int age = model.is_radius ? onset.growth_age : onset.farthest_age;
	const double moved_s = onset.t_s + age * SymbolClock::PERIOD_S - hypothesis.rested_s[lane];
	const double rests = std::clamp((moved_s + 0.5 * SymbolClock::PERIOD_S) / REST_S, 0.0, RESTS - 1.0);
	const Rest &rest = onset.rests[static_cast<std::size_t>(rests)];
	const double motion = (model.is_radius ? rest.radius_m : rest.tip_m) / model.reach_m;
	const double other = std::hypot(options_.rest_motion, options_.other_motion_per_s * rest.tracked_s);
	return normal_density(motion, options_.rest_motion) / normal_density(motion, other);
}

/// An unused one; otherwise the less likely one of two of the same rest; otherwise the least likely of all.
std::size_t GestureClassifier::least_likely_onset() const {
	std::size_t least = 0, least_of_rest = ONSETS;
	for (std::size_t i = 0; i < ONSETS; ++i) {
		const Onset &onset = onsets_[i];
		if (!onset.is_used) {
			return i;
		}
		if (onset.age < YOUNG) {
			continue;
		}
		if (onsets_[least].age < YOUNG || onset.weight < onsets_[least].weight) {
			least = i;
		}
		const bool is_of_one_rest = std::ranges::any_of(onsets_, [&](const Onset &other) {
			return &other != &onset && onset.weight <= other.weight &&
					(other.observer.onset().tip_m - onset.observer.onset().tip_m).norm() < SAME_REST_M &&
					std::abs(other.observer.onset().radius_m - onset.observer.onset().radius_m) < SAME_REST_M;
		});
		if (is_of_one_rest && (least_of_rest == ONSETS || onset.weight < onsets_[least_of_rest].weight)) {
			least_of_rest = i;
		}
	}
	return least_of_rest < ONSETS ? least_of_rest : least;
}

void GestureClassifier::start_onset(
		std::size_t lane, const HandMotion &motion, const std::array<Rest, RESTS> &rests) {
	Onset &onset = onsets_[lane] = { true, 0, time_s_, MotionObserver(motion), rests };
	const Eigen::Index column = columns_[lane] = model_->codebook.symbol(onset.observer.observe(motion));
	filler_filter_.start(static_cast<int>(lane), filler_.b.col(column).data());
	for (Hypothesis &hypothesis : hypotheses_) {
		hypothesis.forward.start(
				static_cast<int>(lane), hypothesis.pi.data(), hypothesis.b.col(column).data());
	}
}

void GestureClassifier::evaluate() {
	std::ranges::fill(candidates_, GestureCandidate());
	std::ranges::fill(greatest_, -1.0);
	elsewhere_ = 0.0;
	for (std::size_t lane = 0; lane < ONSETS; ++lane) {
		onsets_[lane].weight = 0.0;
		const double bow = onsets_[lane].is_used ? bow_ratio(onsets_[lane].observer, options_) : 1.0;
		for (Hypothesis &hypothesis : hypotheses_) {
			if (onsets_[lane].is_used) {
				weigh(hypothesis, lane, bow);
			}
		}
	}
	double all = 1.0 + elsewhere_; // 1: the filler
	for (const GestureCandidate &candidate : candidates_) {
		all += candidate.posterior;
	}
	for (GestureCandidate &candidate : candidates_) {
		candidate.posterior /= all;
	}
}

/// Adds the weight of a gesture and an onset, relative to the filler, to the candidate's posterior, which is
/// not normalised yet. The same movement anywhere is no gesture. bow: bow_ratio() of the onset.
void GestureClassifier::weigh(Hypothesis &r_hypothesis, std::size_t lane, double bow) {
	const DirectedHmm &model = *r_hypothesis.model;
	Onset &onset = onsets_[lane];
	const ScaledNumber all = r_hypothesis.forward.total(static_cast<int>(lane));
	if (all.mantissa == 0.0) {
		return; // the gesture was not expected at this onset
	}
	const ScaledNumber &filler = filler_filter_.likelihood(static_cast<int>(lane));
	const auto probability = [&](std::size_t state) {
		const std::size_t i = state * ONSETS + lane;
		return quotient({ r_hypothesis.forward.mantissas()[i], r_hypothesis.forward.exponents()[i] }, all);
	};
	const double rest = probability(0);
	if (onset.age == 0 || rest > 0.5) {
		r_hypothesis.rested_s[lane] = time_s_;
	}
	const auto states = static_cast<std::size_t>(r_hypothesis.pi.size());
	double end_probability = 0.0;
	for (std::size_t j = states - END_STATES; j < states; ++j) {
		end_probability += probability(j);
	}
	const Eigen::Vector3d &displacement_m = onset.observer.farthest_m();
	const double reach_m = model.is_radius ? onset.observer.growth_m() : displacement_m.norm();
	const double ended = end_probability * reach_ratio(model, reach_m, options_);
	const double begun = 1.0 - rest - end_probability + ended;
	const double of_movement = options_.onset_prior * quotient(all, filler);
	elsewhere_ += (r_hypothesis.elsewhere + r_hypothesis.share * rest) * of_movement;
	double weight = r_hypothesis.share * of_movement * begun * rest_ratio(r_hypothesis, lane);
	if (!model.is_radius) {
		weight *= direction_ratio(displacement_m, model.axis, options_) * bow;
	}
	onset.weight = std::max(onset.weight, weight);
	GestureCandidate &candidate = candidates_[r_hypothesis.gesture];
	candidate.posterior += weight;
	if (weight > greatest_[r_hypothesis.gesture]) {
		greatest_[r_hypothesis.gesture] = weight;
		candidate.onset_s = r_hypothesis.rested_s[lane];
		candidate.start_m = onset.observer.onset().tip_m;
		candidate.start_radius_m = onset.observer.onset().radius_m;
		candidate.axis = displacement_m.normalized();
		candidate.is_radius = model.is_radius;
		candidate.reach = reach_m / model.reach_m;
		candidate.log_likelihood_ratio = all.log() - filler.log();
		candidate.end_probability = begun > 0.0 ? ended / begun : 0.0;
	}
}

} // namespace steadyhand
