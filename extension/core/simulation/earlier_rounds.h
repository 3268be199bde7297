#pragma once

#include "simulation/true_motion.h"

#include <cstdint>

namespace steadyhand {

/// The same execution after the hand has made it so many times before, and come back each time: half a second
/// at rest at either end, and a straight way back (minimum jerk, Flash & Hogan 1985) that takes as long as
/// the gesture.
[[nodiscard]] TrueMotion after_earlier_rounds(const TrueMotion &motion, std::uint32_t rounds);

} // namespace steadyhand
