#include "trial_set.h"

#include "conversions.h"
#include "text_file.h"
#include "track_file.h"
#include "trial_dictionary.h"

#include "simulation/synthetic_trial.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace godot {

namespace {

struct SyntheticOption {
	std::string_view name, is_a;
};

constexpr std::array<SyntheticOption, 7> SYNTHETIC_OPTIONS{ {
		{ "population", "name" },
		{ "subjects", "number" },
		{ "trials_per_subject", "number" },
		{ "gestures", "list" },
		{ "paces", "list" },
		{ "duration", "number" },
		{ "earlier_rounds", "number" },
} };

/// Why an option is invalid; empty if it is valid.
std::string fault_of(const std::string &p_key, const Variant &p_value) {
	const auto option = std::find_if(SYNTHETIC_OPTIONS.begin(), SYNTHETIC_OPTIONS.end(),
			[&](const SyntheticOption &candidate) { return candidate.name == p_key; });
	if (option == SYNTHETIC_OPTIONS.end()) {
		return "there is no option '" + p_key + "'";
	}
	const Variant::Type type = p_value.get_type();
	const bool is_number = type == Variant::INT || type == Variant::FLOAT;
	const bool is_list = type >= Variant::ARRAY; // the packed arrays follow it
	if ((option->is_a == "number" && !is_number) || (option->is_a == "list" && !is_list)) {
		return p_key + ": '" + to_core(p_value.stringify()) + "' is not a " + std::string(option->is_a);
	}
	return {};
}

/// Limit of a trial with its earlier rounds, s. Its two tracks then take 250 MB.
constexpr double LONGEST_S = 3600.0;
/// Each has two files. Their plan takes 30 MB.
constexpr double MOST_TRIALS = 100'000.0;

/// Why the trials would not fit into memory; empty if they do.
std::string size_fault(const steadyhand::SyntheticSetOptions &p_options) {
	const std::size_t gestures = std::max<std::size_t>(p_options.gestures.size(), 1);
	const double trials = static_cast<double>(p_options.subjects) * p_options.repetitions *
			static_cast<double>(gestures * p_options.positions.size());
	if (trials > MOST_TRIALS) {
		return "subjects, trials_per_subject and gestures: more than 100000 trials; write several sets";
	}
	if (p_options.duration_s * (1.0 + p_options.earlier_rounds) > LONGEST_S) {
		return "duration and earlier_rounds: a trial would last longer than 3600 s";
	}
	return {};
}

/// Error names the option and its value.
steadyhand::Result<steadyhand::SyntheticSetOptions> read_options(const Dictionary &p_options) {
	using steadyhand::Population;
	steadyhand::SyntheticSetOptions options;
	const Array given = p_options.keys();
	for (int64_t i = 0; i < given.size(); ++i) {
		const std::string fault = fault_of(to_core(String(given[i])), p_options.get(given[i], Variant()));
		if (!fault.empty()) {
			return steadyhand::Error{ fault };
		}
	}
	const String population = p_options.get("population", "train");
	std::optional<Population> known;
	for (const Population candidate : { Population::TRAIN, Population::TUNE, Population::EVALUATE }) {
		if (population == to_godot(steadyhand::population_name(candidate))) {
			known = candidate;
		}
	}
	if (!known) {
		return steadyhand::Error{ "population '" + to_core(population) + "' is not train, tune or evaluate" };
	}
	options.population = *known;
	for (const auto &[key, count] : { std::pair("subjects", &options.subjects),
				 std::pair("trials_per_subject", &options.repetitions) }) {
		const int64_t asked = p_options.get(key, *count);
		if (asked < 1 || asked > 10000) {
			return steadyhand::Error{ std::string(key) + ": " + std::to_string(asked) +
				" is not in 1..10000" };
		}
		*count = static_cast<std::uint32_t>(asked);
	}
	options.duration_s = p_options.get("duration", 0.0);
	if (!(options.duration_s >= 0.0) || options.duration_s > LONGEST_S) {
		return steadyhand::Error{ "duration: " + std::to_string(options.duration_s) +
			" s is not in 0..3600" };
	}
	const int64_t earlier_rounds = p_options.get("earlier_rounds", 0);
	if (earlier_rounds < 0 || earlier_rounds > 100) {
		return steadyhand::Error{ "earlier_rounds: " + std::to_string(earlier_rounds) + " is not in 0..100" };
	}
	options.earlier_rounds = static_cast<std::uint32_t>(earlier_rounds);
	const PackedFloat64Array paces = p_options.get("paces", PackedFloat64Array());
	if (!paces.is_empty()) {
		options.paces.assign(paces.ptr(), paces.ptr() + paces.size());
	}
	for (const double pace : options.paces) {
		if (std::isnan(pace) || pace < 0.1 || pace > 10.0) {
			return steadyhand::Error{ "paces: " + std::to_string(pace) + " is not in 0.1..10" };
		}
	}
	const PackedStringArray gestures = p_options.get("gestures", PackedStringArray());
	for (const String &gesture : gestures) {
		options.gestures.push_back(to_core(gesture));
	}
	if (std::string fault = size_fault(options); !fault.empty()) {
		return steadyhand::Error{ std::move(fault) };
	}
	return options;
}

} // namespace

