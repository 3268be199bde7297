extends RefCounted
## What has come of a trial. Instants on the tracker's clock, s; NAN until they come.

## Its first gesture has begun.
var start_s := NAN
## The task is done.
var end_s := NAN
## The gesture has ended, the last one where a task takes several.
var gesture_end_s := NAN
## How far the task had come at `gesture_end_s`, m; NAN until then.
var end_value_m := NAN

var _strokes_add_up: bool


## `strokes_add_up`: a task takes several gestures.
func _init(strokes_add_up: bool) -> void:
	_strokes_add_up = strokes_add_up


## Whether a gesture's end is this task's: that of its first, and where it takes several, of each up
## to the one that ends with the task done.
func takes_end() -> bool:
	var is_first := is_nan(gesture_end_s)
	# False as well where one of the two has not come.
	var is_done := gesture_end_s >= end_s
	return not is_nan(start_s) and (is_first or (_strokes_add_up and not is_done))


## Whether the next gesture of a live hand is another trial's.
func is_trial_done() -> bool:
	return not is_nan(end_s if _strokes_add_up else start_s)
