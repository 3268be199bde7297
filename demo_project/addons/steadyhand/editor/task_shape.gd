extends RefCounted
## The lines of a GestureTask, as pairs of points in its own space.

const CIRCLE_POINTS := 48
## Shares of the amplitude.
const HEAD_LENGTH := 0.15
const HEAD_WIDTH := 0.06
## A gesture begins at most this far from the start: see GestureTask.
const START_REACH := 0.6


static func lines(task: GestureTask) -> PackedVector3Array:
	if task.start_radius > 0.0:
		var points := _circle(task.start_radius)
		points.append_array(_circle(task.start_radius + task.amplitude))
		return points
	return _arrow(task)


## Around the start, along the axis. Empty for a radius, which has no place.
static func start_cylinder(task: GestureTask) -> PackedVector3Array:
	var basis := task.global_basis if task.is_inside_tree() else task.basis
	var points := PackedVector3Array()
	if task.start_radius > 0.0 or is_zero_approx(basis.determinant()):
		return points
	var reach := START_REACH * task.amplitude
	var axis := task.get_axis()
	var turn := Basis(Quaternion(Vector3.BACK, axis))
	var to_own := basis.inverse() * turn
	var circle := _circle(reach)
	for side: float in [-1.0, 1.0]:
		for point in circle:
			points.append(to_own * (point + side * reach * Vector3.BACK))
	for i in 4:
		var edge := reach * Vector3.RIGHT.rotated(Vector3.BACK, 0.5 * PI * i)
		points.append(to_own * (edge - reach * Vector3.BACK))
		points.append(to_own * (edge + reach * Vector3.BACK))
	return points


## Its length is the amplitude in the world, whatever the node's scale.
static func _arrow(task: GestureTask) -> PackedVector3Array:
	var basis := task.global_basis if task.is_inside_tree() else task.basis
	if is_zero_approx(basis.determinant()):
		return PackedVector3Array()
	var to_own := basis.inverse()
	var way := task.get_axis() * task.amplitude
	var side := way.cross(Vector3.UP if absf(way.normalized().y) < 0.9 else Vector3.RIGHT)
	var points := PackedVector3Array([Vector3.ZERO, to_own * way])
	for turn in 4:
		var barb := side.normalized().rotated(way.normalized(), 0.5 * PI * turn)
		var foot := way * (1.0 - HEAD_LENGTH) + barb * HEAD_WIDTH * task.amplitude
		points.append_array([to_own * way, to_own * foot])
	return points


static func _circle(radius: float) -> PackedVector3Array:
	var points := PackedVector3Array()
	for i in CIRCLE_POINTS:
		for end in 2:
			var angle := TAU * (i + end) / CIRCLE_POINTS
			points.append(radius * Vector3(cos(angle), sin(angle), 0.0))
	return points
