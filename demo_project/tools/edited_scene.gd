## Makes scenes for tests and pictures of the editor.
extends Object


## Saves a new scene with `nodes` in it, and frees them.
static func save(nodes: Array[Node], path: String) -> void:
	var scene := Node3D.new()
	scene.name = "Scene"
	for node in nodes:
		scene.add_child(node)
		node.owner = scene
	var packed := PackedScene.new()
	packed.pack(scene)
	ResourceSaver.save(packed, path)
	scene.free()
