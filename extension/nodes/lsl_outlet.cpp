#include "lsl_outlet.h"

#include "conversions.h"
#include "listener_list.h"
#include "node_label.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <array>
#include <limits>
#include <string>

namespace godot {

namespace {

using steadyhand::JOINT_COUNT;
using steadyhand::LslLibrary;

constexpr std::array AXES = { 'x', 'y', 'z' };
/// Each joint's position, then the confidence.
constexpr std::size_t CHANNELS = JOINT_COUNT * AXES.size() + 1;
/// Buffer for slow receivers, s; liblsl's own default.
constexpr int32_t BUFFERED_S = 360;

/// Channels of the XDF format's stream type MoCap. Labels are the columns of a track CSV.
void describe_channels(const LslLibrary &p_lsl, LslLibrary::StreamInfo p_info) {
	const LslLibrary::Xml channels = p_lsl.append_child(p_lsl.get_desc(p_info), "channels");
	const auto add = [&](const std::string &p_label, const std::string &p_type, const char *p_unit) {
		const LslLibrary::Xml channel = p_lsl.append_child(channels, "channel");
		p_lsl.append_child_value(channel, "label", p_label.c_str());
		p_lsl.append_child_value(channel, "type", p_type.c_str());
		p_lsl.append_child_value(channel, "unit", p_unit);
	};
	for (const std::string_view joint : steadyhand::JOINT_NAMES) {
		for (const char axis : AXES) {
			const auto capital = static_cast<char>(axis - 'a' + 'A');
			add(std::string(joint) + '_' + axis, std::string("Position") + capital, "meters");
		}
	}
	add("confidence", "Confidence", "normalized");
}

/// Null if liblsl refuses.
LslLibrary::Outlet make_frame_outlet(const LslLibrary &p_lsl, const String &p_name, const String &p_id) {
	const LslLibrary::StreamInfo info =
			p_lsl.create_streaminfo(to_core(p_name).c_str(), "MoCap", static_cast<int32_t>(CHANNELS),
					LslLibrary::IRREGULAR_RATE, LslLibrary::DOUBLE64, to_core(p_id).c_str());
	if (info == nullptr) {
		return nullptr;
	}
	describe_channels(p_lsl, info);
	const LslLibrary::Outlet outlet = p_lsl.create_outlet(info, 0, BUFFERED_S);
	p_lsl.destroy_streaminfo(info);
	return outlet;
}

/// As make_frame_outlet().
LslLibrary::Outlet make_event_outlet(const LslLibrary &p_lsl, const String &p_name, const String &p_id) {
	const std::string id = p_id.is_empty() ? std::string() : to_core(p_id) + "_events";
	const LslLibrary::StreamInfo info = p_lsl.create_streaminfo((to_core(p_name) + " events").c_str(),
			"Markers", 1, LslLibrary::IRREGULAR_RATE, LslLibrary::STRING, id.c_str());
	if (info == nullptr) {
		return nullptr;
	}
	const LslLibrary::Outlet outlet = p_lsl.create_outlet(info, 0, BUFFERED_S);
	p_lsl.destroy_streaminfo(info);
	return outlet;
}

} // namespace

LslOutlet::~LslOutlet() {
	close();
	listen_to(static_cast<HandTracker *>(nullptr), tracker_, static_cast<FrameListener *>(this));
}

void LslOutlet::set_tracker(HandTracker *p_tracker) {
	if (listen_to(p_tracker, tracker_, static_cast<FrameListener *>(this))) {
		update_configuration_warnings();
	}
}

void LslOutlet::set_stream_name(const String &p_name) {
	ERR_FAIL_COND_MSG(p_name.is_empty(), node_label(*this) + String(": stream_name must not be empty"));
	if (stream_name_ != p_name) {
		stream_name_ = p_name;
		reopen();
	}
}

void LslOutlet::set_source_id(const String &p_id) {
	if (source_id_ != p_id) {
		source_id_ = p_id;
		reopen();
	}
}

void LslOutlet::open() {
	if (Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	std::string why_not;
	lsl_ = LslLibrary::get(why_not);
	if (lsl_ == nullptr) {
		report_failure(to_godot(why_not));
		return;
	}
	frames_ = make_frame_outlet(*lsl_, stream_name_, source_id_);
	events_ = make_event_outlet(*lsl_, stream_name_, source_id_);
	if (frames_ == nullptr || events_ == nullptr) {
		report_failure(String("liblsl cannot make the streams; check the network and lsl_api.cfg."));
		close();
	}
}

void LslOutlet::close() {
	for (LslLibrary::Outlet *outlet : { &frames_, &events_ }) {
		if (*outlet != nullptr) {
			lsl_->destroy_outlet(*outlet);
			*outlet = nullptr;
		}
	}
	lsl_ = nullptr;
}

void LslOutlet::reopen() {
	if (is_active()) {
		close();
		open();
	}
}

void LslOutlet::report_failure(const String &p_what) {
	if (!is_failure_reported_) {
		is_failure_reported_ = true;
		WARN_PRINT(node_label(*this) + String(": ") + p_what);
	}
}

void LslOutlet::push_event(const String &p_text) {
	if (!is_active()) {
		return;
	}
	const double now_s = lsl_->local_clock();
	const std::string text = to_core(p_text);
	const char *sample = text.c_str();
	if (lsl_->push_sample_strtp(events_, &sample, now_s, 1) != 0) {
		report_failure(String("liblsl does not take an event."));
	}
}

void LslOutlet::on_frame(const steadyhand::HandFrame &p_frame) {
	if (!is_active()) {
		return;
	}
	const double now_s = lsl_->local_clock();
	std::array<double, CHANNELS> sample{};
	sample.fill(std::numeric_limits<double>::quiet_NaN());
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		if (p_frame.has(static_cast<steadyhand::Joint>(joint))) {
			for (std::size_t axis = 0; axis < AXES.size(); ++axis) {
				sample[joint * AXES.size() + axis] =
						p_frame.positions_m[joint][static_cast<Eigen::Index>(axis)];
			}
		}
	}
	sample.back() = p_frame.confidence;
	if (lsl_->push_sample_dtp(frames_, sample.data(), now_s, 1) != 0) {
		report_failure(String("liblsl does not take a frame."));
	}
}

void LslOutlet::on_tracker_freed() {
	tracker_ = nullptr;
	update_configuration_warnings();
}

PackedStringArray LslOutlet::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (tracker_ == nullptr) {
		warnings.push_back("Set \"tracker\" to the HandTracker whose frames are sent.");
	}
	return warnings;
}

void LslOutlet::_notification(int p_what) {
	if (p_what == NOTIFICATION_ENTER_TREE) {
		open();
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		close();
	}
}

void LslOutlet::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_tracker", "tracker"), &LslOutlet::set_tracker);
	ClassDB::bind_method(D_METHOD("get_tracker"), &LslOutlet::get_tracker);
	ClassDB::bind_method(D_METHOD("set_stream_name", "name"), &LslOutlet::set_stream_name);
	ClassDB::bind_method(D_METHOD("get_stream_name"), &LslOutlet::get_stream_name);
	ClassDB::bind_method(D_METHOD("set_source_id", "id"), &LslOutlet::set_source_id);
	ClassDB::bind_method(D_METHOD("get_source_id"), &LslOutlet::get_source_id);
	ClassDB::bind_method(D_METHOD("is_active"), &LslOutlet::is_active);
	ClassDB::bind_method(D_METHOD("push_event", "text"), &LslOutlet::push_event);

	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "tracker", PROPERTY_HINT_NODE_TYPE, "HandTracker"),
			"set_tracker", "get_tracker");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "stream_name"), "set_stream_name", "get_stream_name");
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "source_id"), "set_source_id", "get_source_id");
}

} // namespace godot
