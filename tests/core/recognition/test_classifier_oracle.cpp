#include "base/random.h"
#include "classifier_streams.h"
#include "hmm/hmm_all_paths.h"
#include "hmm/hmm_log_space.h"
#include "hmm/hmm_random.h"
#include "near.h"

#include <numbers>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double EVIDENCE = 0.5, ONSET_PRIOR = 0.01, ELSEWHERE = 0.4;
constexpr int ONSET_STEP = 5; // symbols; equal to GestureClassifier's

/// Two gestures of four states and two states of other motion, over the codebook of the add-on.
std::shared_ptr<const ClassifierModel> small_model() {
	std::mt19937_64 random(5);
	ClassifierModel model;
	model.codebook = own_classifier()->codebook;
	const int symbols = model.codebook.symbols();
	for (const std::string name : { "horizontal_drag", "vertical_drag" }) {
		DirectedHmm gesture;
		gesture.gesture = name;
		gesture.axis = name == "horizontal_drag" ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
		gesture.reach_m = 0.2;
		gesture.reach_deviation = 0.3;
		gesture.hmm = random_hmm(random, 4, symbols);
		model.gestures.push_back(gesture);
	}
	model.other = random_hmm(random, 2, symbols);
	return std::make_shared<const ClassifierModel>(model);
}

/// The filler as an HMM.
DiscreteHmm filler_hmm(const ClassifierModel &model) {
	const FillerModel filler = filler_of(model, EVIDENCE);
	const Eigen::Index n = filler.stay.size();
	Eigen::MatrixXd a = ((1.0 - filler.stay.array()) / static_cast<double>(n - 1)).matrix().replicate(1, n);
	a.diagonal() = filler.stay;
	return { Eigen::VectorXd::Constant(n, -std::log(static_cast<double>(n))), a.array().log(),
		filler.b.leftCols(filler.b.cols() - 1).array().log() };
}

/// log P(symbols), and the probabilities of the first state and of the END_STATES, given the symbols.
/// Enumerates all paths of short sequences; otherwise uses the recursion in logarithms.
struct Likelihood {
	double log_all = 0.0, rest_share = 0.0, end_share = 0.0;
};

Likelihood likelihood_of(const DiscreteHmm &hmm, const SymbolSequence &symbols) {
	if (symbols.size() <= 7) {
		const AllPaths all = enumerate(hmm, symbols);
		return { std::log(all.ending_in.sum()), all.ending_in(0) / all.ending_in.sum(),
			all.ending_in.tail<END_STATES>().sum() / all.ending_in.sum() };
	}
	LongVector alpha = hmm.log_pi.cast<long double>() + hmm.log_b.col(symbols[0]).cast<long double>();
	for (std::size_t t = 1; t < symbols.size(); ++t) {
		LongVector next(hmm.states());
		for (Eigen::Index j = 0; j < hmm.states(); ++j) {
			next(j) = log_sum_exp(alpha + hmm.log_a.col(j).cast<long double>()) + hmm.log_b(j, symbols[t]);
		}
		alpha = next;
	}
	const long double all = log_sum_exp(alpha);
	return { static_cast<double>(all), static_cast<double>(std::exp(alpha(0) - all)),
		static_cast<double>((alpha.tail<END_STATES>().array() - all).exp().sum()) };
}

/// Motion of the hand at each frame.
std::vector<HandMotion> motions_of(const std::vector<HandFrame> &frames) {
	std::vector<HandMotion> motions;
	HandMotionWindow window;
	for (const HandFrame &frame : frames) {
		window.push(frame);
		motions.push_back(window.motion());
	}
	return motions;
}

/// Ratio of a direction density, exp(-(off / width)^6) over the plane, to 1 / (4 pi).
double direction_ratio(const Eigen::Vector3d &displacement_m, const Eigen::Vector3d &axis) {
	if (displacement_m.isZero(0.0)) {
		return 1.0;
	}
	const double width = std::hypot(0.42, 0.005 / displacement_m.norm());
	const double off = (displacement_m.normalized() - axis).norm();
	const double at_axis = std::max(12.0 / (width * width * std::tgamma(1.0 / 3.0)), 1.0);
	return at_axis * std::exp(-std::pow(off / width, 6.0));
}

/// Distance of the centre of a polygon from its chord, in lengths of the chord.
double bow_of(const std::vector<Eigen::Vector3d> &path_m) {
	Eigen::Vector3d centre = Eigen::Vector3d::Zero();
	double length_m = 0.0;
	for (std::size_t i = 1; i < path_m.size(); ++i) {
		const double piece_m = (path_m[i] - path_m[i - 1]).norm();
		centre += piece_m * 0.5 * (path_m[i] + path_m[i - 1]);
		length_m += piece_m;
	}
	centre /= length_m;
	const Eigen::Vector3d along = path_m.back().normalized();
	return (centre - centre.dot(along) * along).norm() / path_m.back().norm();
}

