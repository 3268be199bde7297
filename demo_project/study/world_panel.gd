extends Node3D
## A flat display in the scene, in front of a seated player. Add controls or canvas layers to
## `viewport`. Keys that the window does not use reach them.

const SIZE_M := Vector2(0.48, 0.3)
const SIZE := Vector2i(960, 600)
## Pixels of the texture for each pixel of the layout.
const SHARPNESS := 1.5

var viewport := SubViewport.new()


func _init() -> void:
	viewport.size = Vector2i(SHARPNESS * Vector2(SIZE))
	viewport.size_2d_override = SIZE
	viewport.size_2d_override_stretch = true
	viewport.disable_3d = true
	viewport.transparent_bg = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)


func _ready() -> void:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.disable_fog = true
	material.albedo_texture = viewport.get_texture()
	var quad := MeshInstance3D.new()
	var mesh := QuadMesh.new()
	mesh.size = SIZE_M
	quad.mesh = mesh
	quad.material_override = material
	quad.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(quad)


func _unhandled_key_input(event: InputEvent) -> void:
	viewport.push_input(event)


## x and y: pixels of the layout. z: distance in front of the display, m.
func to_display(place: Vector3) -> Vector3:
	var local := global_transform.affine_inverse() * place
	var share := Vector2(local.x, -local.y) / SIZE_M + Vector2(0.5, 0.5)
	var pixel := share * Vector2(SIZE)
	return Vector3(pixel.x, pixel.y, local.z)


## The place that to_display() maps to `pixel`, at a distance (m) in front of the display.
func from_display(pixel: Vector2, distance_m: float) -> Vector3:
	var share := pixel / Vector2(SIZE) - Vector2(0.5, 0.5)
	return global_transform * Vector3(share.x * SIZE_M.x, -share.y * SIZE_M.y, distance_m)
