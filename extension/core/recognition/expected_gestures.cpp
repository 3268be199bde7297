// The expected gestures of a GestureRecogniser, and changes of them.

#include "base/parameters.h"
#include "gesture/classifier_file.h"
#include "recognition/gesture_recogniser.h"
#include "recognition/hmm_session.h"
#include "recognition/task_session.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

namespace steadyhand {
namespace {

std::unique_ptr<GestureSession> session_for(
		const ExpectedGesture &gesture, const Synthesis &synthesis, GestureSpotter *spotter) {
	if (gesture.task) {
		return std::make_unique<TaskSession>(*gesture.model, *gesture.task, synthesis);
	}
	return std::make_unique<HmmSession>(*gesture.model, synthesis, *spotter);
}

} // namespace

GestureRecogniser::GestureRecogniser(std::vector<ExpectedGesture> gestures, const Synthesis &synthesis) :
		synthesis_(synthesis) {
	expect(std::move(gestures));
}

std::vector<int> GestureRecogniser::expect(std::vector<ExpectedGesture> gestures) {
	const GestureSession *const shown_before = sessions_.empty() ? nullptr : sessions_[shown()].get();
	// Models must outlive their sessions, which are deleted first.
	const std::vector<ExpectedGesture> gestures_before = std::exchange(gestures_, std::move(gestures));
	std::vector<std::unique_ptr<GestureSession>> sessions_before = std::exchange(sessions_, {});
	const std::vector<FilteredMotion> filtered_before = std::exchange(filtered_, {});
	const std::vector<Start> starts_before = std::exchange(starts_, {});
	std::vector<int> now(gestures_before.size(), -1);
	sessions_.reserve(gestures_.size());
	filtered_.reserve(gestures_.size());
	starts_.reserve(gestures_.size());
	expect_spotted();
	std::uint32_t number = 0;
	for (const std::unique_ptr<GestureSession> &session : sessions_before) {
		number = std::max(number, session->gestures_started());
	}
	for (std::size_t i = 0; i < gestures_.size(); ++i) {
		std::size_t old = 0;
		while (old < now.size() && (now[old] >= 0 || !(gestures_before[old] == gestures_[i]))) {
			++old;
		}
		if (old < now.size()) {
			now[old] = static_cast<int>(i);
			sessions_.push_back(std::move(sessions_before[old]));
			filtered_.push_back(filtered_before[old]);
			starts_.push_back(starts_before[old]);
		} else {
			sessions_.push_back(session_for(gestures_[i], synthesis_, spotter_.get()));
			sessions_.back()->set_completion(completion_);
			sessions_.back()->set_gestures_started(number);
			filtered_.emplace_back();
			starts_.emplace_back();
		}
	}
	leader_ = leader_ >= 0 ? now[static_cast<std::size_t>(leader_)] : -1;
	const bool is_active = leader_ >= 0 && session()->stage() == GestureSession::Stage::ACTIVE;
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (std::ranges::find(now, static_cast<int>(i)) == now.end()) {
			sessions_[i]->ignore_before(is_active ? time_s_ : ended_s_);
		}
	}
	const int still_shown = shown_ < now.size() ? now[shown_] : -1;
	shown_ = still_shown >= 0 ? static_cast<std::size_t>(still_shown) : nearest();
	track_features();
	if (sessions_.empty() || sessions_[shown()].get() != shown_before) {
		blend_ = {};
	}
	return now;
}

void GestureRecogniser::expect_spotted() {
	std::vector<GestureHmms> spotted;
	for (const ExpectedGesture &gesture : gestures_) {
		const bool is_first = !std::ranges::count(spotted, gesture.model->gesture, &GestureHmms::gesture);
		if (!gesture.task && is_first) {
			spotted.push_back(HmmSession::hmms_of(gesture.model));
		}
	}
	if (spotted.empty()) {
		spotter_.reset();
	} else if (spotter_) {
		spotter_->expect(std::move(spotted));
	} else {
		spotter_ = std::make_unique<GestureSpotter>(GestureClassifier(own_classifier(), std::move(spotted)));
	}
}

void GestureRecogniser::track_features() {
	std::vector<FeatureTrack> before = std::exchange(tracks_, {});
	track_of_.clear();
	for (std::size_t i = 0; i < gestures_.size(); ++i) {
		const Feature *const feature = find_feature(gestures_[i].model->feature);
		const auto is_its = [feature](const FeatureTrack &track) { return &track.feature() == feature; };
		const auto known = std::find_if(tracks_.begin(), tracks_.end(), is_its);
		track_of_.push_back(static_cast<std::size_t>(known - tracks_.begin()));
		if (known != tracks_.end()) {
			continue;
		}
		const auto old = std::find_if(before.begin(), before.end(), is_its);
		tracks_.push_back(old != before.end() ? std::move(*old) : FeatureTrack(*feature));
	}
}

} // namespace steadyhand
