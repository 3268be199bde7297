extends RefCounted
## The range of a HandTracker's device, as pairs of points in the node's own space. Frames are in
## world space, wherever the node is.

## Leap Motion Controller: an inverted pyramid, by Ultraleap's data sheet.
const LEAP_ANGLES := Vector2(deg_to_rad(150.0), deg_to_rad(120.0))
const LEAP_NEAREST_M := 0.025
const LEAP_FARTHEST_M := 0.6
## Polhemus Liberty: the manual gives a static error of 0.76 mm up to here.
const LIBERTY_RANGE_M := 0.9
const ARC_POINTS := 24


## Empty: the range is not known.
static func lines(tracker: HandTracker) -> PackedVector3Array:
	var source := tracker.source
	var points := PackedVector3Array()
	if source == null:
		return points
	# On a headset it moves with the head.
	if source is LeapSource and (source as LeapSource).mounting != LeapSource.MOUNTING_HMD:
		points = _pyramid(LEAP_NEAREST_M, LEAP_FARTHEST_M)
	elif source is LibertySource:
		points = _ball(LIBERTY_RANGE_M)
	var to_world := Transform3D()
	if "device_transform" in source:
		to_world = source.get("device_transform")
	var pose := tracker.global_transform if tracker.is_inside_tree() else tracker.transform
	if is_zero_approx(pose.basis.determinant()):
		return PackedVector3Array()
	return pose.affine_inverse() * to_world * points


## Upwards from a device on the table; its far side is part of a ball.
static func _pyramid(nearest_m: float, farthest_m: float) -> PackedVector3Array:
	var points := PackedVector3Array()
	for x: float in [-0.5, 0.5]:
		for z: float in [-0.5, 0.5]:
			var edge := _ray(x, z)
			points.append_array([nearest_m * edge, farthest_m * edge])
	for distance: float in [nearest_m, farthest_m]:
		for side: float in [-0.5, 0.5]:
			for i in ARC_POINTS:
				var a := float(i) / ARC_POINTS - 0.5
				var b := float(i + 1) / ARC_POINTS - 0.5
				points.append_array([distance * _ray(a, side), distance * _ray(b, side)])
				points.append_array([distance * _ray(side, a), distance * _ray(side, b)])
	return points


## `x` and `z`: shares of the angles of view, -0.5..0.5.
static func _ray(x: float, z: float) -> Vector3:
	return Vector3(tan(LEAP_ANGLES.x * x), 1.0, tan(LEAP_ANGLES.y * z)).normalized()


static func _ball(radius_m: float) -> PackedVector3Array:
	var points := PackedVector3Array()
	for axis in 3:
		for i in 2 * ARC_POINTS:
			for end in 2:
				var angle := PI * (i + end) / ARC_POINTS
				var point := Vector3.ZERO
				point[(axis + 1) % 3] = radius_m * cos(angle)
				point[(axis + 2) % 3] = radius_m * sin(angle)
				points.append(point)
	return points
