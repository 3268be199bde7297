#pragma once

#include "base/parameters.h"

#include <cmath>

namespace steadyhand {

/// When a hand was seen, and when about the way of its task.
class HandPresence {
public:
	void push(double t_s, bool is_on_path) {
		found_s_ = is_recent(t_s) ? found_s_ : t_s;
		last_s_ = t_s;
		on_path_s_ = is_on_path ? t_s : on_path_s_;
	}

	/// Of the newest frame that held what the feature needs; before one, never.
	[[nodiscard]] double last_s() const { return last_s_; }
	[[nodiscard]] bool is_recent(double t_s) const { return t_s - last_s_ <= parameters::sessions::RECENT_S; }
	/// After it had been lost.
	[[nodiscard]] bool is_just_found(double t_s) const {
		return t_s - found_s_ <= parameters::sessions::RECENT_S;
	}
	/// For how long it has been seen elsewhere than about the way.
	[[nodiscard]] double off_path_s() const { return last_s_ - on_path_s_; }

private:
	double last_s_ = INFINITY;
	double found_s_ = -INFINITY;
	double on_path_s_ = -INFINITY;
};

} // namespace steadyhand
