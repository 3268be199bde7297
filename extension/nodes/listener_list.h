#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace godot {

/// Listeners that may come and go while they are being called.
template <class Listener> class ListenerList {
public:
	bool empty() const { return listeners_.empty(); }
	void add(Listener *p_listener) { listeners_.push_back(p_listener); }

	/// The place is kept until nothing is being called any more.
	void remove(Listener *p_listener) {
		std::replace(listeners_.begin(), listeners_.end(), p_listener, static_cast<Listener *>(nullptr));
		drop_removed();
	}

	template <class... Arguments, class... Values>
	void call(void (Listener::*p_method)(Arguments...), const Values &...p_values) {
		++calls_;
		for (std::size_t i = 0; i < listeners_.size(); ++i) {
			if (listeners_[i] != nullptr) {
				(listeners_[i]->*p_method)(p_values...);
			}
		}
		--calls_;
		drop_removed();
	}

private:
	std::vector<Listener *> listeners_;
	int calls_ = 0; ///< nested: a listener may make the caller call again

	void drop_removed() {
		if (calls_ == 0) {
			std::erase(listeners_, nullptr);
		}
	}
};

/// Leaves what was listened to so far for another; either may be null. False where that is the same.
template <class Source, class Listener>
bool listen_to(Source *p_source, Source *&r_listened_to, Listener *p_listener) {
	if (r_listened_to == p_source) {
		return false;
	}
	if (r_listened_to != nullptr) {
		r_listened_to->remove_listener(p_listener);
	}
	r_listened_to = p_source;
	if (r_listened_to != nullptr) {
		r_listened_to->add_listener(p_listener);
	}
	return true;
}

} // namespace godot
