extends RefCounted
## A HandTracker on a recording that is advanced by hand.


## Not yet in the tree, and not started.
static func make(path: String) -> HandTracker:
	var tracker := make_of(null)
	(tracker.source as RecordedSource).track = path
	return tracker


## As make().
static func make_of(recording: RecordedTrack) -> HandTracker:
	var tracker := HandTracker.new()
	var source := RecordedSource.new()
	source.recording = recording
	tracker.source = source
	tracker.update_mode = HandTracker.UPDATE_MANUAL
	tracker.autostart = false
	return tracker
