// Effect of each mechanism of `phase` mode: all measures without it, minus those with it. Prints
// docs/ablation.md:
//
//     bench_ablation [MODELS [RUNS [TRIALS...]]]
//
// MODELS: folder of the models (default: models). RUNS: runs of each hand of bench_events (default: 8).
// TRIALS: trial sets of real hands. Compiled with STEADYHAND_VARIABLE_PARAMETERS.

#include "ablation/measures.h"
#include "ablation/mechanisms.h"
#include "events/gesturing_hands.h"
#include "events/idle_hands.h"
#include "events/run.h"
#include "matrix/scenarios.h"
#include "metrics/summary.h"
#include "models.h"
#include "recogniser_of.h"
#include "shown_changes.h"
#include "trials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

class Measure {
public:
	Measure(Models models, std::uint64_t runs, std::vector<SyntheticTrial> simulated,
			std::vector<SyntheticTrial> real) :
			models_(std::move(models)),
			runs_(runs), simulated_(std::move(simulated)), real_(std::move(real)) {}

	struct Samples {
		std::array<Sample, 4> r2_zero;  ///< unstable: simulated, real; stable: simulated, real
		Sample bounds;                  ///< checks of bench_matrix outside of their bounds, %
		Sample with_task, without_task; ///< runs of bench_events with a fault, %
		Sample missed;                  ///< real trials whose gesture is not recognised without a task, %
		Sample starts, alarms;          ///< per minute of idle hands: starts with a task, ends without one
	};
	/// All measures. If `same_motion` is given, r2_zero and bounds are copied from it.
	[[nodiscard]] Samples all(const Samples *same_motion = nullptr) const {
		Samples all = same_motion != nullptr ? *same_motion : motion();
		all.with_task = percent_faulty(Context::WITH_TASK);
		all.without_task = percent_faulty(Context::WITHOUT_TASK);
		all.missed = percent_missed();
		all.starts = events_per_minute(Context::WITH_TASK, EventKind::STARTED);
		all.alarms = events_per_minute(Context::WITHOUT_TASK, EventKind::ENDED);
		return all;
	}

private:
	Models models_;
	std::uint64_t runs_;
	std::vector<SyntheticTrial> simulated_, real_;

	std::vector<matrix::Scenario> scenarios_ = matrix::Scenarios().all();

	[[nodiscard]] Samples motion() const {
		Samples all;
		const auto accuracy = [this](const std::vector<SyntheticTrial> &trials, HandPosition position) {
			return accuracy_of(models_, gestures_at(trials, position));
		};
		all.r2_zero = { accuracy(simulated_, HandPosition::UNSTABLE), accuracy(real_, HandPosition::UNSTABLE),
			accuracy(simulated_, HandPosition::STABLE), accuracy(real_, HandPosition::STABLE) };
		for (const Checks &checks : checks_of(models_, scenarios_)) {
			all.bounds.push_back(100.0 * checks.outside / std::max(checks.all, 1));
		}
		return all;
	}
	/// Real trials, with all models and without a task, in which the last gesture that ended is another one.
	[[nodiscard]] Sample percent_missed() const {
		const std::vector<const SyntheticTrial *> chosen = gestures_at(real_);
		return each(chosen.size(), [&](std::size_t i) {
			GestureRecogniser recogniser =
					test::recogniser_of(models_, std::nullopt, { .latency_s = USUAL_SENSOR_LATENCY_S });
			test::ShownChanges shown;
			std::string last;
			const auto look = [&] {
				last = shown.next(recogniser).ended ? recogniser.session()->model().gesture : last;
			};
			for (const HandFrame &frame : chosen[i]->measured.frames) {
				recogniser.push(frame);
				look();
			}
			// Recordings may stop at the movement's end: a scene sees a dropout there.
			recogniser.advance(recogniser.time_s() + 1.0);
			look();
			return last == chosen[i]->trial.gesture ? 0.0 : 100.0;
		});
	}
	[[nodiscard]] Run run_of(std::span<const HandKind> kinds, Context context, std::size_t i) const {
		const HandKind &kind = kinds[i / (runs_ * TRACKERS.size())];
		return run(models_, kind, TRACKERS[i / runs_ % TRACKERS.size()].kind, context, i % runs_);
	}
	[[nodiscard]] Sample percent_faulty(Context context) const {
		return each(GESTURING_HANDS.size() * TRACKERS.size() * runs_, [&](std::size_t i) {
			return run_of(GESTURING_HANDS, context, i).faults.empty() ? 0.0 : 100.0;
		});
	}
	[[nodiscard]] Sample events_per_minute(Context context, EventKind kind) const {
		return each(IDLE_HANDS.size() * TRACKERS.size() * runs_, [&](std::size_t i) {
			const Run one = run_of(IDLE_HANDS, context, i);
			return 60.0 / one.hand.now_s() *
					static_cast<double>(std::ranges::count(one.events, kind, &GestureEvent::kind));
		});
	}
};

