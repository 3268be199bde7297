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
	if plan.get("format") != FORMAT or plan.get("version") != VERSION:
		return {}
	for trial: Dictionary in plan["trials"]:
		for key: String in ["trial", "block", "repetition"]:
			trial[key] = int(trial[key])
	for entry: Dictionary in plan["questionnaires"]:
		entry["after_trial"] = int(entry["after_trial"])
	return plan


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
