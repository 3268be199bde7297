#include "haptic_synth.h"

#include "conversions.h"
#include "gesture_hmm.h"
#include "gesture_task.h"
#include "listener_list.h"
#include "node_label.h"
#include "parent_as.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace godot {

namespace {

/// Prediction that live sinks get, beyond the latency of the output: longer than a frame of a slow game plus
/// an audio mix.
constexpr std::size_t AHEAD_KNOTS = 13;
constexpr double AHEAD_PERIOD_S = 0.01;
/// The buffer is dropped if no script has called get_buffer() for this time.
constexpr double BUFFER_KEPT_S = 10.0;
/// Scripts have set the outputs within this time.
constexpr double SETTLING_S = 1.0;

steadyhand::MotionSnapshot::Knot knot_of(const MotionInstant &p_motion) {
	return { .position = p_motion.position,
		.velocity = p_motion.velocity,
		.acceleration = p_motion.acceleration,
		.correction = p_motion.correction };
}

} // namespace

HapticSynth::~HapticSynth() {
	if (gesture_hmm_ != nullptr) {
		gesture_hmm_->remove_listener(this);
	}
}

template <class Function> void HapticSynth::for_each_sink(Function p_function) const {
	for (HapticSink *const sink :
			{ static_cast<HapticSink *>(bus_sink_.get()), static_cast<HapticSink *>(controller_pulses_.get()),
					static_cast<HapticSink *>(joypad_pulses_.get()), static_cast<HapticSink *>(buffer_.get()),
					static_cast<HapticSink *>(wav_.get()) }) {
		if (sink != nullptr) {
			p_function(*sink);
		}
	}
}

void HapticSynth::add_sink(HapticSink &p_sink) {
	if (effects_are_set_) {
		p_sink.set_effects(core_effects_);
	}
}

void HapticSynth::on_motion_ended() {
	arrivals_.restart();
	strength_ = {};
	effects_are_set_ = false;
	played_s_ = buffer_kept_s_ = NOT_SET;
	for_each_sink([](HapticSink &sink) { sink.restart(); });
}

void HapticSynth::on_motion(const MotionInstant &p_motion) {
	if (effects_.is_empty() && expected_gesture() != default_gesture_) {
		effects_are_set_ = false;
	}
	if (!effects_are_set_) {
		build_effects();
	}
	if (is_wav_pending_) {
		open_wav();
	}
	steadyhand::MotionSnapshot::Knot knot = knot_of(p_motion);
	arrivals_.push(p_motion.time_s, knot, p_motion.gesture, p_motion.amplitude_m, p_motion.has_ended);
	knot.moving = arrivals_.is_moving();
	strength_ = steadyhand::strength_of(core_effects_, p_motion.time_s,
			{ knot.position, knot.velocity, knot.acceleration, 0.0, knot.correction, 0.0 }, knot.moving,
			p_motion.amplitude_m, arrivals_.last(), arrivals_.onset());
	has_vibrated_ = has_vibrated_ || strength_.amplitude > 0.0;
	for_each_sink([&](HapticSink &sink) {
		sink.advance(p_motion.time_s, knot, p_motion.amplitude_m, arrivals_.last(), arrivals_.onset());
	});
}

void HapticSynth::on_motion_known() {
	if (is_inside_tree()) {
		check_audio();
	}
	// At an Engine.time_scale of 0 frames continue, but the motion does not.
	if (gesture_hmm_->get_time() == played_s_) {
		return;
	}
	played_s_ = gesture_hmm_->get_time();
	if (std::isnan(buffer_kept_s_)) {
		buffer_kept_s_ = played_s_ + BUFFER_KEPT_S;
	} else if (played_s_ > buffer_kept_s_) {
		buffer_.reset();
	}
	bool any_live = false;
	for_each_sink([&](const HapticSink &sink) { any_live = any_live || sink.is_live(); });
	if (!any_live) {
		return;
	}
	const steadyhand::LiveMotion motion = live_motion();
	for_each_sink([&](HapticSink &sink) { sink.play(motion); });
}

