extends "scene_test.gd"
## A test of LeapSource with a simulated service, in real time.

const LeapService := preload("leap_service.gd")
const SourceDrag := preload("source_drag.gd")

const PATIENCE_S := 8.0

var _folder := DirAccess.create_temp("steadyhand_leap")


func _service(scenario: String, options: PackedStringArray = []) -> LeapService:
	return LeapService.new(_folder.get_current_dir(), scenario, options)


func _source(service: LeapService) -> LeapSource:
	var source := LeapSource.new()
	source.port = service.port
	return source


func _drag(service: LeapService) -> SourceDrag:
	var drag := SourceDrag.new(self, _folder.get_current_dir(), service.start)
	drag.begin(_source(service))
	await drag.wait(self, PATIENCE_S)
	return drag
