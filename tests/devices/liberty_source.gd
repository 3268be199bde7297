extends "../scenes/support/scene_test.gd"
## LibertySource in real time, on the USB of tests/devices/liberty_sim.cpp, whose child this engine
## is.

const SourceDrag := preload("../scenes/support/source_drag.gd")

## Where the simulated sensor rests.
const START := Vector3(0.0, 0.25, -0.3)
const PATIENCE_S := 8.0

var _folder := DirAccess.create_temp("steadyhand_liberty")


func test_a_drag_end_to_end() -> void:
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	drag.begin(LibertySource.new())
	await drag.wait(self, PATIENCE_S)
	drag.check(self, "LibertySource")
	check_near(drag.tracker.frame_rate, 240.0, 2.0, "the rate")
	check_near(drag.tracker.latency, 0.0035, 1e-9, "the manual's latency")
	check_equal(drag.failures, [] as Array[String], "no failure")
	drag.free_scene()