steadyhand::LiveMotion HapticSynth::live_motion() const {
	steadyhand::LiveMotion motion;
	steadyhand::MotionSnapshot &snapshot = motion.snapshot;
	const double now_s = gesture_hmm_->get_time();
	snapshot.time_s = now_s;
	snapshot.period_s = AHEAD_PERIOD_S;
	const double output_s = bus_sink_ ? bus_sink_->output_latency_s : 0.0;
	const double device_s = device_.is_valid() ? device_->get_latency() : 0.0;
	constexpr auto MOST = steadyhand::MotionSnapshot::MOST_KNOTS;
	const double late = std::ceil((output_s + device_s) / AHEAD_PERIOD_S);
	snapshot.count = late < MOST ? std::min(AHEAD_KNOTS + static_cast<std::size_t>(late), MOST) : MOST;
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		const MotionInstant instant =
				gesture_hmm_->motion_at(now_s + AHEAD_PERIOD_S * static_cast<double>(i));
		snapshot.amplitude_m = instant.amplitude_m;
		snapshot.knots[i] = knot_of(instant);
	}
	snapshot.arrival = arrivals_.last();
	snapshot.onset = arrivals_.onset();
	snapshot.expected = arrivals_.expected(snapshot, now_s);
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		const double time_s = now_s + AHEAD_PERIOD_S * static_cast<double>(i);
		snapshot.knots[i].moving =
				arrivals_.is_moving() && (snapshot.expected.number == 0 || time_s < snapshot.expected.time_s);
	}
	snapshot.fit();
	// The motion is sent once a frame, and is half a frame old on average when it is rendered.
	const double age_s = is_inside_tree() ? 0.5 * get_process_delta_time() : 0.0;
	motion.heard_s = std::min(now_s + age_s + device_s, snapshot.end_s());
	return motion;
}

void HapticSynth::on_motion_freed() {
	gesture_hmm_ = nullptr;
	follows_parent_ = false;
	on_motion_ended();
	update_configuration_warnings();
}

void HapticSynth::set_gesture_hmm(GestureHMM *p_gesture_hmm) {
	follows_parent_ = false;
	if (listen_to(p_gesture_hmm, gesture_hmm_, this)) {
		on_motion_ended();
		update_configuration_warnings();
	}
}

void HapticSynth::follow_parent() {
	GestureHMM *const parent = parent_as<GestureHMM>(*this);
	if (gesture_hmm_ == nullptr && parent != nullptr) {
		set_gesture_hmm(parent);
		follows_parent_ = true;
	}
}

StringName HapticSynth::expected_gesture() const {
	StringName active = gesture_hmm_->get_gesture();
	if (active != StringName()) {
		return active;
	}
	const GestureTask *const task = gesture_hmm_->get_task();
	const StringName wanted = task != nullptr ? task->get_gesture() : StringName();
	return wanted != StringName() ? wanted : default_gesture_;
}

void HapticSynth::build_effects() {
	effects_are_set_ = true;
	const std::uint64_t generation = core_effects_.generation + 1;
	steadyhand::EffectSet wanted;
	HapticEffect::Tables tables;
	if (effects_.is_empty()) {
		default_gesture_ = expected_gesture();
		wanted = steadyhand::effects_of_gesture(to_core(String(default_gesture_)));
	}
	for (int64_t i = 0; i < effects_.size(); ++i) {
		const Ref<HapticEffect> effect = effects_[i];
		if (effect.is_valid()) {
			wanted.add(effect->to_core(tables));
		} else if (!std::exchange(has_warned_of_null_, true)) {
			WARN_PRINT(node_label(*this) + String(": \"effects\"[") + itos(i) +
					String("] is null and plays nothing. Remove it, or set it to a HapticEffect"));
		}
	}
	core_effects_ = {};
	core_effects_.generation = generation;
	for (std::size_t i = 0; i < wanted.count; ++i) {
		steadyhand::Effect effect = wanted.effects[i];
		effect.gain *= gain_;
		core_effects_.add(device_.is_valid() ? steadyhand::adapted(effect, device_->core()) : effect);
	}
	tables_->push_back({ generation, std::move(tables) });
	for_each_sink([this](HapticSink &sink) { sink.set_effects(core_effects_); });
	drop_old_tables();
}

void HapticSynth::drop_old_tables() {
	std::uint64_t oldest = core_effects_.generation;
	for_each_sink([&](const HapticSink &sink) { oldest = std::min(oldest, sink.oldest_generation()); });
	while (tables_->size() > 1 && (*tables_)[1].generation <= oldest) {
		tables_->pop_front();
	}
}

