extends RefCounted
## The tasks of the study, in the order of the menu and of every table. A new one is a new row.

const SCENES: Dictionary[String, String] = {
	"horizontal_drag": "res://scenes/horizontal_drag.tscn",
	"vertical_drag": "res://scenes/vertical_drag.tscn",
	"tap": "res://scenes/tap.tscn",
	"zoom": "res://scenes/zoom.tscn",
}
## Further scenes of the menu.
const MORE_SCENES: Dictionary[String, String] = {
	"Tap on a wall": "res://scenes/tap_wall.tscn",
	"Study": STUDY,
	"Samples": "res://addons/steadyhand/samples/samples.tscn",
}
const TITLES: Dictionary[String, String] = {
	"horizontal_drag": "Horizontal drag",
	"vertical_drag": "Vertical drag",
	"tap": "Tap",
	"zoom": "Three-finger zoom",
}
const INSTRUCTIONS: Dictionary[String, String] = {
	"horizontal_drag": "Drag the box from the left marker to the right one.",
	"vertical_drag": "Drag the box from one marker to the other.",
	"tap": "Tap the surface with the index finger.",
	"zoom": "Open thumb, index and middle finger until the sphere fills the ring.",
}
const MENU := "res://scenes/menu.tscn"
const STUDY := "res://study/study_scene.tscn"
