// Events of gestures for simulated hands and trackers, independent of the core's simulation. Prints the runs
// without a fault (each gesture starts and ends once, and there is no other event), and false alarms per
// minute of hands that make no gesture.
//
//     bench_events [MODELS [RUNS [MIN_CONFIDENCE]]]
//     bench_events MODELS show HAND TRACKER CONTEXT RUN
//
// MODELS: folder of the models (default: models). RUNS: runs of each hand, tracker and context (default: 40).
// MIN_CONFIDENCE: default 0. `show` prints the expected and the actual events of one run; HAND, TRACKER and
// CONTEXT are names or prefixes of names.

#include "events/gesturing_hands.h"
#include "events/idle_hands.h"
#include "events/run.h"
#include "models.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

struct NamedContext {
	const char *name;
	Context context;
};
constexpr std::array CONTEXTS{ NamedContext{ "with a task", Context::WITH_TASK },
	NamedContext{ "without a task", Context::WITHOUT_TASK } };

struct Setting {
	const Models &models;
	std::uint64_t runs;
	double min_confidence;
};

/// Runs without a fault, %.
double percent_correct(const Setting &setting, const HandKind &kind, TrackerKind tracker, Context context) {
	std::uint64_t right = 0;
	for (std::uint64_t seed = 0; seed < setting.runs; ++seed) {
		const Run one = run(setting.models, kind, tracker, context, seed, setting.min_confidence);
		right += one.faults.empty() ? 1 : 0;
	}
	return 100.0 * static_cast<double>(right) / static_cast<double>(setting.runs);
}

struct Rates {
	double ended = 0.0, started = 0.0; ///< gestures per minute
};

Rates rates(const Setting &setting, const HandKind &kind, TrackerKind tracker, Context context) {
	Rates counts;
	double minutes = 0.0;
	for (std::uint64_t seed = 0; seed < setting.runs; ++seed) {
		const Run one = run(setting.models, kind, tracker, context, seed, setting.min_confidence);
		counts.ended +=
				static_cast<double>(std::ranges::count(one.events, EventKind::ENDED, &GestureEvent::kind));
		counts.started +=
				static_cast<double>(std::ranges::count(one.events, EventKind::STARTED, &GestureEvent::kind));
		minutes += one.hand.now_s() / 60.0;
	}
	return { counts.ended / minutes, counts.started / minutes };
}

/// A row for each hand, with a cell for each tracker, first with a task, then without.
template <class Measure> void print_table(std::span<const HandKind> hands, int decimals, Measure measure) {
	std::printf("| hand | with a task: 0.1 mm | 1 mm | bad | without a task: 0.1 mm | 1 mm | bad |\n"
				"| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
	for (const HandKind &hand : hands) {
		std::printf("| %s |", hand.name);
		for (const NamedContext &context : CONTEXTS) {
			for (const NamedTracker &tracker : TRACKERS) {
				std::printf(" %.*f |", decimals, measure(hand, tracker.kind, context.context));
			}
		}
		std::printf("\n");
		std::fflush(stdout);
	}
}

/// The first entry whose name begins so. Without one: nullopt, and an error on stderr.
template <class Named>
std::optional<Named> find_named(std::span<const Named> all, const char *what, std::string_view beginning) {
	for (const Named &one : all) {
		if (std::string_view(one.name).starts_with(beginning)) {
			return one;
		}
	}
	std::fprintf(stderr, "bench_events: there is no %s '%s'\n", what, std::string(beginning).c_str());
	return std::nullopt;
}

/// A whole number of at least `least`. Otherwise nullopt, and an error on stderr.
std::optional<std::uint64_t> parse_count(std::string_view text, std::uint32_t least) {
	std::uint32_t count = 0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
	if (error != std::errc() || end != text.data() + text.size() || count < least) {
		std::fprintf(stderr, "bench_events: '%s' must be a whole number of at least %u\n",
				std::string(text).c_str(), least);
		return std::nullopt;
	}
	return count;
}

/// A number from 0 to 1. Otherwise nullopt, and an error on stderr.
std::optional<double> parse_probability(std::string_view text) {
	double probability = -1.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), probability);
	if (error != std::errc() || end != text.data() + text.size() || !(probability >= 0.0) ||
			probability > 1.0) {
		std::fprintf(stderr, "bench_events: MIN_CONFIDENCE must be 0..1, is %s\n", std::string(text).c_str());
		return std::nullopt;
	}
	return probability;
}

bool show(const Models &models, const std::array<std::string_view, 4> &names) {
	std::vector<HandKind> hands(GESTURING_HANDS.begin(), GESTURING_HANDS.end());
	hands.insert(hands.end(), IDLE_HANDS.begin(), IDLE_HANDS.end());
	const auto kind = find_named(std::span<const HandKind>(hands), "hand", names[0]);
	const auto tracker = find_named(std::span<const NamedTracker>(TRACKERS), "tracker", names[1]);
	const auto context = find_named(std::span<const NamedContext>(CONTEXTS), "context", names[2]);
	const std::optional<std::uint64_t> seed = parse_count(names[3], 0);
	if (!kind || !tracker || !context || !seed) {
		return false;
	}
	constexpr std::array EVENT_NAMES{ "started", "ended", "aborted" };
	const Run one = run(models, *kind, tracker->kind, context->context, *seed);
	const auto name_of = [&one](int gesture) {
		return one.hand.gestures()[static_cast<std::size_t>(gesture)].model->gesture.c_str();
	};
	for (const Expected &expected : one.hand.expected()) {
		std::printf("%s %d %s from %.3f to %.3f s\n", expected.leeway.is_optional ? "optional" : "expected",
				expected.gesture, name_of(expected.gesture), expected.from_s, expected.to_s);
	}
	for (const GestureEvent &event : one.events) {
		std::printf("%8.3f s %s %d %s\n", event.t_s, EVENT_NAMES[static_cast<std::size_t>(event.kind)],
				event.gesture, name_of(event.gesture));
	}
	for (const std::string &fault : one.faults) {
		std::printf("fault: %s\n", fault.c_str());
	}
	return true;
}

} // namespace

int main(int count, char **arguments) {
	const Models models = read_models(count > 1 ? arguments[1] : "models");
	if (models.empty()) {
		return 1;
	}
	if (count == 7 && std::string_view(arguments[2]) == "show") {
		return show(models, { arguments[3], arguments[4], arguments[5], arguments[6] }) ? 0 : 1;
	}
	const std::optional<std::uint64_t> runs = parse_count(count > 2 ? arguments[2] : "40", 1);
	if (!runs) {
		return 1;
	}
	const std::optional<double> min_confidence = parse_probability(count > 3 ? arguments[3] : "0");
	if (!min_confidence) {
		return 1;
	}
	const Setting setting{ models, *runs, *min_confidence };
	std::printf("Runs without a fault, %% of %d:\n\n", static_cast<int>(*runs));
	print_table(GESTURING_HANDS, 0, [&](const HandKind &hand, TrackerKind tracker, Context context) {
		return percent_correct(setting, hand, tracker, context);
	});
	std::vector<Rates> idle;
	std::printf("\nFalse alarms per minute (gestures that end):\n\n");
	print_table(IDLE_HANDS, 2, [&](const HandKind &hand, TrackerKind tracker, Context context) {
		return idle.emplace_back(rates(setting, hand, tracker, context)).ended;
	});
	auto cell = idle.begin();
	std::printf("\nStarts per minute (gestures that end or are aborted):\n\n");
	print_table(IDLE_HANDS, 1, [&](auto...) { return (cell++)->started; });
	return 0;
}
