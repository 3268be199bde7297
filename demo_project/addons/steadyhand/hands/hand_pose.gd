extends RefCounted
## The joints of a hand that a mouse or a test moves.

## Between the tips of thumb and index, m.
const OPEN_M := 0.08
const PINCHED_M := 0.01
## Angles of three fingertips on their circle, rad: far enough from a line.
const ANGLES: Dictionary[HandTracker.Joint, float] = {
	HandTracker.JOINT_THUMB: 3.6,
	HandTracker.JOINT_INDEX: 1.5,
	HandTracker.JOINT_MIDDLE: 0.4,
}
## The index finger points along -z and the next three are curled; from the index fingertip, m.
const POINTING: Dictionary[HandTracker.Joint, Vector3] = {
	HandTracker.JOINT_INDEX: Vector3.ZERO,
	HandTracker.JOINT_MIDDLE: Vector3(0.0, -0.02, 0.06),
	HandTracker.JOINT_RING: Vector3(0.0, -0.04, 0.06),
	HandTracker.JOINT_PINKY: Vector3(0.0, -0.06, 0.06),
	HandTracker.JOINT_PALM: Vector3(0.0, -0.03, 0.11),
}
## Every hand trembles: equal positions, to the last bit, count as a freeze. Fingertip, arm held out
## (Growdon et al. 2000).
const TREMOR_M := 1.5e-4
const TREMOR_HZ := Vector3(8.7, 9.9, 11.3)


## `thumb_gap`: from the tip of the thumb to that of the index, m.
static func pointing(index_tip: Vector3, thumb_gap: float) -> Dictionary:
	var joints := {HandTracker.JOINT_THUMB: index_tip + thumb_gap * Vector3.LEFT}
	for joint in POINTING:
		joints[joint] = index_tip + POINTING[joint]
	return joints


## Three fingertips on an upright circle of `radius`, m.
static func circle(middle: Vector3, radius: float) -> Dictionary:
	var joints := {}
	for joint in ANGLES:
		joints[joint] = middle + radius * Vector3(cos(ANGLES[joint]), sin(ANGLES[joint]), 0.0)
	return joints


## Offset of the whole hand, m.
static func tremor(time_s: float) -> Vector3:
	var phase := TAU * time_s * TREMOR_HZ
	return TREMOR_M * Vector3(sin(phase.x), sin(phase.y), sin(phase.z))
