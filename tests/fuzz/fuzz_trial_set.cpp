// Any bytes are a table of trials or one error; trials that were read and written read back as themselves.

#include "require.h"
#include "tracking/frame.h"
#include "tracking/trial_set.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

using namespace steadyhand;
using steadyhand::fuzz::require;

namespace {

constexpr std::string_view SOURCE = "trials.csv:";

void check_trial(const Trial &trial) {
	require(file_name_fault(trial.trial).empty(), "a trial's name is fit for a file");
	require(file_name_fault(trial.gesture).empty(), "a gesture's name is fit for a file");
	require(std::abs(trial.start_s) <= FARTHEST_S && std::abs(trial.end_s) <= FARTHEST_S,
			"times are finite and in range");
	require(trial.start_s <= trial.end_s, "a trial does not end before its start");
	require(is_place(trial.start_m), "the start is a place");
	require(trial.amplitude_m >= 0.0 && trial.amplitude_m <= FARTHEST_M, "the amplitude is in range");
	require(!trial.has_axis() || std::abs(trial.axis.norm() - 1.0) < 2e-5, "an axis is a unit vector");
}

bool is_same(const Trial &left, const Trial &right) {
	return left.trial == right.trial && left.gesture == right.gesture && left.position == right.position &&
			left.subject == right.subject && left.start_s == right.start_s && left.end_s == right.end_s &&
			left.start_m == right.start_m && left.axis == right.axis && left.amplitude_m == right.amplitude_m;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
	const std::string_view text(reinterpret_cast<const char *>(data), size);
	const Result<TrialTable> read = parse_trials_csv(text, "trials.csv");
	if (!read) {
		require(read.error().starts_with(SOURCE), "an error names the source");
		return 0;
	}
	for (const std::string &fault : read.value().faults) {
		require(fault.starts_with(SOURCE), "a fault names the source");
	}
	std::set<std::string> names;
	for (const Trial &trial : read.value().trials) {
		check_trial(trial);
		require(names.insert(trial.trial).second, "a trial's name comes once");
	}
	const Result<TrialTable> again = parse_trials_csv(format_trials_csv(read.value().trials), "trials.csv");
	require(again.ok() && again.value().faults.empty(), "what is written can be read");
	require(again.value().trials.size() == read.value().trials.size(), "all trials read back");
	for (std::size_t i = 0; i < read.value().trials.size(); ++i) {
		require(is_same(read.value().trials[i], again.value().trials[i]), "a trial reads back");
	}
	return 0;
}
