extends "study_hand.gd"
## The mouse in place of a hand, for trying a study out.


func _init() -> void:
	super(ScriptSource.new())
	origin = "mouse"


## The mouse has the engine's clock. It pushes no frame before a trial is shown.
func open(participant_id: String) -> Error:
	var opened := super(participant_id)
	tracker.push_frame(_engine_s(), {})
	return opened
