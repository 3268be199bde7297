extends "support/scene_test.gd"
## What the inspector offers where a name is asked for; any other is taken too.

const GESTURES: Array[String] = ["horizontal_drag", "tap", "vertical_drag", "zoom"]


func test_the_gesture_of_a_task() -> void:
	var task := GestureTask.new()
	check_equal(_suggested(task, "gesture"), GESTURES, "those of the models of the add-on")
	task.gesture = &"wave"
	check_equal(task.gesture, &"wave", "one that no model is of")
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


## Empty where the property is no name that is suggested.
static func _suggested(object: Object, property: String) -> Array[String]:
	var names: Array[String] = []
	for about in object.get_property_list():
		if about["name"] == property and about["hint"] == PROPERTY_HINT_ENUM_SUGGESTION:
			names.assign(Array((about["hint_string"] as String).split(",")))
	return names
