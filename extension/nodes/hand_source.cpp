#include "hand_source.h"

#include <godot_cpp/core/class_db.hpp>

#include <optional>

namespace godot {

namespace {

/// Frames that a script pushes, at any time or in the source's _poll().
class ScriptStream : public HandStream {
public:
	ScriptStream(const Ref<HandSource> &p_source, HandTracker &p_tracker) :
			source_(p_source), tracker_(p_tracker) {}

	~ScriptStream() override {
		if (is_open_) {
			source_->GDVIRTUAL_CALL(_stop, &tracker_);
		}
	}

	String open() override {
		String fault;
		source_->GDVIRTUAL_CALL(_start, &tracker_, fault);
		is_open_ = fault.is_empty();
		if (is_open_) {
			announce(StreamEvent::Kind::READY);
		}
		return fault;
	}
	StreamClock clock() const override { return StreamClock::FRAMES; }
	bool is_polled() const override { return source_->GDVIRTUAL_IS_OVERRIDDEN(_poll); }
	void poll(double p_now_s) override {
		const Ref<HandSource> source = source_; // the script may stop the tracker
		source->GDVIRTUAL_CALL(_poll, &tracker_, p_now_s);
	}
	bool accept(const steadyhand::DeviceFrame &p_frame) override {
		pushed_ = p_frame;
		return true;
	}
	bool next(double p_until_s, steadyhand::DeviceFrame &r_frame) override {
		if (!pushed_ || pushed_->hand.t_s > p_until_s) {
			return false;
		}
		r_frame = *pushed_;
		pushed_.reset();
		return true;
	}

private:
	Ref<HandSource> source_;
	HandTracker &tracker_;
	bool is_open_ = false;
	std::optional<steadyhand::DeviceFrame> pushed_;
};

} // namespace

std::unique_ptr<HandStream> HandSource::make_stream(HandTracker &p_tracker) {
	return std::make_unique<ScriptStream>(Ref<HandSource>(this), p_tracker);
}

String HandSource::no_frame_advice() const {
	return "Call push_frame() of the HandTracker with each frame of the device";
}

void HandSource::_bind_methods() {
	GDVIRTUAL_BIND(_start, "tracker");
	GDVIRTUAL_BIND(_poll, "tracker", "time_s");
	GDVIRTUAL_BIND(_stop, "tracker");
}

} // namespace godot
