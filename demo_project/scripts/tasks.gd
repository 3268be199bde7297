extends RefCounted
## The tasks of the study, in the order of the menu and of every table. A new one is a new row.

const SCENES: Dictionary[String, String] = {
	"horizontal_drag": "res://scenes/horizontal_drag.tscn",
	"vertical_drag": "res://scenes/vertical_drag.tscn",
	"tap": "res://scenes/tap.tscn",
	"zoom": "res://scenes/zoom.tscn",
}
const MENU := "res://scenes/menu.tscn"
const STUDY := "res://study/study_scene.tscn"
