// Time for recognition, synthesis and training, compared with a plain scaled forward pass (4 states, 16
// symbols) in the same run. The rounds of all rows alternate, and the least time counts, because other load
// only adds time. Of a difference of two times the median counts.
//
//     bench_recognition [MODELS]
//
// MODELS: folder of the models (default: models).

#include "hmm/baum_welch.h"
#include "hmm/fixed_lag_viterbi.h"
#include "hmm/forward.h"
#include "hmm/viterbi.h"
#include "models.h"
#include "recogniser_of.h"
#include "recognition/gesture_recogniser.h"
#include "simulation/synthetic_trial.h"
#include "timing.h"
#include "trained_models.h"

#include <Eigen/Geometry>

#include <cstdio>
#include <functional>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

constexpr int ROUNDS = 15;
constexpr int STATES = 4;
constexpr int SYMBOLS = 16;
constexpr std::size_t STREAM = 100000;
constexpr int SEQUENCES = 500; ///< of each gesture, for training
constexpr int SEQUENCE_LENGTH = 75;
constexpr int ITERATIONS = 3;

struct Row {
	std::string name;
	std::function<double()> measure; ///< one round; ns for one unit
	double target_ns = 0.0;          ///< 0: none
	bool is_difference = false;      ///< of two times: other load adds to either
};

/// Sequence of a left-right model. Each state prefers four symbols of its own.
SymbolSequence random_sequence(std::mt19937_64 &r_random, int length) {
	std::uniform_int_distribution<int> any(0, SYMBOLS - 1), own(0, SYMBOLS / STATES - 1);
	std::bernoulli_distribution is_own(0.8);
	SymbolSequence sequence;
	for (int t = 0; t < length; ++t) {
		const int state = t * STATES / length;
		sequence.push_back(is_own(r_random) ? state * (SYMBOLS / STATES) + own(r_random) : any(r_random));
	}
	return sequence;
}

/// Forward recursion with probabilities, scaled at each symbol (Rabiner 1989, section V.A).
class ScaledForward {
public:
	explicit ScaledForward(const DiscreteHmm &hmm) :
			a_(hmm.log_a.transpose().array().exp()), b_(hmm.log_b.array().exp()),
			pi_(hmm.log_pi.array().exp()) {}

	void reset() { alpha_ = pi_; }
	void push(Symbol symbol) {
		alpha_ = (a_ * alpha_).cwiseProduct(b_.col(symbol)).eval();
		alpha_ /= alpha_.sum();
	}

private:
	Eigen::Matrix<double, STATES, STATES> a_;
	Eigen::Matrix<double, STATES, SYMBOLS> b_;
	Eigen::Matrix<double, STATES, 1> pi_, alpha_ = pi_;
};

/// Time for a symbol, over STREAM symbols of gestures in turns. The filter is reset before each gesture.
template <class Filter> double ns_a_symbol(Filter filter, const std::vector<SymbolSequence> &gestures) {
	std::size_t symbols = 0;
	const double ns = ns_of([&] {
		for (std::size_t i = 0; symbols < STREAM; ++i) {
			filter.reset();
			for (const Symbol symbol : gestures[i % gestures.size()]) {
				filter.push(symbol);
				keep(filter);
			}
			symbols += gestures[i % gestures.size()].size();
		}
	});
	return ns / static_cast<double>(symbols);
}

double ns_an_iteration(const std::vector<std::vector<SymbolSequence>> &gestures) {
	BaumWelchOptions options;
	options.max_iterations = ITERATIONS;
	options.tolerance_nats = std::numeric_limits<double>::lowest();
	double ns = 0.0;
	for (const std::vector<SymbolSequence> &sequences : gestures) {
		const DiscreteHmm start = left_right_from_equal_segments(sequences, STATES, SYMBOLS, options.pseudo);
		ns += ns_of([&] { keep(baum_welch(start, sequences, options)); });
	}
	return ns / ITERATIONS;
}

