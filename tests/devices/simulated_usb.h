#pragma once

#include "simulated_liberty.h"

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include <list>
#include <memory>
#include <mutex>
#include <string_view>

/// What is plugged in, and how the system treats it. unplug_s: of the first stream, on the tracker's clock.
/// replug_s: after the program has fetched its last transfer.
struct SimulatedUsbOptions {
	SimulatedFaults faults;
	double unplug_s = -1.0, replug_s = -1.0; ///< s; below 0: never
	bool no_device = false, firmware_missing = false, no_permission = false, busy = false,
		 print_commands = false;
};

/// The USB of a program, mocked with umockdev: its system calls on the tracker's node end up here.
class SimulatedUsb {
public:
	explicit SimulatedUsb(const SimulatedUsbOptions &options) : options_(options) {}
	/// Runs `command` with its arguments. Returns its exit status.
	int run(char **command);

private:
	/// A transfer that the computer queued.
	struct Urb {
		UMockdevIoctlData *urb = nullptr, *buffer = nullptr;
		bool is_done = false;

		[[nodiscard]] usbdevfs_urb *fields() const { return reinterpret_cast<usbdevfs_urb *>(urb->data); }
		[[nodiscard]] bool is_in() const { return (fields()->endpoint & 0x80U) != 0; }
	};

	static gboolean on_ioctl(UMockdevIoctlBase *base, UMockdevIoctlClient *client, gpointer self);
	static gboolean on_replug(gpointer self);
	static gboolean on_tick(gpointer self);
	static void on_end(GObject *child, GAsyncResult *result, gpointer self);

	void plug();
	void unplug();
	void replug_when_noticed();
	void serve(UMockdevIoctlClient *client);
	void submit(UMockdevIoctlClient *client, UMockdevIoctlData *argument);
	void discard(UMockdevIoctlClient *client, UMockdevIoctlData *argument);
	bool reap(UMockdevIoctlClient *client);
	void answer();
	static void finish(Urb &urb, int status, std::string_view bytes, int size);

	SimulatedUsbOptions options_;
	/// umockdev calls on_ioctl() in a thread of its own; the timers run in that of run(). It guards the
	/// members that both use.
	std::mutex mutex_;
	UMockdevTestbed *bed_ = nullptr;
	std::unique_ptr<SimulatedLiberty> liberty_;
	std::list<Urb> urbs_; ///< the oldest first
	std::list<UMockdevIoctlClient *> waiting_;
	bool is_unplugged_ = false, was_unplugged_ = false, is_replug_due_ = false;
	int overloads_ = 0; ///< of trackers that were unplugged
	GMainLoop *loop_ = nullptr;
	int status_ = 1;
};
