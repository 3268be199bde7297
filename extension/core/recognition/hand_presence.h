#pragma once

#include "base/parameters.h"

#include <cmath>

namespace steadyhand {

/// Times at which the hand was tracked, and was near the path of its task.
class HandPresence {
public:
	void push(double t_s, bool is_on_path) {
		found_s_ = is_recent(t_s) ? found_s_ : t_s;
		last_s_ = t_s;
		on_path_s_ = is_on_path ? t_s : on_path_s_;
	}

	/// Time of the newest frame with a value of the feature; infinite before the first one.
	[[nodiscard]] double last_s() const { return last_s_; }
	[[nodiscard]] bool is_recent(double t_s) const { return t_s - last_s_ <= parameters::sessions::RECENT_S; }
	/// A dropout has just ended.
	[[nodiscard]] bool is_just_found(double t_s) const {
		return t_s - found_s_ <= parameters::sessions::RECENT_S;
	}
	/// Time for which the tracked hand has been away from the path.
	[[nodiscard]] double off_path_s() const { return last_s_ - on_path_s_; }

private:
	double last_s_ = INFINITY;
	double found_s_ = -INFINITY;
	double on_path_s_ = -INFINITY;
};

} // namespace steadyhand
