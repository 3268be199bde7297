#pragma once

#include "recognition/gesture_classifier.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steadyhand {

/// Detects the begin, end and abort of gestures by the posteriors of a GestureClassifier, one gesture at a
/// time. The return of the hand at once after a gesture is not a gesture.
class GestureSpotter {
public:
	enum class Event : std::uint8_t { NONE, STARTED, ENDED, ABORTED };

	explicit GestureSpotter(GestureClassifier classifier) : classifier_(std::move(classifier)) {}

	/// Replaces the gestures. The active gesture goes on if it is one of them; otherwise it is dropped. Only
	/// this allocates.
	void expect(std::vector<GestureHmms> gestures);
	Event push(const HandFrame &frame);
	/// Ends the active gesture. Its onsets are deleted.
	void end();
	/// As end(), but the movement was no gesture.
	void drop();

	/// Event at the newest frame.
	[[nodiscard]] Event event() const { return event_; }
	[[nodiscard]] bool is_active() const { return is_active_; }
	/// Gesture of the last event; empty before the first.
	[[nodiscard]] const std::string &gesture() const { return gesture_; }
	/// Present candidate of a gesture; nullptr if it is not expected.
	[[nodiscard]] const GestureCandidate *candidate_of(std::string_view gesture) const;
	/// The hand of the ended gesture arrived at t_s, before the end was known.
	void set_arrival(double t_s) { ended_s_ = t_s; }
	/// Last candidate of this gesture while it was active.
	[[nodiscard]] const GestureCandidate &candidate() const { return candidate_; }

private:
	GestureClassifier classifier_;
	Event event_ = Event::NONE;
	bool is_active_ = false;
	std::string gesture_;
	std::size_t index_ = 0; ///< of the gesture in candidates()
	GestureCandidate candidate_;
	double ended_s_ = -INFINITY;
	Eigen::Vector3d ended_axis_ = Eigen::Vector3d::Zero();

	Event find_start();
	Event follow();
	[[nodiscard]] bool is_return(const GestureCandidate &candidate) const;
};

} // namespace steadyhand
