extends RefCounted
## What a GestureTask looks like, as pairs of points in its own space.

const CIRCLE_POINTS := 48
## Shares of the amplitude.
const HEAD_LENGTH := 0.15
const HEAD_WIDTH := 0.06


static func lines(task: GestureTask) -> PackedVector3Array:
	if task.start_radius > 0.0:
		var points := _circle(task.start_radius)
		points.append_array(_circle(task.start_radius + task.amplitude))
		return points
	return _arrow(task)


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
