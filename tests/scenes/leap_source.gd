extends "support/leap_test.gd"
## LeapSource with a service without faults.


func test_a_drag_end_to_end() -> void:
	for dialect: String in ["orion", "bridge"]:
		var service := _service("play", ["--dialect", dialect])
		var drag := await _drag(service)
		drag.check(self, dialect)
		check_near(drag.tracker.frame_rate, 110.0, 3.0, "%s: the device's rate" % dialect)
		check(drag.tracker.frame_jitter < 0.001, "%s: %s" % [dialect, drag.tracker.frame_jitter])
		check_equal(drag.failures, [] as Array[String], "%s: no failure" % dialect)
		drag.free_scene()
		service.stop()


func test_the_device_s_clock_stamps_bursts() -> void:
	var service := _service("bursts")
	var drag := await _drag(service)
	drag.check(self, "frames in threes")
	check(drag.tracker.frame_jitter < 0.001, "jitter %s s" % drag.tracker.frame_jitter)
	drag.free_scene()
	service.stop()


func test_split_messages() -> void:
	var service := _service("split")
	var drag := await _drag(service)
	drag.check(self, "split")
	drag.free_scene()
	service.stop()


func test_an_older_service() -> void:
	var service := _service("old")
	var drag := SourceDrag.new(self, _folder.get_current_dir(), service.start)
	drag.begin(_source(service))
	await drag.wait(self, 1.5)
	check(service.log_text().contains("/v5.json"), "an older version is requested")
	drag.free_scene()
	service.stop()