/// Time for a frame, ns, over all trials. outputs: number of outputs for each millisecond; -1: without calls
/// of advance().
double ns_a_frame(const std::vector<SyntheticTrial> &trials,
		const std::function<GestureRecogniser(const Task &)> &recogniser_of, int outputs) {
	double ns = 0.0;
	std::size_t frames = 0;
	for (const SyntheticTrial &trial : trials) {
		GestureRecogniser recogniser = recogniser_of(task_of(trial));
		ns += ns_of([&] {
			int ms = 0;
			for (const HandFrame &frame : trial.measured.frames) {
				for (; outputs >= 0 && ms < frame.t_s * 1e3; ++ms) {
					recogniser.advance(1e-3 * ms);
					for (int i = 0; i < outputs; ++i) {
						keep(recogniser.motion(MotionSource::SYNTHESISED));
					}
				}
				recogniser.push(frame);
			}
		});
		frames += trial.measured.frames.size();
	}
	return ns / static_cast<double>(frames);
}

/// Time for a frame, with all models at the trial's task, or without a task.
double ns_a_frame(const std::vector<SyntheticTrial> &trials, const Models &models, bool has_task,
		MotionMode mode, int outputs = 0, Quality quality = DEFAULT_QUALITY) {
	return ns_a_frame(
			trials,
			[&](const Task &task) {
				return test::recogniser_of(models, has_task ? std::optional(task) : std::nullopt,
						{ mode, hypotheses_of(quality) });
			},
			outputs);
}

/// Time for a frame of a tap at one of 30 keys in five rows.
double ns_a_frame_of_keys(const SyntheticTrial &tap, const Models &models, double apart_m) {
	return ns_a_frame(
			{ tap },
			[&](const Task &task) {
				const Eigen::Vector3d across = task.axis.unitOrthogonal(), down = task.axis.cross(across);
				std::vector<ExpectedGesture> keys;
				for (int column = -3; column < 3; ++column) {
					for (int row = -2; row <= 2; ++row) {
						Task key = task;
						key.start_m += apart_m * (column * across + row * down);
						keys.push_back({ models[2], key });
					}
				}
				return GestureRecogniser(std::move(keys));
			},
			-1);
}

/// Time for one output: difference of runs with and without outputs, divided by the number of outputs.
double ns_an_output(const std::vector<SyntheticTrial> &trials, const Models &models, MotionMode mode) {
	constexpr int OUTPUTS = 4;
	double frames_a_ms = 0.0, seconds = 0.0;
	for (const SyntheticTrial &trial : trials) {
		frames_a_ms += static_cast<double>(trial.measured.frames.size());
		seconds += trial.measured.frames.back().t_s - trial.measured.frames.front().t_s;
	}
	frames_a_ms /= 1e3 * seconds;
	const double with = ns_a_frame(trials, models, true, mode, OUTPUTS),
				 without = ns_a_frame(trials, models, true, mode, 0);
	return (with - without) * frames_a_ms / OUTPUTS;
}

/// One trial of each gesture, by one subject, at the unstable position.
std::vector<SyntheticTrial> make_trials() {
	std::vector<SyntheticTrial> trials;
	for (const std::string gesture : GESTURES) {
		SyntheticSetOptions options;
		options.subjects = options.repetitions = 1;
		options.gestures = { gesture };
		options.positions = { HandPosition::UNSTABLE };
		trials.push_back(make_synthetic_trial(plan_synthetic_set(options).front()).value());
	}
	return trials;
}

