#pragma once

#include "tracking/hand_skeleton.h"

namespace steadyhand {

/// A whole skeleton from what a frame holds, for hand meshes. Joints that `frame` measured stay as they are.
/// Each other joint lies at a fixed share of the line from the wrist (or else the palm) to its fingertip, and
/// is marked as inferred. A finger whose tip, or hand whose wrist and palm, is not tracked has no joints.
/// Rotations, which `frame` does not hold, point along the bone.
[[nodiscard]] HandSkeleton infer_skeleton(const DeviceFrame &frame);

} // namespace steadyhand
