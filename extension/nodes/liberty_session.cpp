#include "liberty_session.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace steadyhand {

namespace {

using Then = LibertyStep::Then;

/// s. Longest wait for bytes. The thread has other work in between.
constexpr double READ_S = 0.02;

/// s. A streaming tracker sends more often, unless it has lost its power or all sensors.
constexpr double NO_DATA_MAX_S = 2.0;

/// s. A fault may be in each record. More frequent warnings would not be read.
constexpr double REPEAT_S = 5.0;

constexpr std::string_view PREFIX = "Liberty: ";

std::string station_list(std::uint32_t stations) {
	std::string list;
	for (int station = 1; station <= LIBERTY_STATION_COUNT; ++station) {
		if ((stations >> (station - 1) & 1U) != 0) {
			list += (list.empty() ? "" : ", ") + std::to_string(station);
		}
	}
	return list;
}

std::string station_name(const LibertyRecord &record) {
	return "Liberty station " + std::to_string(record.station) + ": ";
}

} // namespace

LibertySession::LibertySession(const LibusbLibrary &library, const LibertySettings &settings,
		const std::atomic<bool> &is_stopping, Emit emit) :
		settings_(settings),
		is_stopping_(is_stopping), emit_(std::move(emit)),
		usb_(library, [this](std::span<const std::uint8_t> bytes, double host_s) { receive(bytes, host_s); }),
		clock_(settings.rate_hz) {
	reported_s_.fill(-std::numeric_limits<double>::infinity());
}

LibertySession::End LibertySession::run() {
	End end;
	const std::vector<LibertyStep> steps = liberty_start_steps(settings_);
	step_ = &steps.front(); // data before the first step is ignored
	if (const std::optional<Error> error = usb_.open(end.is_absent)) {
		end.failure = error->message;
		return end;
	}
	for (const LibertyStep &step : steps) {
		if (is_stopping_) {
			break;
		}
		step_ = &step;
		if (const std::optional<Error> error = take(step)) {
			end.failure = error->message;
			break;
		}
	}
	step_ = nullptr;
	if (end.failure.empty()) {
		stream(end);
	}
	if (!usb_.is_lost()) {
		for (const LibertyStep &step : liberty_stop_steps()) {
			step_ = &step;
			static_cast<void>(take(step));
		}
	}
	usb_.close();
	return end;
}

/// Writes a step's bytes and waits for its condition.
std::optional<Error> LibertySession::take(const LibertyStep &step) {
	const double start_s = steady_now_s(), deadline_s = start_s + step.timeout_s;
	double sent_s = start_s;
	bool is_met_now = false, is_over = false;
	if (step.then == Then::STREAM && stations_ == 0U) {
		connect(start_s); // records follow when a sensor is plugged in
		is_met_now = true;
	}
	usb_.write(step.bytes);
	while (!is_met_now && !is_over && !usb_.is_lost()) {
		usb_.read(READ_S);
		const double now_s = steady_now_s();
		is_met_now = is_met(step, start_s);
		is_over = now_s >= deadline_s || (is_stopping_ && step.then != Then::DISCARD);
		if (step.then == Then::STATION_MAP && !is_met_now && !is_over && now_s - sent_s >= step.quiet_s) {
			usb_.write(step.bytes);
			sent_s = now_s;
		}
	}
	if (step.then == Then::DISCARD) {
		parser_.clear();
	}
	const bool must_be_met = step.then == Then::STATION_MAP || step.then == Then::STREAM;
	if (is_stopping_ || (!usb_.is_lost() && (is_met_now || !must_be_met))) {
		return std::nullopt;
	}
	const std::string aim(step.aim);
	return Error{ usb_.is_lost() ? "Liberty: cannot " + aim +
						": the connection was lost. Check the USB cable and the power of the tracker."
								 : "Liberty: cannot " + aim +
						": the tracker does not answer. Switch it off and on and wait 10 s." };
}

bool LibertySession::is_met(const LibertyStep &step, double since_s) const {
	switch (step.then) {
		case Then::DISCARD:
		case Then::CHECK:
			return steady_now_s() - std::max(since_s, received_s_) >= step.quiet_s;
		case Then::STATION_MAP:
			return stations_.has_value();
		case Then::STREAM:
			return has_record_;
	}
	return false;
}

/// Receives until the tracker is lost or the thread must stop.
void LibertySession::stream(End &r_end) {
	while (!is_stopping_ && !usb_.is_lost()) {
		usb_.read(READ_S);
		if (has_record_ && steady_now_s() - received_s_ > NO_DATA_MAX_S) {
			r_end.failure =
					"Liberty: the tracker has stopped sending. Check its power and its sensors; the stream "
					"goes on once they are back.";
			break;
		}
	}
	r_end.was_streaming = is_connected_;
	if (usb_.is_lost()) {
		r_end.failure =
				"Liberty: the connection was lost. Check the USB cable and the power of the tracker; the "
				"stream goes on once it is back.";
	}
	if (!r_end.failure.empty()) {
		report(Kind::FAILURE, r_end.failure, steady_now_s());
	}
}

