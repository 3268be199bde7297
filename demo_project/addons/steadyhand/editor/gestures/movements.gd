@tool
extends RefCounted
## Finds the movements of a recorded track, and describes each as a row of a trial set.

## What moves: the index tip along a line or a circle, or fingers that open.
enum Shape { AUTOMATIC, STRAIGHT, CIRCLE, OPENING }

const TrackCurves := preload("track_curves.gd")

const FEATURES: Dictionary[Shape, String] = {
	Shape.STRAIGHT: "index_along_axis",
	Shape.CIRCLE: "index_along_circle",
	Shape.OPENING: "tips_circumradius",
}

## Time span for a speed: shorter than any movement, and long enough to average noise.
const SPEED_SPAN_S := 0.06
## m/s: a hand held still moves slower.
const STILL_SPEED := 0.03
## Shares of the highest speed. A movement exceeds MOVING, and begins and ends at the lower one.
const MOVING := 0.15
const ONSET := 0.05
## A halt shorter than this belongs to the movement.
const HALT_S := 0.12
const SHORTEST_S := 0.1
## Share of the longest movement: a shorter one does not count.
const SHORTEST_WAY := 0.4
## Cosine of 60 degrees: another direction is the way back, or something else.
const SAME_WAY := 0.5
## Largest gap between a circle's ends, as a share of its length: 3/4 of a circle count.
const CLOSED := 0.3
## Least area of a closed path, as a share of that of a circle of equal length.
const ROUND := 0.5
## Share of the way out: a hand that comes back by more has turned.
const TURNED := 0.3
## Fingers open if the radius grows by this share of the index tip's way.
const OPENS := 0.3


## Rows with the keys of TrialSet.get_trial(), in order of time, of the movements that go the way
## of the first one. `others`: receives how many go another way.
static func find(curves: TrackCurves, shape: Shape, others: Array[int] = []) -> Array[Dictionary]:
	if shape == Shape.AUTOMATIC:
		shape = guess_shape(curves)
	var rows := find_all(curves, shape)
	var longest := 0.0
	for row in rows:
		longest = maxf(longest, absf(row["amplitude_m"]))
	rows = rows.filter(
		func(row: Dictionary) -> bool: return absf(row["amplitude_m"]) > SHORTEST_WAY * longest
	)
	var kept := rows.filter(func(row: Dictionary) -> bool: return _goes_like(row, rows, shape))
	others.append(rows.size() - kept.size())
	return kept


## Every movement, whichever way it goes.
static func find_all(curves: TrackCurves, shape: Shape) -> Array[Dictionary]:
	var rows: Array[Dictionary] = []
	var points := _points(curves, shape)
	var spans := _spans(points)
	if shape != Shape.CIRCLE:
		spans = _split_at_turns(points, spans)
	for span in spans:
		rows.append(describe(curves, shape, curves.time_at(span.x), curves.time_at(span.y)))
	return rows


## The row of a movement from `start_s` to `end_s` on the track's clock. Its amplitude is negative
## for fingers that close, and for a circle that turns clockwise.
static func describe(curves: TrackCurves, shape: Shape, start_s: float, end_s: float) -> Dictionary:
	var row := {
		trial = "",
		gesture = "",
		position = "stable",
		subject = "editor",
		start_s = start_s,
		end_s = end_s,
		start = Vector3.ZERO,
		axis = Vector3.ZERO,
		amplitude_m = 0.0,
	}
	var first := curves.index_at(start_s)
	var last := curves.index_at(end_s)
	match shape:
		Shape.OPENING:
			row["start"] = Vector3(curves.radius[first], 0.0, 0.0)
			row["amplitude_m"] = curves.radius[last] - curves.radius[first]
		Shape.CIRCLE:
			_describe_circle(curves.index.slice(first, last + 1), row)
		_:
			var way := curves.index[last] - curves.index[first]
			row["start"] = curves.index[first]
			row["axis"] = way.normalized()
			row["amplitude_m"] = way.length()
	return row


## The shape of a row: a radius has no axis.
static func shape_of(curves: TrackCurves, row: Dictionary) -> Shape:
	if (row["axis"] as Vector3).is_zero_approx():
		return Shape.OPENING
	var first := curves.index_at(row["start_s"])
	var last := curves.index_at(row["end_s"])
	return Shape.CIRCLE if _is_round(curves.index.slice(first, last + 1)) else Shape.STRAIGHT


static func guess_shape(curves: TrackCurves) -> Shape:
	if curves.index.is_empty():
		return Shape.OPENING
	if not curves.radius.is_empty():
		var radii := Array(curves.radius)
		var box := AABB(curves.index[0], Vector3.ZERO)
		for point in curves.index:
			box = box.expand(point)
		if radii.max() - radii.min() > OPENS * box.size.length():
			return Shape.OPENING
	var moved := 0
	var circled := 0
	for span in _spans(curves.index):
		moved += span.y - span.x
		if _is_round(curves.index.slice(span.x, span.y + 1)):
			circled += span.y - span.x
	return Shape.CIRCLE if 2 * circled > moved else Shape.STRAIGHT


