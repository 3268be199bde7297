#pragma once

#include "../models.h"
#include "gesture_events.h"
#include "performance.h"
#include "plain_tracker.h"
#include "verdict.h"

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand::bench {

struct NamedTracker {
	const char *name;
	TrackerKind kind;
};
inline constexpr std::array TRACKERS{ NamedTracker{ "0.1 mm", TrackerKind::GOOD },
	NamedTracker{ "1 mm", TrackerKind::NOISY }, NamedTracker{ "bad", TrackerKind::BAD } };

struct Run {
	Performance hand;
	std::vector<GestureEvent> events;
	std::set<std::string> faults;
};

/// Events of the recogniser for one hand and one tracker, and their faults. Equal arguments give equal runs.
inline Run run(const Models &models, const HandKind &kind, TrackerKind tracker, Context context,
		std::uint64_t seed, double min_confidence = 0.0) {
	Performance hand(models, context, kind.movements.at(seed), seed);
	kind.perform(hand, hand.draws());
	const std::vector<HandFrame> frames =
			PlainTracker(tracker_traits(tracker, seed), seed).watch(hand.plan());
	std::vector<GestureEvent> events = follow(hand.gestures(), frames, hand.now_s(), min_confidence);
	std::set<std::string> faults = Verdict(hand.expected(), events, tracker == TrackerKind::BAD).faults();
	return { std::move(hand), std::move(events), std::move(faults) };
}

} // namespace steadyhand::bench
