extends RefCounted
## The models that the add-on brings, from synthetic people: equal bits on every run.

## Of what, and how much it is trained on.
const GESTURES: PackedStringArray = ["horizontal_drag", "vertical_drag", "tap", "zoom"]
const CLASSIFIER := "gestures.classifier"
const SUBJECTS := 12
const TRIALS_PER_SUBJECT := 6
## As the paper's subjects, who were asked for different speeds: as they like, fast, very fast.
const PACES: PackedFloat64Array = [1.0, 0.6, 0.4]


## Null, and one error in the log, where a file cannot be written.
static func write_trials(folder: String) -> TrialSet:
	var options := {
		population = "train",
		gestures = GESTURES,
		subjects = SUBJECTS,
		trials_per_subject = TRIALS_PER_SUBJECT,
		paces = PACES,
	}
	if TrialSet.write_synthetic(folder, options) != OK:
		return null
	return TrialSet.load_folder(folder)
