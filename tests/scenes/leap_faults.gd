extends "support/leap_test.gd"
## LeapSource with a service that fails.


func test_bad_messages_are_ignored_and_warned_of_once() -> void:
	# expects one warning: a message of the service is left out
	# expects one warning: the service sends binary messages
	var service := _service("invalid")
	var drag := await _drag(service)
	drag.check(self, "among bad messages")
	# A message of 10 MB ends the connection.
	var is_back := func() -> bool:
		return drag.failures.size() == 1 and drag.tracker.is_hand_tracked()
	await drag.wait_until(self, PATIENCE_S, is_back)
	check(is_back.call(), "after 10 MB the hand is tracked again: %s" % [drag.failures])
	drag.free_scene()
	service.stop()


func test_a_lost_hand_comes_back_with_another_id() -> void:
	var service := _service("lost")
	var drag := await _drag(service)
	var is_back := func() -> bool: return drag.losses == 1 and drag.tracker.is_hand_tracked()
	await drag.wait_until(self, PATIENCE_S, is_back)
	check_equal(drag.losses, 1, "one loss")
	check(drag.tracker.is_hand_tracked(), "the hand is tracked again")
	drag.free_scene()
	service.stop()


func test_a_connection_that_drops_is_made_again() -> void:
	# expects error: has closed the connection. LeapSource tries again
	var service := _service("drop")
	var drag := await _drag(service)
	check_equal(drag.failures.size(), 1, "one failure: %s" % [drag.failures])
	check(drag.tracker.is_hand_tracked(), "the hand is tracked again")
	drag.free_scene()
	service.stop()


func test_a_service_that_is_killed_and_comes_back() -> void:
	# expects error: no service answers at ws://127.0.0.1
	# expects error: has closed the connection. LeapSource tries again
	var drag := SourceDrag.new(self, _folder.get_current_dir(), Vector3.ZERO)
	# A port that is free now.
	var stopped := _service("play")
	stopped.stop()
	drag.begin(_source(stopped))
	await drag.wait(self, 0.7)
	check_equal(drag.failures.size(), 1, "no service: %s" % [drag.failures])
	var service := _service("play", ["--port", str(stopped.port)])
	await drag.wait(self, 2.0)
	check(drag.tracker.is_hand_tracked(), "the service is found once it starts")
	service.stop()
	await drag.wait(self, 0.7)
	check_equal(drag.failures.size(), 2, "killed: %s" % [drag.failures])
	check(not drag.tracker.is_hand_tracked(), "the hand is lost")
	drag.free_scene()
