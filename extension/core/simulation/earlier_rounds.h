#pragma once

#include "simulation/true_motion.h"

#include <cstdint>

namespace steadyhand {

/// The motion after `rounds` repetitions of it, each followed by a return. The hand rests for half a second
/// at both ends. The return is straight (minimum jerk, Flash & Hogan 1985) and takes as long as the gesture.
[[nodiscard]] TrueMotion after_earlier_rounds(const TrueMotion &motion, std::uint32_t rounds);

} // namespace steadyhand
