#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace godot {

/// List of listeners. During a call, listeners may be added or removed, and the list may be destroyed.
template <class Listener> class ListenerList {
	struct Token {};

public:
	/// Detects whether the list, and so the object that owns it, was destroyed. A listener or a signal
	/// handler may free that object.
	class Watch {
	public:
		explicit Watch(const ListenerList &p_list) : token_(p_list.token_) {}
		bool is_destroyed() const { return token_.expired(); }

	private:
		std::weak_ptr<Token> token_;
	};

	bool empty() const { return listeners_.empty(); }
	void add(Listener *p_listener) { listeners_.push_back(p_listener); }

	/// The entry becomes null, and is erased after all calls.
	void remove(Listener *p_listener) {
		std::replace(listeners_.begin(), listeners_.end(), p_listener, static_cast<Listener *>(nullptr));
		drop_removed();
	}

	template <class... Arguments, class... Values>
	void call(void (Listener::*p_method)(Arguments...), const Values &...p_values) {
		call_while([] { return true; }, p_method, p_values...);
	}

	/// Calls the listeners while p_continue() is true.
	template <class Predicate, class... Arguments, class... Values>
	void call_while(const Predicate &p_continue, void (Listener::*p_method)(Arguments...),
			const Values &...p_values) {
		const Watch watch(*this);
		++calls_;
		for (std::size_t i = 0; !watch.is_destroyed() && i < listeners_.size() && p_continue(); ++i) {
			if (listeners_[i] != nullptr) {
				(listeners_[i]->*p_method)(p_values...);
			}
		}
		if (!watch.is_destroyed()) {
			--calls_;
			drop_removed();
		}
	}

private:
	std::vector<Listener *> listeners_;
	std::shared_ptr<Token> token_ = std::make_shared<Token>();
	int calls_ = 0; ///< depth of nested calls

	void drop_removed() {
		if (calls_ == 0) {
			std::erase(listeners_, nullptr);
		}
	}
};

/// Moves p_listener from r_listened_to to p_source; either may be null. False if they are the same.
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
