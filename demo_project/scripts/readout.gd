extends CanvasLayer
## The condition, and the live values of all conditions, in mm. The condition is hidden from a
## participant who compares conditions.

const Conditions := preload("conditions.gd")

const DRIVING := Color(1.0, 0.83, 0.3)
const OTHER := Color(0.85, 0.88, 0.9)

## Replaces the status. Empty: the status is shown.
var notice := ""

var _values: Array[Label] = []
var _titles: Array[Label] = []

@onready var _table: GridContainer = %Values
@onready var _instruction: Label = %Instruction
@onready var _status: Label = %Status


func _ready() -> void:
	for row in Conditions.TITLES.size():
		_titles.append(_add_label("%d  %s" % [row + 1, Conditions.TITLES[row]]))
		_values.append(_add_label(""))
		_values[row].custom_minimum_size.x = 110
		_values[row].horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT


func show_instruction(text: String) -> void:
	_instruction.text = text


func show_live(motion: GestureHMM, is_blind: bool) -> void:
	for row in Conditions.MOTIONS.size():
		var is_marked := Conditions.MOTIONS[row] == motion.motion and not is_blind
		var colour := DRIVING if is_marked else OTHER
		_titles[row].modulate = colour
		_values[row].modulate = colour
		_values[row].text = "%.1f mm" % (1000.0 * motion.get_motion_value(Conditions.MOTIONS[row]))
	_status.text = notice if notice else _status_of(motion)


## Without an active gesture there is no state and no progress.
static func _status_of(motion: GestureHMM) -> String:
	if motion.gesture.is_empty():
		return "no gesture"
	return "%s   state %d   %.0f %%" % [motion.gesture, motion.state, 100.0 * motion.progress]


func _add_label(text: String) -> Label:
	var label := Label.new()
	label.text = text
	_table.add_child(label)
	return label
