#pragma once

#include "hand_stream.h"
#include "hand_tracker.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>

#include <memory>

namespace godot {

/// Source of a HandTracker's frames: settings of a device, a file or a simulation. Several trackers may use
/// the same source; each opens its own HandStream. A script may extend it.
class HandSource : public Resource {
	GDCLASS(HandSource, Resource)

public:
	GDVIRTUAL1R(String, _start, HandTracker *)
	GDVIRTUAL2(_poll, HandTracker *, double)
	GDVIRTUAL1(_stop, HandTracker *)

	/// p_tracker outlives the stream.
	virtual std::unique_ptr<HandStream> make_stream(HandTracker &p_tracker);
	/// Why it cannot be opened, and what to do, for the scene dock.
	virtual PackedStringArray get_warnings() const { return PackedStringArray(); }
	/// What to do if no frame has arrived for seconds.
	virtual String no_frame_advice() const;
	/// The played file; empty if there is none.
	virtual String played_file() const { return String(); }
	/// Whether a script pushes the frames.
	virtual bool is_script() const { return true; }

protected:
	static void _bind_methods();
};

} // namespace godot
