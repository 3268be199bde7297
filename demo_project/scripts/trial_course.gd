extends RefCounted
## Events of a trial. Times on the tracker's clock, s. NAN: not yet.

## Start of the first gesture.
var start_s := NAN
## End of the task.
var end_s := NAN
## End of the gesture; of the last one if a task takes several.
var gesture_end_s := NAN
## Progress of the task at `gesture_end_s`, m. NAN: not yet.
var end_value_m := NAN

var _strokes_add_up: bool


## `strokes_add_up`: a task takes several gestures.
func _init(strokes_add_up: bool) -> void:
	_strokes_add_up = strokes_add_up


## Whether a gesture's end counts for this task: only the first one, or, if the task takes several,
## each one until the task is done.
func takes_end() -> bool:
	var is_first := is_nan(gesture_end_s)
	# Also false if one of the two is NAN.
	var is_done := gesture_end_s >= end_s
	return not is_nan(start_s) and (is_first or (_strokes_add_up and not is_done))


## Whether the next gesture of a live hand belongs to another trial.
func is_trial_done() -> bool:
	return not is_nan(end_s if _strokes_add_up else start_s)
