#include "recognition/gesture_spotter.h"

#include "base/parameters.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

} // namespace

void GestureSpotter::expect(std::vector<GestureHmms> gestures) {
	for (const GestureHmms &one : gestures) {
		gesture_.reserve(one.gesture.size()); // push() does not allocate
	}
	const auto still = std::ranges::find(gestures, gesture_, &GestureHmms::gesture);
	index_ = static_cast<std::size_t>(still - gestures.begin());
	const bool is_gone = still == gestures.end();
	classifier_.expect(std::move(gestures));
	if (is_active_ && is_gone) {
		drop();
	}
}

const GestureCandidate *GestureSpotter::candidate_of(std::string_view gesture) const {
	const auto found = std::ranges::find(classifier_.gestures(), gesture, &GestureHmms::gesture);
	return found == classifier_.gestures().end()
			? nullptr
			: &classifier_.candidates()[static_cast<std::size_t>(found - classifier_.gestures().begin())];
}

void GestureSpotter::drop() {
	is_active_ = false;
	classifier_.forget_before(classifier_.time_s());
}

void GestureSpotter::end() {
	ended_s_ = classifier_.time_s();
	ended_axis_ = candidate_.axis;
	classifier_.expect_repetition_of(candidate_);
	drop();
}

GestureSpotter::Event GestureSpotter::push(const HandFrame &frame) {
	classifier_.push(frame);
	event_ = is_active_ ? follow() : find_start();
	return event_;
}

GestureSpotter::Event GestureSpotter::find_start() {
	// Gestures with one path share the probability until one of them is likelier.
	const auto candidates = classifier_.candidates();
	double any = 0.0;
	for (const GestureCandidate &candidate : candidates) {
		any += candidate.posterior;
	}
	const auto found = std::ranges::max_element(candidates, {}, &GestureCandidate::posterior);
	if (found == candidates.end() || !(any > START_POSTERIOR) || found->reach < SHORTEST) {
		return Event::NONE;
	}
	if (is_return(*found)) {
		drop();
		return Event::NONE;
	}
	index_ = static_cast<std::size_t>(found - candidates.begin());
	gesture_ = classifier_.gestures()[index_].gesture;
	candidate_ = *found;
	is_active_ = true;
	return Event::STARTED;
}

bool GestureSpotter::is_return(const GestureCandidate &candidate) const {
	return !candidate.is_radius && candidate.onset_s - ended_s_ < PAUSE_S &&
			candidate.axis.dot(ended_axis_) < -PARALLEL;
}

GestureSpotter::Event GestureSpotter::follow() {
	const GestureCandidate &now = classifier_.candidates()[index_];
	if (now.posterior < ABORT_POSTERIOR) {
		is_active_ = false;
		return Event::ABORTED;
	}
	candidate_ = now;
	if (now.posterior > END_POSTERIOR && now.end_probability > 0.5) {
		end();
		return Event::ENDED;
	}
	return Event::NONE;
}

} // namespace steadyhand
