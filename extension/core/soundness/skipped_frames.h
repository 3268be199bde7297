#pragma once

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Whether a tracker leaves out frames one at a time more often than one that sees the hand well does: how
/// much likelier its intervals are of one that does not, as a logarithm. Held to 0 and more, so that nothing
/// counts that was before it began to (cumulative sum, Page 1954, doi:10.1093/biomet/41.1-2.100).
class SkippedFrames {
public:
	/// is_skipped: between the newest frame and the one before one or two are missing.
	void push(bool is_skipped) {
		log_ratio_ = std::clamp(log_ratio_ + (is_skipped ? SKIPPED : REGULAR), 0.0, MOST);
	}
	/// 0 .. 3
	[[nodiscard]] double log_ratio() const { return log_ratio_; }

private:
	/// Share of intervals that are 2 or 3 periods long, of a tracker that sees the hand well, and of one that
	/// errs.
	static constexpr double SHARE_SOUND = 0.012, SHARE_UNSOUND = 0.045;
	/// A program that leaves out frames of a sound tracker is taken for no more than this.
	static constexpr double MOST = 3.0;
	inline static const double SKIPPED = std::log(SHARE_UNSOUND / SHARE_SOUND);
	inline static const double REGULAR = std::log((1.0 - SHARE_UNSOUND) / (1.0 - SHARE_SOUND));

	double log_ratio_ = 0.0;
};

} // namespace steadyhand
