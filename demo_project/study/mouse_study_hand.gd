extends "study_hand.gd"
## The mouse in place of a hand, for trying a study out.


func _init() -> void:
	super(ScriptSource.new())
	origin = "mouse"
