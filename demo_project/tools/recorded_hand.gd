extends RefCounted
## A recording as a HandTracker that stands still until it is told to go on.


## Not in the tree yet, nor started.
static func make(path: String) -> HandTracker:
	var tracker := HandTracker.new()
	var source := RecordedSource.new()
	source.track = path
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	return tracker