std::vector<Row> motion_rows(const Models &models, const std::vector<SyntheticTrial> &trials) {
	std::vector<Row> rows;
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		const std::string mode_name = mode == MotionMode::PHASE ? "phase" : "paper";
		for (const bool has_task : { true, false }) {
			for (const int count : { 0, 1, 2, 4 }) {
				const Models active(models.begin(), models.begin() + count);
				rows.push_back(
						{ "frame, " + mode_name + (has_task ? ", with a task, " : ", without a task, ") +
										std::to_string(count) + " of 4 gestures",
								[&trials, active, has_task, mode] {
									return ns_a_frame(trials, active, has_task, mode, -1);
								},
								count == 4 ? 5000.0 : 0.0 });
			}
		}
		for (const auto &[name, quality] :
				{ std::pair{ "fast", Quality::FAST }, std::pair{ "accurate", Quality::ACCURATE } }) {
			for (const bool has_task : { true, false }) {
				if (mode == MotionMode::PHASE) {
					rows.push_back({ std::string("frame, ") + name +
									(has_task ? ", with a task" : ", without a task") + ", 4 of 4 gestures",
							[&trials, &models, has_task, mode, quality = quality] {
								return ns_a_frame(trials, models, has_task, mode, -1, quality);
							},
							5000.0 });
				}
			}
		}
		for (const double apart_m : { 0.04, 0.3 }) {
			if (mode == MotionMode::PHASE) {
				rows.push_back({ "frame, phase, with a task, 30 taps " +
								std::string(apart_m < 0.1 ? "4" : "30") + " cm apart",
						[&trials, &models, apart_m] {
							return ns_a_frame_of_keys(trials[2], models, apart_m);
						} });
			}
		}
		rows.push_back({ "motion(t) at 1 kHz, " + mode_name,
				[&trials, &models, mode] { return ns_an_output(trials, { models.front() }, mode); }, 0.0,
				true });
	}
	return rows;
}

} // namespace

int main(int count, char **arguments) {
	const Models models = read_models(count > 1 ? arguments[1] : "models");
	if (models.empty()) {
		return 1;
	}
	std::mt19937_64 random(1);
	std::vector<std::vector<SymbolSequence>> training(GESTURES.size());
	for (std::vector<SymbolSequence> &sequences : training) {
		for (int i = 0; i < SEQUENCES; ++i) {
			sequences.push_back(random_sequence(random, SEQUENCE_LENGTH));
		}
	}
	const DiscreteHmm hmm = left_right_from_equal_segments(training[0], STATES, SYMBOLS, {});

	std::vector<Row> rows{
		{ "plain scaled forward pass, a symbol",
				[&] { return ns_a_symbol(ScaledForward(hmm), training[0]); } },
		{ "HMM, a symbol and gesture: OnlineViterbi",
				[&] { return ns_a_symbol(OnlineViterbi(hmm), training[0]); }, 10.0 },
		{ "HMM, a symbol and gesture: ForwardFilter",
				[&] { return ns_a_symbol(ForwardFilter(hmm), training[0]); }, 10.0 },
		{ "the same in float: OnlineViterbi",
				[&] { return ns_a_symbol(OnlineViterbi<float>(hmm), training[0]); } },
		{ "the same in float: ForwardFilter",
				[&] { return ns_a_symbol(ForwardFilter<float>(hmm), training[0]); } },
		{ "FixedLagViterbi, lag 3", [&] { return ns_a_symbol(FixedLagViterbi(hmm, 3), training[0]); } },
		{ "FixedLagViterbi, lag 8", [&] { return ns_a_symbol(FixedLagViterbi(hmm, 8), training[0]); } },
		{ "Baum-Welch, an iteration of 4 x 500 x 75 symbols", [&] { return ns_an_iteration(training); },
				3e6 },
	};
	const std::vector<SyntheticTrial> trials = make_trials();
	for (Row &row : motion_rows(models, trials)) {
		rows.push_back(std::move(row));
	}
	std::vector<std::vector<double>> ns(rows.size());
	for (int round = 0; round < ROUNDS; ++round) {
		for (std::size_t i = 0; i < rows.size(); ++i) {
			ns[i].push_back(rows[i].measure());
		}
	}
	const double reference_ns = least(ns[0]);
	std::printf("least of %d rounds  %34s %14s %12s\n", ROUNDS, "ns", "x forward", "target, ns");
	for (std::size_t i = 0; i < rows.size(); ++i) {
		const double row_ns = rows[i].is_difference ? median(ns[i]) : least(ns[i]);
		std::printf("  %-46s %12.1f %14.1f", rows[i].name.c_str(), row_ns, row_ns / reference_ns);
		rows[i].target_ns > 0.0 ? std::printf(" %12.0f\n", rows[i].target_ns) : std::printf("\n");
	}
	return 0;
}
