extends "../scenes/support/scene_test.gd"
## LibertySource in real time, on the USB of tests/devices/liberty_sim.cpp, whose child this engine is.
## What is expected is the argument after `--`: drag, unplug, missing, firmware or permission.

const SourceDrag := preload("../scenes/support/source_drag.gd")

## Where the simulated sensor rests.
const START := Vector3(0.0, 0.25, -0.3)
const PATIENCE_S := 8.0

var _folder := DirAccess.create_temp("steadyhand_liberty")


func test_the_case() -> void:
	var case := OS.get_cmdline_user_args()[0]
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	drag.begin(LibertySource.new())
	match case:
		"drag":
			await drag.wait(self, PATIENCE_S)
			drag.check(self, "LibertySource")
			check_near(drag.tracker.frame_rate, 240.0, 2.0, "the rate")
			check_near(drag.tracker.latency, 0.0035, 1e-9, "the manual's latency")
			check_equal(drag.failures, [] as Array[String], "no failure")
		"unplug":
			var is_back := func() -> bool:
				return drag.failures.size() == 1 and drag.tracker.is_hand_tracked()
			await drag.wait_until(self, PATIENCE_S, is_back)
			check_equal(drag.failures.size(), 1, "one failure: %s" % [drag.failures])
			check_equal(drag.losses, 1, "the hand was lost")
			check(drag.tracker.is_hand_tracked(), "and is there again")
		_:
			await drag.wait_until(
				self, PATIENCE_S, func() -> bool: return not drag.failures.is_empty()
			)
			var said := {missing = "plug it in", firmware = "firmware", permission = "udev rule"}
			check_equal(drag.failures.size(), 1, "one failure")
			check(drag.failures[0].contains(said[case]), "it says what to do: %s" % [drag.failures])
	drag.free_scene()
