extends Node3D
## A sensor at the origin of the tracker's frames. Rings show where distances of 250 mm and 500 mm
## from it meet the ground. The box lies on the ground, below the sensor.

const BOX := Vector3(0.08, 0.012, 0.03)
const BODY := Color(0.1, 0.11, 0.13)
const LENS := Color(0.55, 0.2, 0.95)
## m, and its colour.
const RANGES: Dictionary[float, Color] = {
	0.25: Color(0.45, 0.95, 0.75, 0.55),
	0.5: Color(1.0, 0.75, 0.3, 0.55),
}
const RING_WIDTH := 0.004
## Angle of the label on its ring, from the sensor's -z to the right.
const LABEL_ANGLE := deg_to_rad(38.0)

var _rings: Dictionary[float, MeshInstance3D] = {}
var _labels: Dictionary[float, Label3D] = {}


func _init() -> void:
	top_level = true
	var box := BoxMesh.new()
	box.size = BOX
	_add(box, BODY).position.y = 0.5 * BOX.y
	for side: float in [-1.0, 1.0]:
		var lens := CylinderMesh.new()
		lens.top_radius = 0.007
		lens.bottom_radius = 0.007
		lens.height = 0.002
		_add(lens, LENS).position = Vector3(side * 0.022, BOX.y, 0.0)
	for range_m in RANGES:
		var ring := TorusMesh.new()
		ring.rings = 128
		_rings[range_m] = _add(ring, RANGES[range_m])
		_rings[range_m].scale.y = 0.2
		var label := Label3D.new()
		label.text = "%.0f mm" % (1000.0 * range_m)
		label.font_size = 32
		label.pixel_size = 0.0005
		label.outline_size = 8
		label.rotation.x = -0.5 * PI
		label.modulate = Color(RANGES[range_m], 1.0)
		_labels[range_m] = label
		add_child(label)


## `height`: of the ground, m, relative to the sensor.
func place(height: float) -> void:
	global_transform = Transform3D(Basis(), Vector3(0.0, height, 0.0))
	for range_m in RANGES:
		var radius := sqrt(maxf(range_m * range_m - height * height, 0.0))
		var is_shown := radius > RING_WIDTH
		_rings[range_m].visible = is_shown
		_labels[range_m].visible = is_shown
		if not is_shown:
			continue
		var ring := _rings[range_m].mesh as TorusMesh
		ring.outer_radius = radius + 0.5 * RING_WIDTH
		ring.inner_radius = radius - 0.5 * RING_WIDTH
		var out := (radius + 0.022) * Vector3(sin(LABEL_ANGLE), 0.0, -cos(LABEL_ANGLE))
		_labels[range_m].position = out + Vector3(0.0, 0.004, 0.0)


## Whether the frames of a source have their origin in such a sensor.
static func suits(source: HandSource) -> bool:
	return source is SyntheticSource or (source != null and source.is_class("LeapSource"))


func _add(mesh: Mesh, colour: Color) -> MeshInstance3D:
	var body := MeshInstance3D.new()
	var material := StandardMaterial3D.new()
	material.albedo_color = colour
	material.roughness = 0.4
	if colour.a < 1.0:
		material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
		material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		body.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	body.mesh = mesh
	body.material_override = material
	add_child(body)
	return body
