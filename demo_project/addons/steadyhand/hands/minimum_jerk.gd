extends RefCounted
## A float or a Vector3 that goes from one value to the next on a minimum-jerk curve, as hands do
## (Flash & Hogan 1985), and rests before and after.

## Where the last motion ends.
var target: Variant

var _from: Variant
var _begin_s := 0.0
var _duration_s := 0.0


func _init(value: Variant) -> void:
	target = value
	_from = value


## Stops the current motion, and starts the new one from there.
func go(to: Variant, now_s: float, duration_s: float) -> void:
	_from = at(now_s)
	target = to
	_begin_s = now_s
	_duration_s = duration_s


func at(time_s: float) -> Variant:
	if time_s >= _begin_s + _duration_s:
		return target
	var p := maxf(time_s - _begin_s, 0.0) / _duration_s
	return lerp(_from, target, p * p * p * (10.0 + p * (6.0 * p - 15.0)))
