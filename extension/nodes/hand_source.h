#pragma once

#include "hand_stream.h"
#include "hand_tracker.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>

#include <memory>

namespace godot {

/// Where a HandTracker's frames come from: the settings of a device, a file, a simulation. Several trackers
/// may have the same one; each opens a HandStream of its own. A script may extend it.
class HandSource : public Resource {
	GDCLASS(HandSource, Resource)

public:
	GDVIRTUAL1R(String, _start, HandTracker *)
	GDVIRTUAL2(_poll, HandTracker *, double)
	GDVIRTUAL1(_stop, HandTracker *)

	/// p_tracker outlives the stream.
	virtual std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker);
	/// What keeps it from being opened, for the scene dock; each names the fix.
	virtual PackedStringArray get_warnings() const { return PackedStringArray(); }
	/// What to do where no frame has come of it for seconds.
	virtual String silence_advice() const;
	/// The file that it plays, or none.
	virtual String played_file() const { return String(); }
	/// Whether a script makes its frames.
	virtual bool is_script() const { return true; }

protected:
	static void _bind_methods();
};

} // namespace godot
