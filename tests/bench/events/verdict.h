#pragma once

#include "gesture_events.h"
#include "performance.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace steadyhand::bench {

/// Compares events with the expected gestures. With a lagging tracker, early ends, late ends and aborts are
/// no faults.
class Verdict {
public:
	Verdict(const std::vector<Expected> &expected, const std::vector<GestureEvent> &events, bool lags) :
			expected_(expected), was_found_(expected.size(), false), lags_(lags) {
		for (const GestureEvent &one : events) {
			if (one.kind == EventKind::ENDED) {
				judge_end(one);
			}
		}
		for (std::size_t i = 0; i < expected_.size(); ++i) {
			if (expected_[i].leeway.is_optional) {
				continue;
			}
			if (!was_found_[i]) {
				faults_.insert("missed");
			} else if (!lags_) {
				judge_aborts(expected_[i], events);
			}
		}
	}

	[[nodiscard]] const std::set<std::string> &faults() const { return faults_; }

private:
	static constexpr double USUAL_LATE_S = 0.2;
	static constexpr double MOST_LAG_S = 0.2;

	const std::vector<Expected> &expected_;
	std::vector<bool> was_found_;
	bool lags_;
	std::set<std::string> faults_;

	/// Whether an end at t_s belongs to the gesture: not before a quarter of its duration.
	[[nodiscard]] bool is_in_time(const Expected &expected, double t_s) const {
		return t_s >= expected.from_s + 0.25 * (expected.to_s - expected.from_s) &&
				t_s <= expected.to_s + expected.leeway.late_s + (lags_ ? MOST_LAG_S : 0.0);
	}

	void judge_end(const GestureEvent &end) {
		bool is_another = false, is_duplicate = false;
		for (std::size_t i = 0; i < expected_.size(); ++i) {
			if (!is_in_time(expected_[i], end.t_s)) {
				continue;
			}
			if (expected_[i].gesture != end.gesture) {
				is_another = true;
			} else if (was_found_[i]) {
				is_duplicate = true;
			} else {
				was_found_[i] = true;
				judge_time(expected_[i], end.t_s);
				return;
			}
		}
		faults_.insert(is_duplicate ? "twice" : is_another ? "wrong" : "extra");
	}

	/// An end is early before 58 % of the duration, at two thirds of the amplitude.
	void judge_time(const Expected &expected, double t_s) {
		if (!lags_ && t_s < expected.to_s - 0.42 * (expected.to_s - expected.from_s) - 0.05) {
			faults_.insert("early");
		}
		const bool may_be_later = expected.leeway.late_s > Leeway().late_s;
		if (!lags_ && !may_be_later && t_s > expected.to_s + USUAL_LATE_S) {
			faults_.insert("late");
		}
	}

	void judge_aborts(const Expected &expected, const std::vector<GestureEvent> &events) {
		for (const GestureEvent &one : events) {
			if (one.kind == EventKind::ABORTED && one.gesture == expected.gesture &&
					one.t_s > expected.from_s && one.t_s < expected.to_s) {
				faults_.insert("aborted during the gesture");
			}
		}
	}
};

} // namespace steadyhand::bench