/// A table cell: mean change and its standard error. Bold beyond two standard errors; empty without a change.
void print_change(const Sample &with, const Sample &without, int decimals) {
	if (with.empty() || with == without) {
		std::printf(" |");
		return;
	}
	Sample change(with.size());
	std::ranges::transform(without, with, change.begin(), std::minus());
	const double mean_change = mean(change), n = static_cast<double>(change.size());
	double squares = 0.0;
	for (const double one : change) {
		squares += (one - mean_change) * (one - mean_change);
	}
	const double error = std::sqrt(squares / (n * (n - 1.0)));
	const char *const bold = std::abs(mean_change) > 2.0 * error ? "**" : "";
	std::printf(" %s%+.*f%s ± %.*f |", bold, decimals, mean_change, bold, decimals, error);
}

const char *const HEAD = R"(# What each mechanism is worth

`./steadyhand bench ablation` writes this page. It sets the parameters of one mechanism at a time
(`extension/core/base/parameters.h`) so that the mechanism does nothing, and measures what changes. Mechanisms without
which nothing gets worse are candidates for removal.

| column | measure |
| --- | --- |
| simulated, real | zero-lag R2 with a task, at the unstable and the stable position. *real*: `../shared/real`, if it is there |
| outside bounds | checks of `bench_matrix` (closed-form hands x faults x lengths x rates) outside of their bounds, % |
| faults with a task, without | runs of `bench_events` with an event missing, wrong or too much, % |
| real, missed | trials of *real* hands whose gesture is not recognised without a task, % |
| needless starts | starts a minute of hands that make no gesture, with a task |
| false alarms | ends a minute of hands that make no gesture, without a task |

Each cell is the change and its standard error. Bold: beyond two standard errors. Empty: no change at all. Higher R2 is
better; for all other columns, lower is better.

)";

void print_head(const Measure::Samples &with) {
	std::printf("%s", HEAD);
	std::printf("| | simulated, unstable | real, unstable | simulated, stable | real, stable | outside "
				"bounds, %% | "
				"faults with a task, %% | without, %% | real, missed, %% | needless starts | false alarms |\n"
				"| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n| all "
				"mechanisms |");
	for (const Sample &r2_zero : with.r2_zero) {
		r2_zero.empty() ? std::printf(" - |") : std::printf(" %.4f |", mean(r2_zero));
	}
	std::printf(" %.2f | %.1f | %.1f |", mean(with.bounds), mean(with.with_task), mean(with.without_task));
	with.missed.empty() ? std::printf(" - |") : std::printf(" %.1f |", mean(with.missed));
	std::printf(" %.1f | %.2f |\n", mean(with.starts), mean(with.alarms));
}

} // namespace

int main(int count, char **arguments) {
	const Models models = read_models(count > 1 ? arguments[1] : "models");
	std::uint64_t runs = 8;
	if (count > 2) {
		const std::string_view text = arguments[2];
		if (std::from_chars(text.data(), text.data() + text.size(), runs).ec != std::errc() || runs == 0) {
			std::fprintf(stderr, "bench_ablation: RUNS must be a whole number of at least 1, is %s\n",
					arguments[2]);
			return 1;
		}
	}
	std::vector<SyntheticTrial> simulated = tuning_trials(12, 2, { 1.0, 0.6 }), real;
	for (int i = 3; i < count; ++i) {
		std::ranges::move(read_trials(arguments[i]), std::back_inserter(real));
	}
	if (models.empty() || simulated.empty()) {
		return 1;
	}
	const Measure measure(models, runs, std::move(simulated), std::move(real));
	const Measure::Samples with = measure.all();
	print_head(with);
	for (const Mechanism &mechanism : mechanisms()) {
		std::vector<double> kept;
		for (const auto &[parameter, off] : mechanism.off) {
			kept.push_back(std::exchange(*parameter, off));
		}
		const Measure::Samples without = measure.all(mechanism.is_of_events ? &with : nullptr);
		for (std::size_t i = 0; i < kept.size(); ++i) {
			*mechanism.off[i].first = kept[i];
		}
		std::printf("| %s |", mechanism.name);
		for (std::size_t i = 0; i < with.r2_zero.size(); ++i) {
			print_change(with.r2_zero[i], without.r2_zero[i], 4);
		}
		print_change(with.bounds, without.bounds, 2);
		print_change(with.with_task, without.with_task, 1);
		print_change(with.without_task, without.without_task, 1);
		print_change(with.missed, without.missed, 1);
		print_change(with.starts, without.starts, 1);
		print_change(with.alarms, without.alarms, 2);
		std::printf("\n");
		std::fflush(stdout);
	}
	return 0;
}
