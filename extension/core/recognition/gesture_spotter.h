#pragma once

#include "recognition/gesture_classifier.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

/// Detects the begin, end and abort of gestures by the posteriors of a GestureClassifier, one gesture at a
/// time. The return of the hand at once after a gesture is not a gesture.
class GestureSpotter {
public:
	enum class News : std::uint8_t { NOTHING, BEGUN, ENDED, ABORTED };

	explicit GestureSpotter(GestureClassifier classifier) : classifier_(std::move(classifier)) {}

	/// Replaces the gestures. The active gesture goes on if it is one of them; otherwise it is dropped. Only
	/// this allocates.
	void expect(std::vector<std::string> gestures);
	News push(const HandFrame &frame);
	/// Ends the active gesture without news. Its onsets are deleted.
	void drop();

	/// News of the newest frame.
	[[nodiscard]] News news() const { return news_; }
	[[nodiscard]] bool is_active() const { return is_active_; }
	/// Gesture of the last news; empty before the first.
	[[nodiscard]] const std::string &gesture() const { return gesture_; }
	/// Last candidate of this gesture while it was active.
	[[nodiscard]] const GestureCandidate &candidate() const { return candidate_; }

private:
	GestureClassifier classifier_;
	News news_ = News::NOTHING;
	bool is_active_ = false;
	std::string gesture_;
	std::size_t index_ = 0; ///< of the gesture in candidates()
	GestureCandidate candidate_;
	double ended_s_ = -INFINITY;
	Eigen::Vector3d ended_axis_ = Eigen::Vector3d::Zero();

	News find_start();
	News follow();
	[[nodiscard]] bool is_return(const GestureCandidate &candidate) const;
};

} // namespace steadyhand
