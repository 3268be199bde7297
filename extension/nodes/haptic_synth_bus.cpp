// HapticSynth's output to an audio bus.

#include "haptic_synth.h"

#include "node_label.h"

#include <godot_cpp/classes/audio_server.hpp>
#include <godot_cpp/classes/audio_stream_player.hpp>
#include <godot_cpp/classes/engine.hpp>

#include <deque>
#include <memory>

namespace godot {

void HapticSynth::set_bus(const StringName &p_bus) {
	bus_ = p_bus;
	if (is_inside_tree()) {
		update_player();
	}
	update_configuration_warnings();
}

bool HapticSynth::bus_exists() const {
	return bus_ != StringName() && AudioServer::get_singleton()->get_bus_index(bus_) >= 0;
}

void HapticSynth::listen_to_buses(bool p_listen) {
	AudioServer *const server = AudioServer::get_singleton();
	const Callable layout = callable_mp(this, &HapticSynth::on_buses_changed);
	const Callable name = callable_mp(this, &HapticSynth::on_bus_renamed);
	if (p_listen) {
		server->connect("bus_layout_changed", layout);
		server->connect("bus_renamed", name);
	} else {
		server->disconnect("bus_layout_changed", layout);
		server->disconnect("bus_renamed", name);
	}
}

/// AudioServer emits no signal for set_bus_layout(), nor for a changed mix rate.
void HapticSynth::check_audio() {
	if (player_ != nullptr && AudioServer::get_singleton()->get_mix_rate() != mix_rate_hz_) {
		drop_player();
	}
	if ((player_ != nullptr) != bus_exists()) {
		on_buses_changed();
	}
}

void HapticSynth::on_buses_changed() {
	// A bus that is still missing was already reported.
	if (player_ != nullptr || bus_exists()) {
		update_player();
	}
	update_configuration_warnings();
}

void HapticSynth::update_player() {
	if (Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	const bool exists = bus_exists();
	if (bus_ != StringName() && !exists) {
		// The engine would play on the Master bus, which the player hears.
		ERR_PRINT(node_label(*this) + String(": there is no audio bus '") + String(bus_) +
				String("', so nothing is played. Add it in the Audio panel, or set another \"bus\""));
	}
	if (player_ != nullptr && (!exists || player_->get_bus() != bus_)) {
		drop_player();
	}
	if (player_ == nullptr && exists) {
		make_player();
	}
}

void HapticSynth::make_player() {
	bus_sink_ = std::make_unique<BusSink>();
	bus_sink_->link()->tables = tables_;
	add_sink(*bus_sink_);
	mix_rate_hz_ = AudioServer::get_singleton()->get_mix_rate();
	bus_sink_->output_latency_s = AudioServer::get_singleton()->get_output_latency();
	Ref<HapticStream> stream;
	stream.instantiate();
	stream->follow(bus_sink_->link());
	player_ = memnew(AudioStreamPlayer);
	player_->set_stream(stream);
	player_->set_autoplay(true);
	player_->set_bus(bus_);
	add_child(player_, false, INTERNAL_MODE_FRONT);
}

/// For another bus a new player is made. The engine fades out the old player, and the new one starts without
/// a click. A player that changes its bus would click.
void HapticSynth::drop_player() {
	player_->set_autoplay(false); // the parent may be about to enter the tree
	player_->stop();
	HapticStreamPlayback::note_stop();
	player_->queue_free();
	player_ = nullptr;
	bus_sink_.reset();
	// The audio thread may mix once more, so the old tables must not change.
	tables_ = std::make_shared<std::deque<TablesInUse>>(*tables_);
}

} // namespace godot
