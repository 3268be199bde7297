#pragma once

#include "tracking/hand_skeleton.h"

namespace steadyhand {

/// Completes the skeleton of a frame, for hand meshes. Measured joints do not change; added joints are marked
/// as inferred. Missing rotations point along the bone.
///
/// Wrist and palm give direction and size of the hand, two fingertips its side. Knuckles are placed by the
/// proportions of an adult's hand. Each finger is an arc from knuckle to tip. If the side is unknown, fingers
/// are straight. A finger without a tracked tip gets no joints; a hand with neither wrist nor palm gets none.
[[nodiscard]] HandSkeleton infer_skeleton(const DeviceFrame &frame);

} // namespace steadyhand
