#pragma once

#include "tracking/frame_filter.h"

namespace steadyhand {

/// Former name, for tests/core/matrix.
using FrameDoor = FrameFilter;

} // namespace steadyhand
