#include "liberty_device.h"

#include "base/event_ring.h"
#include "liberty_session.h"
#include "libusb_library.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace steadyhand {

namespace {

/// Slots for events: 1 s of 16 stations at 240 Hz.
constexpr std::size_t EVENT_COUNT = 4096;
/// Slots of these that only texts may use.
constexpr std::size_t TEXT_COUNT = 64;

/// s. Time until the next search for the tracker: short at first, then longer, to keep the load of the bus
/// low.
constexpr double FIRST_RETRY_S = 0.5;
constexpr double LONGEST_RETRY_S = 5.0;

} // namespace

struct LibertyDevice::Thread {
	EventRing<LibertyEvent, EVENT_COUNT> events;
	std::atomic<std::uint64_t> dropped_records = 0;
	std::atomic<bool> is_stopping = false;
	std::mutex mutex; ///< only for `wake`, so that stop() ends a wait at once
	std::condition_variable wake;
	std::thread thread;

	void emit(LibertyEvent &&event) {
		const bool is_record = event.kind == LibertyEvent::Kind::RECORD;
		if (!events.push(std::move(event), is_record ? TEXT_COUNT : 0) && is_record) {
			dropped_records.fetch_add(1, std::memory_order_relaxed);
		}
	}

	void fail(std::string text) {
		LibertyEvent event;
		event.kind = LibertyEvent::Kind::FAILURE;
		event.host_time_s = steady_now_s();
		event.text = std::move(text);
		emit(std::move(event));
	}

	void run(const LibertySettings &settings);
	void wait(double time_s);
};

LibertyDevice::LibertyDevice() : thread_(std::make_unique<Thread>()) {}

LibertyDevice::~LibertyDevice() {
	stop();
}

void LibertyDevice::start(const LibertySettings &settings) {
	stop();
	LibertyEvent old;
	while (next(old)) {
	}
	thread_->dropped_records = 0;
	thread_->is_stopping = false;
	thread_->thread = std::thread([thread = thread_.get(), settings] { thread->run(settings); });
}

void LibertyDevice::stop() {
	if (!thread_->thread.joinable()) {
		return;
	}
	{
		const std::lock_guard lock(thread_->mutex);
		thread_->is_stopping = true;
	}
	thread_->wake.notify_all();
	thread_->thread.join();
}

bool LibertyDevice::is_running() const {
	return thread_->thread.joinable();
}

bool LibertyDevice::next(LibertyEvent &r_event) {
	return thread_->events.pop(r_event);
}

std::uint64_t LibertyDevice::dropped_records() const {
	return thread_->dropped_records.load(std::memory_order_relaxed);
}

/// Main function of the thread: connects, streams and reconnects until stop().
void LibertyDevice::Thread::run(const LibertySettings &settings) {
	if (const std::optional<Error> error = check(settings)) {
		fail(error->message);
		return;
	}
	std::string why_not;
	const LibusbLibrary *const library = LibusbLibrary::get(why_not);
	if (library == nullptr) {
		fail("Liberty: " + why_not);
		return;
	}
	double wait_s = FIRST_RETRY_S;
	bool was_connected = false, is_first = true;
	std::string last_failure, reported_failure;
	while (!is_stopping) {
		LibertySession session(
				*library, settings, is_stopping, [this](LibertyEvent &&event) { emit(std::move(event)); });
		const LibertySession::End end = session.run();
		if (end.was_streaming) {
			wait_s = FIRST_RETRY_S;
			was_connected = true;
			last_failure = reported_failure = end.failure; // the session reported it
		} else if (!end.failure.empty()) {
			// After a reconnection the system needs a moment to load firmware and set permissions, so a
			// single failure is not reported. A lost tracker that is absent was already reported.
			const bool is_settled = is_first || end.failure == last_failure;
			if (is_settled && end.failure != reported_failure && !(end.is_absent && was_connected)) {
				fail(end.failure);
				reported_failure = end.failure;
			}
			last_failure = end.failure;
		}
		is_first = false;
		wait(wait_s);
		wait_s = std::min(2.0 * wait_s, LONGEST_RETRY_S);
	}
}

void LibertyDevice::Thread::wait(double time_s) {
	std::unique_lock lock(mutex);
	wake.wait_for(lock, std::chrono::duration<double>(time_s), [this] { return is_stopping.load(); });
}

} // namespace steadyhand
