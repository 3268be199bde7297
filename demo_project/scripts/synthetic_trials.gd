extends RefCounted
## Trials that synthetic people make at the task of a scene, one after another.

const TrialTask := preload("trial_task.gd")

## Trials of a synthetic person, at the stable and the unstable position in turns.
const TRIALS_PER_SUBJECT := 6
const POSITIONS: Array[SyntheticSource.Position] = [
	SyntheticSource.POSITION_STABLE, SyntheticSource.POSITION_UNSTABLE
]

var source := SyntheticSource.new()
## The present trial, as of SyntheticSource.get_trial(). Empty before the first.
var trial: Dictionary = {}

## The axis of the scene, along which the people make the gesture.
var _axis := Vector3.ZERO


func _init(task: GestureTask) -> void:
	_axis = task.get_axis()


## Goes to the next trial and places `task` for it.
func advance(task: GestureTask) -> void:
	source.gesture = task.gesture
	source.seed += 1
	source.subject = source.seed / TRIALS_PER_SUBJECT
	source.position = POSITIONS[source.seed % POSITIONS.size()]
	source.placement = SyntheticSource.PLACEMENT_SENSOR
	trial = source.get_trial()
	TrialTask.apply(trial, task)
	if task.start_radius <= 0.0 and not task.get_axis().is_equal_approx(_axis):
		var middle := task.get_start() + 0.5 * task.amplitude * task.get_axis()
		task.direction = task.global_basis.inverse() * _axis
		TrialTask.place_middle(task, middle)
		source.place_at(task)
		trial = source.get_trial()
	trial["trial"] = "synthetic_%03d" % source.seed
