extends "../scenes/support/scene_test.gd"
## LibertySource on a USB whose tracker fails. Which way is the argument after `--`: unplug,
## missing, firmware or permission.

const SourceDrag := preload("../scenes/support/source_drag.gd")

## Where the simulated sensor rests.
const START := Vector3(0.0, 0.25, -0.3)
## For an event. On a busy computer the engine runs slowly.
const PATIENCE_S := 25.0
## What the message tells the user to do.
const FIXES: Dictionary[String, String] = {
	unplug = "Check the USB cable",
	missing = "Plug in its USB cable",
	firmware = "Load the firmware",
	permission = "Add the udev rule",
}

var _folder := DirAccess.create_temp("steadyhand_liberty")


func test_one_message_that_says_what_to_do() -> void:
	# expects one error: Liberty:
	var case := OS.get_cmdline_user_args()[0]
	var drag := SourceDrag.new(self, _folder.get_current_dir(), START)
	drag.begin(LibertySource.new())
	await drag.wait_until(self, PATIENCE_S, func() -> bool: return not drag.failures.is_empty())
	check(drag.failures[0].contains(FIXES[case]), "%s: %s" % [case, drag.failures])
	if case == "unplug":
		var is_lost := func() -> bool: return not drag.tracker.is_hand_tracked()
		await drag.wait_until(self, PATIENCE_S, is_lost)
		check(is_lost.call(), "the hand is lost")
		await drag.wait_until(self, PATIENCE_S, drag.tracker.is_hand_tracked)
		check(drag.tracker.is_hand_tracked(), "and is there again")
	check_equal(drag.failures.size(), 1, "one message")
	drag.free_scene()
