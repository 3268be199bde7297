class_name QuestionnairePanel
extends Node
## Shows a questionnaire item by item. The study calls ask(); extend it for another kind of display.

## `changes`: how often the answer was changed before it was confirmed.
signal answered(item: String, value: int, changes: int)
signal skipped(item: String)


## Asks `items` of the questionnaire, in order. Emits `answered` or `skipped` once for each.
## `trial`: the one before it, of the plan.
func ask(_asked: Questionnaire, _items: PackedStringArray, _trial: Dictionary) -> void:
	pass


## The study is paused or over: hides the questionnaire and emits no signal.
func close() -> void:
	pass
