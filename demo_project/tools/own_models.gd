extends RefCounted
## The models of the add-on, trained on synthetic people: equal bits on every run.

## Gestures, and the size of the training set.
const GESTURES: PackedStringArray = ["horizontal_drag", "vertical_drag", "tap", "zoom"]
const CLASSIFIER := "gestures.classifier"
const SUBJECTS := 12
const TRIALS_PER_SUBJECT := 6
## As in the paper, subjects move at three speeds: their own, fast, very fast.
const PACES: PackedFloat64Array = [1.0, 0.6, 0.4]


## Null, and one error in the log, if a file cannot be written.
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
