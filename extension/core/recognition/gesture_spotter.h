#pragma once

#include "recognition/gesture_classifier.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

/// Says when a gesture begins, ends or is aborted, by the posteriors of a GestureClassifier. One at a time. A
/// hand that goes back at once after a gesture makes none.
class GestureSpotter {
public:
	enum class News : std::uint8_t { NOTHING, BEGUN, ENDED, ABORTED };

	explicit GestureSpotter(GestureClassifier classifier) : classifier_(std::move(classifier)) {}

	/// From now on these. A gesture under way that is one of them goes on; another one is dropped. Allocates;
	/// nothing else does.
	void expect(std::vector<std::string> gestures);
	News push(const HandFrame &frame);
	/// What is under way is no gesture.
	void drop();

	/// Of the newest frame.
	[[nodiscard]] News news() const { return news_; }
	[[nodiscard]] bool is_active() const { return is_active_; }
	/// Of which the last news was; empty before the first.
	[[nodiscard]] const std::string &gesture() const { return gesture_; }
	/// That gesture, as it was last seen.
	[[nodiscard]] const GestureCandidate &candidate() const { return candidate_; }

private:
	GestureClassifier classifier_;
	News news_ = News::NOTHING;
	bool is_active_ = false;
	std::string gesture_;
	std::size_t index_ = 0; ///< the gesture's, among candidates()
	GestureCandidate candidate_;
	double ended_s_ = -INFINITY;
	Eigen::Vector3d ended_axis_ = Eigen::Vector3d::Zero();

	News look_for();
	News follow();
	[[nodiscard]] bool is_way_back(const GestureCandidate &candidate) const;
};

} // namespace steadyhand