String TrialSet::track_path(const String &p_folder, const steadyhand::Trial &p_trial, const char *p_kind) {
	return p_folder.path_join(to_godot(p_trial.trial) + String(p_kind));
}

steadyhand::Result<steadyhand::TrainingRecording> TrialSet::read_recording(
		const steadyhand::Trial &p_trial) const {
	steadyhand::Result<steadyhand::Track> measured =
			read_track_file(track_path(path_, p_trial, ".measured.csv"));
	if (!measured) {
		return steadyhand::Error{ measured.error() };
	}
	steadyhand::Result<steadyhand::Track> reference =
			read_track_file(track_path(path_, p_trial, ".reference.csv"));
	if (!reference) {
		return steadyhand::Error{ reference.error() };
	}
	return steadyhand::TrainingRecording{ p_trial.trial, task_of_trial(p_trial), p_trial.start_s,
		p_trial.end_s, std::move(measured).value(), std::move(reference).value() };
}

Dictionary TrialSet::get_trial(int p_index) const {
	ERR_FAIL_INDEX_V(p_index, get_count(), Dictionary());
	return trial_dictionary(trials_[static_cast<std::size_t>(p_index)]);
}

String TrialSet::get_measured_path(int p_index) const {
	ERR_FAIL_INDEX_V(p_index, get_count(), String());
	return track_path(path_, trials_[static_cast<std::size_t>(p_index)], ".measured.csv");
}

String TrialSet::get_reference_path(int p_index) const {
	ERR_FAIL_INDEX_V(p_index, get_count(), String());
	return track_path(path_, trials_[static_cast<std::size_t>(p_index)], ".reference.csv");
}

Ref<TrialSet> TrialSet::load_folder(const String &p_path) {
	const String table = p_path.path_join("trials.csv");
	const steadyhand::Result<std::string> text = read_text_file(table);
	ERR_FAIL_COND_V_MSG(!text, Ref<TrialSet>(), to_godot(text.error()));
	steadyhand::Result<steadyhand::TrialTable> rows =
			steadyhand::parse_trials_csv(text.value(), to_core(table));
	ERR_FAIL_COND_V_MSG(!rows, Ref<TrialSet>(), to_godot(rows.error()));
	for (const std::string &fault : rows.value().faults) {
		ERR_PRINT(to_godot(fault + "; the trial is left out"));
	}
	Ref<TrialSet> set;
	set.instantiate();
	set->path_ = p_path;
	set->left_out_ = static_cast<int>(rows.value().faults.size());
	set->trials_ = std::move(rows).value().trials;
	return set;
}

Error TrialSet::write_synthetic(const String &p_path, const Dictionary &p_options) {
	const steadyhand::Result<steadyhand::SyntheticSetOptions> options = read_options(p_options);
	ERR_FAIL_COND_V_MSG(!options, ERR_INVALID_PARAMETER,
			String("TrialSet.write_synthetic: ") + to_godot(options.error()));
	const Error folder_error = DirAccess::make_dir_recursive_absolute(p_path);
	ERR_FAIL_COND_V_MSG(folder_error != OK, folder_error,
			p_path + String(": this folder cannot be made. Choose a folder that you may write to"));
	std::vector<steadyhand::Trial> rows;
	for (const steadyhand::SyntheticTrialRequest &request : steadyhand::plan_synthetic_set(options.value())) {
		const steadyhand::Result<steadyhand::SyntheticTrial> made = steadyhand::make_synthetic_trial(request);
		ERR_FAIL_COND_V_MSG(!made, ERR_INVALID_PARAMETER, to_godot(made.error()));
		const steadyhand::SyntheticTrial &trial = made.value();
		for (const auto &[kind, track] : { std::pair(".measured.csv", &trial.measured),
					 std::pair(".reference.csv", &trial.reference) }) {
			const Error error = write_text_file(
					track_path(p_path, trial.trial, kind), steadyhand::format_track_csv(*track));
			if (error != OK) {
				return error;
			}
		}
		rows.push_back(trial.trial);
	}
	return write_text_file(p_path.path_join("trials.csv"), steadyhand::format_trials_csv(rows));
}

void TrialSet::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_path"), &TrialSet::get_path);
	ClassDB::bind_method(D_METHOD("get_count"), &TrialSet::get_count);
	ClassDB::bind_method(D_METHOD("get_left_out_count"), &TrialSet::get_left_out_count);
	ClassDB::bind_method(D_METHOD("get_trial", "index"), &TrialSet::get_trial);
	ClassDB::bind_method(D_METHOD("get_measured_path", "index"), &TrialSet::get_measured_path);
	ClassDB::bind_method(D_METHOD("get_reference_path", "index"), &TrialSet::get_reference_path);
	ClassDB::bind_static_method("TrialSet", D_METHOD("load_folder", "path"), &TrialSet::load_folder);
	ClassDB::bind_static_method("TrialSet", D_METHOD("write_synthetic", "path", "options"),
			&TrialSet::write_synthetic, DEFVAL(Dictionary()));
}

} // namespace godot
