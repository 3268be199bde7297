#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace godot {

/// Listeners that may come and go while they are being called, and so may the list.
template <class Listener> class ListenerList {
	struct Life {};

public:
	/// Tells whether the list has been destroyed since, and with it the object that it is a member of: what
	/// is called or told may free that object.
	class Watch {
	public:
		explicit Watch(const ListenerList &p_list) : life_(p_list.life_) {}
		bool is_gone() const { return life_.expired(); }

	private:
		std::weak_ptr<Life> life_;
	};

	bool empty() const { return listeners_.empty(); }
	void add(Listener *p_listener) { listeners_.push_back(p_listener); }

	/// The place is kept until nothing is being called any more.
	void remove(Listener *p_listener) {
		std::replace(listeners_.begin(), listeners_.end(), p_listener, static_cast<Listener *>(nullptr));
		drop_removed();
	}

	template <class... Arguments, class... Values>
	void call(void (Listener::*p_method)(Arguments...), const Values &...p_values) {
		call_while([] { return true; }, p_method, p_values...);
	}

	/// As long as p_goes_on() says so, which is asked before each.
	template <class Predicate, class... Arguments, class... Values>
	void call_while(
			const Predicate &p_goes_on, void (Listener::*p_method)(Arguments...), const Values &...p_values) {
		const Watch watch(*this);
		++calls_;
		for (std::size_t i = 0; !watch.is_gone() && i < listeners_.size() && p_goes_on(); ++i) {
			if (listeners_[i] != nullptr) {
				(listeners_[i]->*p_method)(p_values...);
			}
		}
		if (!watch.is_gone()) {
			--calls_;
			drop_removed();
		}
	}

private:
	std::vector<Listener *> listeners_;
	std::shared_ptr<Life> life_ = std::make_shared<Life>();
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