/// Ratio of a density of bows, exp(-(bow / width)^4), to a uniform one up to 0.5.
double bow_ratio(double bow, double length_m) {
	if (length_m == 0.0) {
		return 1.0;
	}
	const double width = std::hypot(0.12, 0.005 / length_m);
	return std::max(0.5 / (width * std::tgamma(1.25)), 1.0) * std::exp(-std::pow(bow / width, 4.0));
}

double normal(double x, double deviation) {
	return std::exp(-0.5 * x * x / (deviation * deviation)) / deviation;
}

/// Ratio of the densities of the motion in the 0.4 s before an onset. Longer movements need a longer rest.
double rest_ratio(const DirectedHmm &own, const std::vector<HandMotion> &motions, std::size_t onset) {
	const std::size_t first = onset + 1 > 40 ? onset + 1 - 40 : 0;
	double moved_m = 0.0;
	for (std::size_t i = first; i < onset; ++i) {
		moved_m = std::max(moved_m, (motions[i].tip_m - motions[onset].tip_m).norm());
	}
	const double x = moved_m / own.reach_m;
	return normal(x, 0.11) / normal(x, std::hypot(0.11, 1.5 * 0.01 * static_cast<double>(onset - first)));
}

/// Posterior by the sum over all segmentations: filler up to an onset, then a gesture, or its movement in any
/// direction, up to the newest instant.
double posterior_of(const ClassifierModel &model, std::size_t gesture, const std::vector<HandMotion> &motions,
		std::size_t newest) {
	const DiscreteHmm filler = filler_hmm(model);
	std::array<double, 2> weights{};
	double elsewhere = 0.0;
	for (std::size_t onset = 0; onset <= newest; onset += ONSET_STEP) {
		MotionObserver observer(motions[onset]);
		SymbolSequence symbols;
		Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero(); // to the farthest place
		std::vector<Eigen::Vector3d> path_m{ displacement_m };
		double bow = 0.0;
		for (std::size_t i = onset; i <= newest; ++i) {
			symbols.push_back(model.codebook.symbol(observer.observe(motions[i])));
			const Eigen::Vector3d now_m = motions[i].tip_m - motions[onset].tip_m;
			path_m.push_back(now_m);
			if (now_m.norm() > displacement_m.norm()) {
				displacement_m = now_m;
				bow = bow_of(path_m);
			}
		}
		const double log_filler = likelihood_of(filler, symbols).log_all;
		for (std::size_t g = 0; g < weights.size(); ++g) {
			const DirectedHmm &own = model.gestures[g];
			DiscreteHmm hmm = own.hmm;
			hmm.log_b *= EVIDENCE;
			const Likelihood likelihood = likelihood_of(hmm, symbols);
			const double off = std::log(std::max(displacement_m.norm(), 1e-6) / own.reach_m);
			const double z = off / (off < 0.0 ? own.reach_deviation : 0.3);
			const double reach = 4.605 * std::exp(-0.5 * z * z) /
					(0.5 * (own.reach_deviation + 0.3) * std::sqrt(2.0 * std::numbers::pi));
			const double movement = ONSET_PRIOR * std::exp(likelihood.log_all - log_filler);
			weights[g] += movement * (1.0 - likelihood.rest_share + likelihood.end_share * (reach - 1.0)) *
					rest_ratio(own, motions, onset) * direction_ratio(displacement_m, own.axis) *
					bow_ratio(bow, displacement_m.norm());
			elsewhere += (ELSEWHERE / 2.0 + likelihood.rest_share) * movement;
		}
	}
	return weights[gesture] / (1.0 + elsewhere + weights[0] + weights[1]);
}

TEST_CASE("posteriors equal the sum over all onsets and state paths") {
	const auto model = small_model();
	ClassifierOptions options;
	options.evidence = EVIDENCE;
	options.onset_prior = ONSET_PRIOR;
	options.elsewhere = ELSEWHERE;
	options.rest_m = 1e9; // any instant may be an onset
	GestureClassifier classifier(model, hmms_of(model, { "horizontal_drag", "vertical_drag" }), options);
	// So short that no onset is dropped. Each frame is between two instants, so the clock uses each once.
	const Reach reach{
		.start_s = 0.05, .duration_s = 0.5, .length_s = 0.7, .rate_hz = 100.0, .clock_s = 0.995
	};
	std::vector<HandFrame> frames = frames_of(reach);
	Random random(3);
	for (HandFrame &frame : frames) { // no reading is a repetition, which has no observation
		frame.set(Joint::INDEX,
				frame.position(Joint::INDEX) +
						Eigen::Vector3d(random.normal(0.0, 1e-5), random.normal(0.0, 1e-5), 0.0));
	}
	const std::vector<HandMotion> motions = motions_of(frames);
	for (std::size_t i = 0; i < frames.size(); ++i) {
		classifier.push(frames[i]);
		// An instant is processed at the next frame.
		if (i == 0 || (i % 7 != 0 && i > 12)) {
			continue;
		}
		CAPTURE(i);
		for (std::size_t g = 0; g < 2; ++g) {
			CHECK(classifier.candidates()[g].posterior ==
					near(posterior_of(*model, g, motions, i - 1)).epsilon(1e-6));
		}
	}
}

} // namespace
