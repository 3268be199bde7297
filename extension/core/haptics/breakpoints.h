#pragma once

#include <span>
#include <vector>

namespace steadyhand {

/// A point of an envelope, which is straight between its points.
struct Breakpoint {
	double time_s = 0.0;
	double value = 0.0;
};

/// The envelope's value at a time: that of the last point after it, `before` ahead of the first one. Of two
/// points at one time the later one counts from there on. Times must not decrease.
[[nodiscard]] double value_at(std::span<const Breakpoint> points, double time_s, double before);

/// Some of the points, with the first and the last: between them the envelope differs from those left out by
/// at most `error`. Takes linear time (the "cone intersection" of Williams 1978, doi
/// 10.1016/0146-664X(78)90106-2).
[[nodiscard]] std::vector<Breakpoint> simplified(std::span<const Breakpoint> points, double error);

} // namespace steadyhand
