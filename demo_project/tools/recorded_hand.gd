extends RefCounted
## A recording as a HandTracker that stands still until it is told to go on.


## Not in the tree yet, nor started.
static func make(path: String) -> HandTracker:
	var tracker := HandTracker.new()
	tracker.source = HandTracker.SOURCE_RECORDED
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	tracker.recording_path = path
	return tracker
