@tool
extends RefCounted
## Tells the user of the "Gestures" panel what to do next.

const TakeSet := preload("take_set.gd")

## The mean of so many takes differs from the mean of 40 by a third of the standard deviation of
## takes (three simulated people).
const ENOUGH_TAKES := 8
const LEAST_TAKES := 3
## This feature is recognised only at a task.
const CIRCLE := "index_along_circle"


static func while_recording(movements: int) -> String:
	return (
		"Make the gesture, rest, come back, rest. Repeat it, faster and slower. "
		+ "%d of %d made." % [movements, ENOUGH_TAKES]
	)


## `advice`: why nothing can be recorded, or empty. `takes`: null while no gesture is open.
## `saved_to`: empty while `model` is not saved.
static func of(
	advice: String, name: String, takes: TakeSet, model: GestureModel, saved_to: String
) -> String:
	if takes == null:
		return TakeSet.name_fault(name)
	if model != null:
		return _with_model(model, saved_to)
	var count := takes.rows.size()
	if count >= ENOUGH_TAKES:
		return "Press Train."
	if not advice.is_empty():
		return advice
	if count == 0:
		return "Press Record, make the gesture %d times, and press Stop." % ENOUGH_TAKES
	var more := "Record %d more takes." % (ENOUGH_TAKES - count)
	return more if count < LEAST_TAKES else more + " Or train with these: it will be less exact."


static func _with_model(model: GestureModel, saved_to: String) -> String:
	if saved_to.is_empty():
		return "Press Save. Or press Compare to see how often each gesture is recognised."
	var text := "Add %s to the models of a GestureHMM." % saved_to.get_file()
	if model.get_feature() == CIRCLE:
		text += " Add a GestureTask with the gesture '%s' to its tasks." % model.gesture
	return text
