#pragma once

#include "performance.h"
#include "said.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace steadyhand::bench {

/// What was said against what was to be said. Before a tracker that lags, what is early or late, or aborted
/// on its way, is no fault.
class Verdict {
public:
	Verdict(const std::vector<Expected> &expected, const std::vector<Said> &said, bool lags) :
			expected_(expected), was_said_(expected.size(), false), lags_(lags) {
		for (const Said &one : said) {
			if (one.happening == Happening::ENDED) {
				judge_end(one);
			}
		}
		for (std::size_t i = 0; i < expected_.size(); ++i) {
			if (expected_[i].leeway.is_optional) {
				continue;
			}
			if (!was_said_[i]) {
				faults_.insert("missed");
			} else if (!lags_) {
				judge_way(expected_[i], said);
			}
		}
	}

	[[nodiscard]] const std::set<std::string> &faults() const { return faults_; }

private:
	static constexpr double USUAL_LATE_S = 0.2;
	static constexpr double MOST_LAG_S = 0.2;

	const std::vector<Expected> &expected_;
	std::vector<bool> was_said_;
	bool lags_;
	std::set<std::string> faults_;

	/// Not before a quarter of its way.
	[[nodiscard]] bool is_in_time(const Expected &expected, double t_s) const {
		return t_s >= expected.from_s + 0.25 * (expected.to_s - expected.from_s) &&
				t_s <= expected.to_s + expected.leeway.late_s + (lags_ ? MOST_LAG_S : 0.0);
	}

	void judge_end(const Said &end) {
		bool is_another = false, is_said_again = false;
		for (std::size_t i = 0; i < expected_.size(); ++i) {
			if (!is_in_time(expected_[i], end.t_s)) {
				continue;
			}
			if (expected_[i].gesture != end.gesture) {
				is_another = true;
			} else if (was_said_[i]) {
				is_said_again = true;
			} else {
				was_said_[i] = true;
				judge_time(expected_[i], end.t_s);
				return;
			}
		}
		faults_.insert(is_said_again ? "twice" : is_another ? "wrong" : "extra");
	}

	/// In 0.58 of its duration a stroke goes two thirds of its way.
	void judge_time(const Expected &expected, double t_s) {
		if (!lags_ && t_s < expected.to_s - 0.42 * (expected.to_s - expected.from_s) - 0.05) {
			faults_.insert("early");
		}
		const bool may_be_later = expected.leeway.late_s > Leeway().late_s;
		if (!lags_ && !may_be_later && t_s > expected.to_s + USUAL_LATE_S) {
			faults_.insert("late");
		}
	}

	void judge_way(const Expected &expected, const std::vector<Said> &said) {
		for (const Said &one : said) {
			if (one.happening == Happening::ABORTED && one.gesture == expected.gesture &&
					one.t_s > expected.from_s && one.t_s < expected.to_s) {
				faults_.insert("aborted on its way");
			}
		}
	}
};

} // namespace steadyhand::bench