void LibertySession::receive(std::span<const std::uint8_t> bytes, double host_s) {
	if (bytes.empty()) {
		return;
	}
	received_s_ = host_s;
	parser_.feed(bytes);
	LibertyMessage message;
	while (parser_.next(message)) {
		handle(message, host_s);
	}
}

void LibertySession::handle(const LibertyMessage &message, double host_s) {
	if (step_ != nullptr && step_->then == Then::DISCARD) {
		return;
	}
	const bool is_streaming = step_ == nullptr || step_->then == Then::STREAM;
	const std::string text = liberty_message_text(message);
	switch (message.kind) {
		case LibertyMessage::Kind::RECORD:
			if (is_streaming) {
				handle_record(message.record, host_s);
			}
			break;
		case LibertyMessage::Kind::STATION_MAP:
			stations_ = message.stations;
			break;
		case LibertyMessage::Kind::WRONG_RECORD:
			if (is_streaming) {
				report_rarely(SIZES, Kind::WARNING, text, host_s);
			}
			break;
		case LibertyMessage::Kind::REFUSAL:
			if (step_ != nullptr) {
				std::string what(PREFIX);
				what.append("cannot ").append(step_->aim).append(": ").append(text, PREFIX.size());
				report(Kind::WARNING, std::move(what), host_s);
			} else {
				report_rarely(REFUSALS, Kind::WARNING, text, host_s);
			}
			break;
		case LibertyMessage::Kind::TEXT:
			report_rarely(TEXTS, Kind::NOTE, text, host_s);
			break;
	}
}

void LibertySession::handle_record(const LibertyRecord &record, double host_s) {
	connect(host_s);
	has_record_ = true;
	LibertyEvent event;
	event.kind = Kind::RECORD;
	event.host_time_s = host_s;
	event.record = record;
	const LibertyClock::Answer time = clock_.update(record.frame_count, host_s);
	if (time.is_new_frame) {
		lost_frames_ = time.lost;
	}
	event.device_time_s = time.time_s;
	event.lost_frames = lost_frames_;
	if (time.has_restarted) {
		report(Kind::WARNING, "Liberty: the tracker restarted its clock. Another program may have reset it.",
				host_s);
	}
	if (time.has_rate_fault) {
		report(Kind::WARNING, clock_.rate_fault_text(), host_s);
	}
	if (record.is_tracked) {
		HemisphereGuard &guard = guards_[static_cast<std::size_t>(record.station - 1)];
		const HemisphereGuard::Answer answer = guard.update(record.position_m, time.time_s);
		event.is_mirrored = answer.is_mirrored;
		if (answer.is_mirrored && settings_.mirror_flips) {
			event.record.position_m = answer.position_m;
			event.record.source_position_m = -record.source_position_m;
		}
		if (answer.has_flipped && answer.is_mirrored) {
			report_rarely(FLIPS, Kind::WARNING,
					station_name(record) +
							"the sensor left the hemisphere of the source. Place the source so that all "
							"sensors "
							"stay on one side of it.",
					host_s);
		}
	}
	if (record.fault != '\0') {
		report_rarely(FAULTS, Kind::WARNING,
				station_name(record) +
						std::string(liberty_error_text(static_cast<std::uint8_t>(record.fault))) +
						". Switch the tracker off and on if this stays.",
				host_s);
	}
	emit_(std::move(event));
}

/// Emits CONNECTED, the first time.
void LibertySession::connect(double host_s) {
	if (is_connected_) {
		return;
	}
	is_connected_ = true;
	LibertyEvent event;
	event.kind = Kind::CONNECTED;
	event.host_time_s = host_s;
	event.stations = stations_.value_or(0);
	event.text = "Liberty: " + std::to_string(settings_.rate_hz) + " Hz, stations " +
			station_list(event.stations) + ".";
	if (event.stations == 0) {
		event.text = "Liberty: connected, but no sensor is plugged in.";
	}
	emit_(std::move(event));
	if (stations_ == 0U) {
		report(Kind::WARNING, "Liberty: no sensor is plugged in. Plug one into the front of the tracker.",
				host_s);
	}
}

void LibertySession::report(Kind kind, std::string text, double host_s) {
	LibertyEvent event;
	event.kind = kind;
	event.host_time_s = host_s;
	event.text = std::move(text);
	emit_(std::move(event));
}

void LibertySession::report_rarely(Topic topic, Kind kind, std::string text, double host_s) {
	if (host_s - reported_s_[topic] >= REPEAT_S) {
		reported_s_[topic] = host_s;
		report(kind, std::move(text), host_s);
	}
}

} // namespace steadyhand
