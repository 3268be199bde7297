extends RefCounted
## session.json: plan, settings and machine. See docs/study_files.md.

const StudyPlan := preload("study_plan.gd")
const WholeFile := preload("whole_file.gd")

const FORMAT := "steadyhand-session"
const VERSION := 1


static func make(
	protocol: StudyProtocol,
	participant_id: String,
	number: int,
	origin: String,
	settings: Dictionary
) -> Dictionary:
	var trials := StudyPlan.make(protocol, participant_id)
	return {
		format = FORMAT,
		version = VERSION,
		study = protocol.study_name,
		participant = participant_id,
		session = number,
		origin = origin,
		seed = protocol.seed,
		protocol = protocol.to_dictionary(),
		trials = trials,
		questionnaires = StudyPlan.make_questionnaires(protocol, trials),
		settings = settings,
		versions =
		{
			steadyhand = GestureTrainer.get_version(),
			godot = Engine.get_version_info()["string"],
		},
		machine = _machine(),
		started = Time.get_datetime_string_from_system(),
	}


static func write(path: String, plan: Dictionary) -> Error:
	return WholeFile.write(path, JSON.stringify(plan, "\t") + "\n")


## Whole numbers are integers again. Empty: the file is no session.json.
static func read(path: String) -> Dictionary:
	var json := JSON.new()
	if json.parse(FileAccess.get_file_as_string(path)) != OK or not json.data is Dictionary:
		return {}
	var plan: Dictionary = json.data
	if plan.get("format") != FORMAT or plan.get("version") != VERSION or not _is_complete(plan):
		return {}
	for trial: Dictionary in plan["trials"]:
		for key: String in ["trial", "block", "repetition"]:
			trial[key] = int(trial[key])
	for entry: Dictionary in plan["questionnaires"]:
		entry["after_trial"] = int(entry["after_trial"])
	return plan


## Names of the properties that differ between `protocol`, as it was read, and `wanted`.
static func differences(protocol: Dictionary, wanted: StudyProtocol) -> PackedStringArray:
	var names := PackedStringArray()
	var as_read: Dictionary = JSON.parse_string(JSON.stringify(wanted.to_dictionary()))
	for name: String in as_read:
		if JSON.stringify(as_read[name]) != JSON.stringify(protocol.get(name)):
			names.append(name)
	return names


## Whether a study can run the plan: a person may have edited it.
static func _is_complete(plan: Dictionary) -> bool:
	var protocol: Variant = plan.get("protocol")
	var trials: Variant = plan.get("trials")
	var asked: Variant = plan.get("questionnaires")
	return (
		plan.get("origin") is String
		and protocol is Dictionary
		and protocol.get("trial_limit_s") is float
		and protocol.get("questionnaires") is Array
		and protocol["questionnaires"].all(_is_dictionary)
		and trials is Array
		and trials.all(_is_trial)
		and asked is Array
		and asked.all(_is_dictionary)
	)


static func _is_dictionary(value: Variant) -> bool:
	return value is Dictionary


static func _is_trial(value: Variant) -> bool:
	if not value is Dictionary:
		return false
	var trial: Dictionary = value
	var rest_s: Variant = trial.get("rest_before_s")
	return (
		trial.has_all(["trial", "block", "repetition", "practice", "amplitude_m", "width_m"])
		and trial.get("gesture") in StudyProtocol.Tasks.SCENES
		and trial.get("position") in StudyProtocol.POSITIONS
		and trial.get("condition") in StudyProtocol.Conditions.NAMES
		and rest_s is float
		and rest_s >= 0.0
		and rest_s <= StudyProtocol.LONGEST_REST_S
	)


static func _machine() -> Dictionary:
	var xr := XRServer.primary_interface
	var screen_hz := DisplayServer.screen_get_refresh_rate()
	return {
		os = "%s %s" % [OS.get_name(), OS.get_version()],
		processor = OS.get_processor_name(),
		xr_runtime =
		"" if xr == null else str(xr.get_system_info().get("XRRuntimeName", xr.get_name())),
		screen_hz = screen_hz if screen_hz > 0.0 else null,
	}
