#pragma once

#include "tracking/hand_skeleton.h"

namespace steadyhand {

/// A whole skeleton from what a frame holds, for hand meshes. Joints that `frame` measured stay as they are;
/// the others are marked as inferred. The wrist and the palm give the hand's direction and size, two
/// tips that are bent alike its side; knuckles lie where they do in a hand of that size. Each finger bends
/// evenly from knuckle to tip, away from the back of the hand. Where the side is not known fingers are
/// straight. A finger whose tip, or a hand whose wrist and palm, is not tracked has no joints. Rotations that
/// `frame` does not hold point along the bone.
[[nodiscard]] HandSkeleton infer_skeleton(const DeviceFrame &frame);

} // namespace steadyhand
