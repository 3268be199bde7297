extends SceneTree
## A live hand under --fixed-fps: prints the values of its motion, and quits when the drag is over.

const PushedHand := preload("pushed_hand.gd")
const XRHand := preload("xr_hand.gd")

var _hand := XRHand.new()
var _scene: Node = null
var _frame := 0


func _initialize() -> void:
	_hand.register()
	var folder := (get_script() as Script).resource_path.get_base_dir()
	_scene = (load(folder.path_join("no_script.tscn")) as PackedScene).instantiate()
	root.add_child(_scene)


func _process(_delta: float) -> bool:
	var hmm := _scene.get_node("GestureHMM") as GestureHMM
	var time_s := _frame / 90.0
	var way := 0.2 * PushedHand.share((time_s - 1.0) / 0.8)
	_hand.place(Vector3(-0.1 + way, 1.2, -0.4) + PushedHand.tremor(time_s))
	print(var_to_str(hmm.value))
	_frame += 1
	var is_over := hmm.recognised != &"" or _frame > 400
	if is_over and hmm.recognised != &"":
		print("ended at frame %d" % _frame)
	return is_over


func _finalize() -> void:
	_hand.remove()
