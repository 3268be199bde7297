extends RefCounted
## A row of a trial set as the GestureTask of a scene.


## `trial`: of TrialSet.get_trial() or SyntheticSource.get_trial(). A trial without an axis is
## a radius (zoom): it has no place, and the task's stays.
static func apply(trial: Dictionary, task: GestureTask) -> void:
	var axis: Vector3 = trial["axis"]
	var start: Vector3 = trial["start"]
	var is_radius := axis.is_zero_approx()
	task.gesture = trial["gesture"]
	task.amplitude = trial["amplitude_m"]
	task.start_radius = start.x if is_radius else 0.0
	if not is_radius:
		task.global_position = start
		task.direction = task.global_basis.inverse() * axis


## Puts the task where its middle, or that of its radius, is at `middle` (m).
static func place_middle(task: GestureTask, middle: Vector3) -> void:
	var is_radius := task.start_radius > 0.0
	task.global_position = middle if is_radius else middle - 0.5 * task.amplitude * task.get_axis()
