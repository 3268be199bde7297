extends "support/scene_test.gd"
## Names that the inspector suggests; any other name is accepted, too.

const GESTURES: Array[String] = ["horizontal_drag", "tap", "vertical_drag", "zoom"]


func test_the_gesture_of_a_task() -> void:
	var task := GestureTask.new()
	check_equal(_suggested(task, "gesture"), GESTURES, "gestures of the add-on's models")
	task.gesture = &"wave"
	check_equal(task.gesture, &"wave", "a gesture without a model")
	task.free()


func test_the_feature_of_a_trainer() -> void:
	var offered := _suggested(GestureTrainer.new(), "feature")
	for gesture: String in GESTURES:
		var model: GestureModel = load("res://addons/steadyhand/models/%s.gesture" % gesture)
		check(model.feature in offered, "%s, by %s" % [gesture, model.feature])


func test_where_a_vibration_goes() -> void:
	var synth := HapticSynth.new()
	AudioServer.add_bus()
	AudioServer.set_bus_name(AudioServer.bus_count - 1, "Actuator")
	var buses := _suggested(synth, "bus")
	check("Master" in buses and "Actuator" in buses, "the buses: %s" % [buses])
	check_equal(buses.size(), AudioServer.bus_count, "and no more")
	check_equal(_suggested(synth, "controller_action"), ["haptic"] as Array[String], "the action")
	synth.free()


func test_no_value_of_a_slider_is_refused() -> void:
	var classes := ClassDB.get_inheriters_from_class("HapticEffect")
	classes.append_array(ClassDB.get_inheriters_from_class("HandSource"))
	classes.append_array(
		["HapticDeviceProfile", "HandTracker", "GestureHMM", "GestureTask", "HapticSynth"]
	)
	for name in classes:
		var object: Object = ClassDB.instantiate(name)
		for about in ClassDB.class_get_property_list(name):
			var is_number: bool = about["type"] == TYPE_FLOAT or about["type"] == TYPE_INT
			if about["hint"] == PROPERTY_HINT_RANGE and is_number:
				_check_range(object, about)
		if object is Node:
			object.free()


## Both ends, and whether values beyond them may be entered.
func _check_range(object: Object, about: Dictionary) -> void:
	var property: String = about["name"]
	var hint: PackedStringArray = (about["hint_string"] as String).split(",")
	var values: Array[float] = [hint[0].to_float(), hint[1].to_float()]
	if "or_less" in hint:
		values.append(values[0] - values[1])
	if "or_greater" in hint:
		values.append(3.0 * values[1])
	for value in values:
		object.set(property, value)
		check_near(object.get(property), value, 1e-9, "%s.%s" % [object.get_class(), property])


## Empty: no names are suggested for the property.
static func _suggested(object: Object, property: String) -> Array[String]:
	var names: Array[String] = []
	for about in object.get_property_list():
		if about["name"] == property and about["hint"] == PROPERTY_HINT_ENUM_SUGGESTION:
			names.assign(Array((about["hint_string"] as String).split(",")))
	return names
