extends RefCounted
## The conditions that are compared, in the order of every table and file. A new one is a new
## row.

const NAMES: Array[String] = ["measured", "average", "one_euro", "kalman", "synthesised"]
const TITLES: Array[String] = [
	"measured", "moving average", "One Euro filter", "Kalman filter", "synthesised"
]
const MOTIONS: Array[GestureHMM.Motion] = [
	GestureHMM.MOTION_MEASURED,
	GestureHMM.MOTION_AVERAGE,
	GestureHMM.MOTION_ONE_EURO,
	GestureHMM.MOTION_KALMAN,
	GestureHMM.MOTION_SYNTHESISED,
]
## The conditions of the paper's study.
const COMPARED: Array[GestureHMM.Motion] = [
	GestureHMM.MOTION_MEASURED, GestureHMM.MOTION_AVERAGE, GestureHMM.MOTION_SYNTHESISED
]