void HapticSynth::connect_changed(Object *p_object, bool p_connect) {
	const Callable callable = callable_mp(this, &HapticSynth::on_effects_changed);
	if (p_object == nullptr || p_object->is_connected("changed", callable) == p_connect) {
		return; // an effect may be in the list twice
	}
	if (p_connect) {
		p_object->connect("changed", callable);
	} else {
		p_object->disconnect("changed", callable);
	}
}

void HapticSynth::connect_effects(bool p_connect) {
	for (int64_t i = 0; i < effects_.size(); ++i) {
		connect_changed(effects_[i], p_connect);
	}
}

void HapticSynth::set_effects(const TypedArray<HapticEffect> &p_effects) {
	connect_effects(false);
	effects_ = p_effects.duplicate();
	has_warned_of_null_ = false;
	if (effects_.size() > static_cast<int64_t>(steadyhand::EffectSet::MOST)) {
		WARN_PRINT(node_label(*this) + String(": only the first ") + itos(steadyhand::EffectSet::MOST) +
				String(" of ") + itos(effects_.size()) +
				String(" effects are played. Remove some of \"effects\""));
	}
	connect_effects(true);
	on_effects_changed();
}

void HapticSynth::on_effects_changed() {
	effects_are_set_ = false;
	update_configuration_warnings();
}

void HapticSynth::set_gain(double p_gain) {
	ERR_FAIL_COND_MSG(
			std::isnan(p_gain) || p_gain < 0.0 || p_gain > 1.0, refusal(*this, "gain must be 0..1", p_gain));
	gain_ = p_gain;
	on_effects_changed();
}

void HapticSynth::set_arrival_level(double p_level) {
	ERR_FAIL_COND_MSG(!(p_level > 0.5) || !(p_level <= 1.0),
			refusal(*this, "arrival_level must be above 0.5 and at most 1", p_level));
	arrivals_.set_level(p_level);
}

void HapticSynth::set_device(const Ref<HapticDeviceProfile> &p_device) {
	connect_changed(device_.ptr(), false);
	device_ = p_device;
	connect_changed(device_.ptr(), true);
	on_effects_changed();
}

void HapticSynth::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		if (!Engine::get_singleton()->is_editor_hint()) {
			follow_parent();
		}
		update_player();
		update_pulses();
		listen_to_buses(true);
		listen_to_joypads(true);
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		listen_to_joypads(false);
		listen_to_buses(false);
		drop_pulses();
		// A restarted player makes a new reader, which would not get the effects.
		if (player_ != nullptr) {
			drop_player();
		}
		if (follows_parent_) {
			set_gesture_hmm(nullptr);
		}
	} else if (p_what == NOTIFICATION_READY) {
		// As GestureHMM does for its tracker.
		set_process_internal(!Engine::get_singleton()->is_editor_hint());
	} else if (p_what == NOTIFICATION_INTERNAL_PROCESS) {
		warn_of_no_output();
	} else if (p_what == NOTIFICATION_PAUSED || p_what == NOTIFICATION_UNPAUSED) {
		pause_pulses(p_what == NOTIFICATION_PAUSED);
	}
}

double HapticSynth::get_amplitude() const {
	is_read_ = true;
	return strength_.amplitude;
}

/// Warns once of a missing GestureHMM, in the first frame. Warns once of a missing output, but only after the
/// first vibration, because a script may set an output later.
void HapticSynth::warn_of_no_output() {
	if (ready_for_s_ == 0.0 && gesture_hmm_ == nullptr) {
		WARN_PRINT(node_label(*this) +
				": nothing is felt. Set its \"gesture_hmm\", or make it a child of a GestureHMM");
	}
	ready_for_s_ += std::max(get_process_delta_time(), std::numeric_limits<double>::min());
	const bool is_used = has_output() || is_read_;
	if (is_used || (has_vibrated_ && ready_for_s_ > SETTLING_S)) {
		set_process_internal(false);
		if (!is_used) {
			WARN_PRINT(node_label(*this) +
					": nothing is felt. Set its \"bus\", \"controller\", \"joypad\" or \"wav_path\", or read "
					"get_buffer() in a script");
		}
	}
}

} // namespace godot
