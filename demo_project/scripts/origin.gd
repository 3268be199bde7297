extends RefCounted
## Who makes a trial: "person", "mouse", "synthetic" or "replay", as in the logs.


## Who makes the frames of a source.
static func of(source: HandSource) -> String:
	if source is DegradedSource:
		return of((source as DegradedSource).source)
	if source is SyntheticSource:
		return "synthetic"
	if source is RecordedSource:
		return "replay"
	return "mouse" if source is MouseSource else "person"
