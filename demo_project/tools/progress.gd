extends RefCounted
## Shows the progress of a long run: one moving line on a terminal, else a line for every 10 %.

## ./steadyhand sets it to 1 if standard output is a terminal, because the engine cannot detect it.
const TERMINAL := "STEADYHAND_TERMINAL"
const BAR := 30

var _label := ""
var _moves := OS.get_environment(TERMINAL) == "1"
var _shown := -1


func _init(label: String) -> void:
	_label = label


## `done`: 0..1.
func show(done: float) -> void:
	var steps := 100 if _moves else 10
	var step := floori(steps * done + 1e-9)
	if step <= _shown or step == 0:
		return
	_shown = step
	if not _moves:
		print("  %s: %d %%" % [_label, 100 * step / steps])
		return
	var filled := BAR * step / steps
	printraw("\r  %s  %s%s %3d %%" % [_label, "#".repeat(filled), "-".repeat(BAR - filled), step])
	if step == steps:
		printraw("\n")
