#pragma once

#include "hand_source.h"

namespace godot {

/// A script pushes the frames by HandTracker.push_frame().
class ScriptSource : public HandSource {
	GDCLASS(ScriptSource, HandSource)

protected:
	static void _bind_methods() {}
};

} // namespace godot