static func _points(curves: TrackCurves, shape: Shape) -> PackedVector3Array:
	if shape != Shape.OPENING:
		return curves.index
	var points := PackedVector3Array()
	for radius_m in curves.radius:
		points.append(Vector3(radius_m, 0.0, 0.0))
	return points


## First and last point of each movement.
static func _spans(points: PackedVector3Array) -> Array[Vector2i]:
	var spans: Array[Vector2i] = []
	var speeds := _speeds(points)
	var highest := 0.0
	for speed in speeds:
		highest = maxf(highest, speed)
	var moving := maxf(MOVING * highest, STILL_SPEED)
	for i in speeds.size():
		if speeds[i] <= moving:
			continue
		if not spans.is_empty() and i - spans[-1].y <= HALT_S * TrackCurves.RATE_HZ:
			spans[-1].y = i
		else:
			spans.append(Vector2i(i, i))
	var onset := maxf(ONSET * highest, 0.5 * STILL_SPEED)
	for n in spans.size():
		var least := spans[n - 1].y + 1 if n > 0 else 0
		var most := spans[n + 1].x - 1 if n + 1 < spans.size() else speeds.size() - 1
		while spans[n].x > least and speeds[spans[n].x] > onset:
			spans[n].x -= 1
		while spans[n].y < most and speeds[spans[n].y] > onset:
			spans[n].y += 1
	return spans.filter(
		func(span: Vector2i) -> bool: return span.y - span.x >= SHORTEST_S * TrackCurves.RATE_HZ
	)


## A hand that turns back at once, as after a tap, has made two movements.
static func _split_at_turns(points: PackedVector3Array, spans: Array[Vector2i]) -> Array[Vector2i]:
	var parts: Array[Vector2i] = []
	for span in spans:
		var farthest := span.x
		for i in range(span.x, span.y + 1):
			var way := points[i].distance_to(points[span.x])
			if way > points[farthest].distance_to(points[span.x]):
				farthest = i
		var out := points[farthest].distance_to(points[span.x])
		if points[span.y].distance_to(points[farthest]) > TURNED * out:
			parts.append(Vector2i(span.x, farthest))
			parts.append(Vector2i(farthest, span.y))
		else:
			parts.append(span)
	return parts


## m/s
static func _speeds(points: PackedVector3Array) -> PackedFloat64Array:
	var speeds := PackedFloat64Array()
	speeds.resize(points.size())
	var half := int(0.5 * SPEED_SPAN_S * TrackCurves.RATE_HZ)
	for i in points.size():
		var before := maxi(i - half, 0)
		var after := mini(i + half, points.size() - 1)
		if after > before:
			var way := points[after].distance_to(points[before])
			speeds[i] = way * TrackCurves.RATE_HZ / (after - before)
	return speeds


static func _goes_like(row: Dictionary, rows: Array[Dictionary], shape: Shape) -> bool:
	if shape != Shape.STRAIGHT:
		return row["amplitude_m"] > 0.0
	return (row["axis"] as Vector3).dot(rows[0]["axis"]) > SAME_WAY


static func _is_round(path: PackedVector3Array) -> bool:
	var length := 0.0
	# Steps of one point would add the noise to the length.
	var step := int(SPEED_SPAN_S * TrackCurves.RATE_HZ)
	for i in range(step, path.size(), step):
		length += path[i].distance_to(path[i - step])
	var gap := path[0].distance_to(path[-1])
	var round_area := (length + gap) ** 2 / (4.0 * PI)
	return gap < CLOSED * length and absf(_area_and_centroid(path).z) > ROUND * round_area


## Of the closed path in the xy plane. x and y: the centroid, m, which does not depend on the speed
## along the path. z: the area, m^2, positive if the path is counterclockwise.
static func _area_and_centroid(path: PackedVector3Array) -> Vector3:
	var area := 0.0
	var centroid := Vector2.ZERO
	for i in path.size():
		# Relative to the first point: differences of products lose digits far from the origin.
		var a := path[i] - path[0]
		var b := path[(i + 1) % path.size()] - path[0]
		var twice := a.x * b.y - a.y * b.x
		area += 0.5 * twice
		centroid += twice * Vector2(a.x + b.x, a.y + b.y) / 6.0
	if not is_zero_approx(area):
		centroid /= area
	return Vector3(path[0].x + centroid.x, path[0].y + centroid.y, area)


## A circle begins along the axis and turns counterclockwise, see GestureTrainer.feature.
static func _describe_circle(path: PackedVector3Array, row: Dictionary) -> void:
	var centroid := _area_and_centroid(path)
	var radius_m := sqrt(absf(centroid.z) / PI)
	var out := path[0] - centroid
	row["start"] = path[0]
	row["axis"] = Vector3(-out.y, out.x, 0.0).normalized()
	row["amplitude_m"] = TAU * radius_m * signf(centroid.z)
