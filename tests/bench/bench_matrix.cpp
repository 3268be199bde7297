// Accuracy of the motion core for hands in closed form: hands x faults x task lengths x frame rates. Prints
// each bound of tests/core/matrix/bounds.h with the number of scenarios outside of it, or a line of CSV for
// each scenario.
//
//     bench_matrix [--csv] [MODELS [LATENCY_S]]
//
// MODELS: folder of the models (default: models). LATENCY_S: latency for the estimator (default: 0; the
// simulated tracker has none).

#include "ablation/measures.h"
#include "matrix/bounds.h"
#include "matrix/measures.h"
#include "matrix/scenarios.h"
#include "models.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace steadyhand;
using namespace steadyhand::matrix;

void print_rows(const std::vector<Scenario> &scenarios, const std::vector<Measures> &measured) {
	std::printf("group,hand,gesture,length_m,rate,noise,fault,fault_share,seed,t_diff_s,missed,move_error,"
				"stop_error,value_step,value_jump,velocity_step,overshoot,r2_zero,r2_zero_raw,started,ended,"
				"aborted,ended_s,outside\n");
	for (std::size_t i = 0; i < scenarios.size(); ++i) {
		const Scenario &one = scenarios[i];
		const Measures &m = measured[i];
		const auto outside = std::ranges::count_if(BOUNDS, [&](const Bound &bound) {
			return applies(bound, one) && value_of(bound.metric, one, m) > bound.limit;
		});
		std::printf(
				"\"%s\",\"%s\",%s,%g,%s,%s,\"%s\",%g,%d,%.4f,%d,%.4f,%.4f,%.5f,%.6f,%.4f,%.3f,%.5f,%.5f,%d,"
				"%d,%d,%.3f,%d\n",
				one.group.c_str(), one.hand.name.c_str(), bench::name_of(one.gesture), one.task.amplitude_m,
				one.rate.name, one.noise.name, one.fault.name, one.fault_share, static_cast<int>(one.seed),
				m.t_diff_s, m.missed ? 1 : 0, m.move_error, m.stop_error, m.value_step, m.value_jump,
				m.velocity_step, m.overshoot, m.r2_zero, m.r2_zero_raw, m.started, m.ended, m.aborted,
				m.ended_s - one.hand.to_s, static_cast<int>(outside));
	}
}

void print_summary(const std::vector<Scenario> &scenarios, const std::vector<Measures> &measured) {
	std::printf("| group | measure | bound | median | worst | outside |\n"
				"| --- | --- | ---: | ---: | ---: | ---: |\n");
	for (const Bound &bound : BOUNDS) {
		std::vector<double> values;
		for (std::size_t i = 0; i < scenarios.size(); ++i) {
			if (applies(bound, scenarios[i])) {
				values.push_back(value_of(bound.metric, scenarios[i], measured[i]));
			}
		}
		if (values.empty()) {
			continue;
		}
		std::sort(values.begin(), values.end());
		const auto outside = std::ranges::count_if(values, [&](double value) { return value > bound.limit; });
		std::printf("| %s%s | %s | %g | %.4g | %.4g | %d of %d |\n", std::string(bound.group).c_str(),
				bound.standing == Standing::ASSERTED ? " (asserted)" : "", name_of(bound.metric), bound.limit,
				values[values.size() / 2], values.back(), static_cast<int>(outside),
				static_cast<int>(values.size()));
	}
}

} // namespace

int main(int count, char **arguments) {
	std::vector<std::string> given(arguments + 1, arguments + count);
	const bool is_csv = !given.empty() && given.front() == "--csv";
	given.erase(given.begin(), given.begin() + (is_csv ? 1 : 0));
	const bench::Models models = bench::read_models(given.empty() ? "models" : given[0]);
	if (models.empty()) {
		return 1;
	}
	double latency_s = 0.0;
	if (given.size() > 1) {
		const char *const end = given[1].data() + given[1].size();
		if (std::from_chars(given[1].data(), end, latency_s).ptr != end || !(latency_s >= 0.0)) {
			std::fprintf(
					stderr, "bench_matrix: LATENCY_S must be 0 or more seconds, is %s\n", given[1].c_str());
			return 1;
		}
	}
	const std::vector<Scenario> scenarios = Scenarios().all();
	std::vector<Measures> measured;
	measured.reserve(scenarios.size());
	for (const Scenario &scenario : scenarios) {
		measured.push_back(bench::measures_of(models, scenario, latency_s));
	}
	(is_csv ? print_rows : print_summary)(scenarios, measured);
	return 0;
}
