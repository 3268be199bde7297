#include "simulated_usb.h"

#include <linux/capability.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace {

constexpr const char *NODE = "/dev/bus/usb/001/004";
constexpr const char *PLACE = "/sys/devices/usb1/1-1";

/// Of the tracker as it is, decoded from the published firmware: endpoints 0x82, 0x04, 0x06 and 0x88.
constexpr std::string_view DESCRIPTORS = "1201000200000040440f20ff000001020001"
										 "09022e00010100803209040000" // one interface
										 "04ff000000"                 // four endpoints
										 "07058202000200"
										 "07050402000200"
										 "07050602000200"
										 "07058802000200";
/// Without firmware: no endpoint.
constexpr std::string_view BARE_DESCRIPTORS = "1201000200000040440f21ff000001020001"
											  "09021200010100803209040000"
											  "00ff000000";

double now_s() {
	return static_cast<double>(g_get_monotonic_time()) * 1e-6;
}

void fail(const GError *error) {
	std::fprintf(stderr, "liberty_sim: %s\n", error->message);
	std::exit(2);
}

} // namespace

void SimulatedUsb::plug() {
	is_unplugged_ = false;
	liberty_ = std::make_unique<SimulatedLiberty>(options_.faults, now_s());
	std::string description =
			"P: /devices/usb1/1-1\nN: bus/usb/001/004\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
			"E: DEVNAME=/dev/bus/usb/001/004\nE: BUSNUM=001\nE: DEVNUM=004\nE: MAJOR=189\nE: "
			"MINOR=3\nA: busnum=1\\n\nA: devnum=4\\n\nA: speed=480\\n\nA: bConfigurationValue=1\\n\n"
			"A: idVendor=0f44\\n\nA: idProduct=";
	description += options_.firmware_missing ? "ff21" : "ff20";
	description += "\\n\nH: descriptors=";
	description += options_.firmware_missing ? BARE_DESCRIPTORS : DESCRIPTORS;
	GError *error = nullptr;
	if (!umockdev_testbed_add_from_string(bed_, (description + "\n").c_str(), &error)) {
		fail(error);
	}
	if (options_.no_permission) {
		gchar *const root = umockdev_testbed_get_root_dir(bed_);
		chmod((std::string(root) + NODE).c_str(), 0);
		g_free(root);
	}
}

int SimulatedUsb::run(char **command) {
	bed_ = umockdev_testbed_new();
	UMockdevIoctlBase *const base = umockdev_ioctl_base_new();
	g_signal_connect(base, "handle-ioctl", G_CALLBACK(&SimulatedUsb::on_ioctl), this);
	GError *error = nullptr;
	if (!umockdev_testbed_attach_ioctl(bed_, NODE, base, &error)) {
		fail(error);
	}
	if (!options_.no_device) {
		plug();
	}
	loop_ = g_main_loop_new(nullptr, FALSE);
	GSubprocessLauncher *const launcher = g_subprocess_launcher_new(G_SUBPROCESS_FLAGS_NONE);
	if (options_.no_permission) {
		// Without these even root obeys a file's permissions.
		g_subprocess_launcher_set_child_setup(
				launcher,
				[](gpointer) {
					prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
					prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH, 0, 0, 0);
				},
				nullptr, nullptr);
	}
	GSubprocess *const child =
			g_subprocess_launcher_spawnv(launcher, const_cast<const gchar *const *>(command), &error);
	if (child == nullptr) {
		fail(error);
	}
	g_subprocess_wait_async(child, nullptr, &SimulatedUsb::on_end, this);
	g_timeout_add(1, &SimulatedUsb::on_tick, this);
	g_main_loop_run(loop_);
	if (options_.print_commands && liberty_ != nullptr) {
		std::printf("commands %s\noverloads %d\n", liberty_->commands().c_str(),
				overloads_ + liberty_->overloads());
	}
	g_object_unref(bed_);
	return status_;
}

void SimulatedUsb::unplug() {
	is_unplugged_ = was_unplugged_ = true;
	overloads_ += liberty_->overloads();
	for (Urb &urb : urbs_) {
		if (!urb.is_done) {
			finish(urb, -ESHUTDOWN, {}, 0);
		}
	}
	umockdev_testbed_uevent(bed_, PLACE, "remove");
	umockdev_testbed_remove_device(bed_, PLACE);
}

void SimulatedUsb::replug_when_noticed() {
	if (urbs_.empty() && options_.replug_s >= 0.0 && !is_replug_due_) {
		is_replug_due_ = true;
		g_timeout_add(static_cast<guint>(options_.replug_s * 1e3), &SimulatedUsb::on_replug, this);
	}
}

gboolean SimulatedUsb::on_replug(gpointer self_pointer) {
	auto &self = *static_cast<SimulatedUsb *>(self_pointer);
	const std::lock_guard lock(self.mutex_);
	self.plug();
	umockdev_testbed_uevent(self.bed_, PLACE, "add");
	return G_SOURCE_REMOVE;
}

/// Answers those that wait to reap: the mocked node always looks ready, and a computer that need not wait
/// would ask all the time.
gboolean SimulatedUsb::on_tick(gpointer self_pointer) {
	auto &self = *static_cast<SimulatedUsb *>(self_pointer);
	const std::lock_guard lock(self.mutex_);
	self.answer();
	if (self.is_unplugged_) {
		self.replug_when_noticed();
	} else if (self.options_.unplug_s >= 0.0 && !self.was_unplugged_ && self.liberty_ != nullptr &&
			self.liberty_->streamed_s() >= self.options_.unplug_s) {
		self.unplug();
	}
	for (UMockdevIoctlClient *const client : std::exchange(self.waiting_, {})) {
		if (!self.reap(client)) {
			umockdev_ioctl_client_complete(client, -1, self.is_unplugged_ ? ENODEV : EAGAIN);
		}
		g_object_unref(client);
	}
	return G_SOURCE_CONTINUE;
}

void SimulatedUsb::on_end(GObject *child, GAsyncResult *result, gpointer self_pointer) {
	auto &self = *static_cast<SimulatedUsb *>(self_pointer);
	GSubprocess *const process = G_SUBPROCESS(child);
	g_subprocess_wait_finish(process, result, nullptr);
	constexpr int KILLED = 128; // as in a shell
	self.status_ = g_subprocess_get_if_exited(process) ? g_subprocess_get_exit_status(process)
													   : KILLED + g_subprocess_get_term_sig(process);
	g_main_loop_quit(self.loop_);
}

gboolean SimulatedUsb::on_ioctl(UMockdevIoctlBase *, UMockdevIoctlClient *client, gpointer self_pointer) {
	auto &self = *static_cast<SimulatedUsb *>(self_pointer);
	const std::lock_guard lock(self.mutex_);
	self.serve(client);
	return TRUE;
}

void SimulatedUsb::serve(UMockdevIoctlClient *client) {
	UMockdevIoctlData *const argument = umockdev_ioctl_client_get_arg(client);
	switch (umockdev_ioctl_client_get_request(client)) {
		case USBDEVFS_GET_CAPABILITIES: {
			std::uint32_t capabilities = USBDEVFS_CAP_REAP_AFTER_DISCONNECT |
					USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_BULK_CONTINUATION |
					USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_ZERO_PACKET;
			UMockdevIoctlData *const data =
					umockdev_ioctl_data_resolve(argument, 0, sizeof capabilities, nullptr);
			umockdev_ioctl_data_update(
					data, 0, reinterpret_cast<guint8 *>(&capabilities), sizeof capabilities);
			g_object_unref(data);
			umockdev_ioctl_client_complete(client, 0, 0);
			break;
		}
		case USBDEVFS_CLAIMINTERFACE:
			umockdev_ioctl_client_complete(client, options_.busy ? -1 : 0, options_.busy ? EBUSY : 0);
			break;
		case USBDEVFS_RELEASEINTERFACE:
		case USBDEVFS_CLEAR_HALT:
		case USBDEVFS_SETCONFIGURATION:
			umockdev_ioctl_client_complete(client, 0, 0);
			break;
		case USBDEVFS_GETDRIVER:
			umockdev_ioctl_client_complete(client, -1, ENODATA);
			break;
		case USBDEVFS_SUBMITURB:
			submit(client, argument);
			break;
		case USBDEVFS_DISCARDURB:
			discard(client, argument);
			break;
		case USBDEVFS_REAPURB:
		case USBDEVFS_REAPURBNDELAY:
			if (!reap(client)) {
				waiting_.push_back(UMOCKDEV_IOCTL_CLIENT(g_object_ref(client)));
			}
			break;
		default:
			umockdev_ioctl_client_complete(client, -1, ENOTTY);
			break;
	}
}

void SimulatedUsb::submit(UMockdevIoctlClient *client, UMockdevIoctlData *argument) {
	if (is_unplugged_) {
		umockdev_ioctl_client_complete(client, -1, ENODEV);
		return;
	}
	Urb urb;
	urb.urb = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
	const int size = urb.fields()->buffer_length;
	urb.buffer = umockdev_ioctl_data_resolve(
			urb.urb, G_STRUCT_OFFSET(usbdevfs_urb, buffer), static_cast<gsize>(size), nullptr);
	if (!urb.is_in()) {
		const auto *const bytes = reinterpret_cast<const char *>(urb.buffer->data);
		liberty_->write({ bytes, static_cast<std::size_t>(size) }, now_s());
		finish(urb, 0, {}, size);
	}
	urbs_.push_back(urb);
	umockdev_ioctl_client_complete(client, 0, 0);
}

void SimulatedUsb::discard(UMockdevIoctlClient *client, UMockdevIoctlData *argument) {
	const gulong address = *reinterpret_cast<gulong *>(argument->data);
	for (Urb &urb : urbs_) {
		if (!urb.is_done && urb.urb->client_addr == address) {
			finish(urb, -ENOENT, {}, 0);
			umockdev_ioctl_client_complete(client, 0, 0);
			return;
		}
	}
	umockdev_ioctl_client_complete(client, -1, EINVAL);
}

/// Hands a finished transfer back. False where none is.
bool SimulatedUsb::reap(UMockdevIoctlClient *client) {
	for (auto urb = urbs_.begin(); urb != urbs_.end(); ++urb) {
		if (!urb->is_done) {
			continue;
		}
		UMockdevIoctlData *const data = umockdev_ioctl_data_resolve(
				umockdev_ioctl_client_get_arg(client), 0, sizeof(void *), nullptr);
		umockdev_ioctl_data_set_ptr(data, 0, urb->urb);
		g_object_unref(data);
		g_object_unref(urb->urb);
		g_object_unref(urb->buffer);
		urbs_.erase(urb);
		umockdev_ioctl_client_complete(client, 0, 0);
		return true;
	}
	return false;
}

/// Fills queued transfers with what the tracker has to say.
void SimulatedUsb::answer() {
	for (Urb &urb : urbs_) {
		if (urb.is_done || !urb.is_in() || is_unplugged_) {
			continue;
		}
		const std::string bytes = liberty_->read(now_s());
		if (bytes.empty()) {
			return;
		}
		finish(urb, 0, bytes, static_cast<int>(bytes.size()));
	}
}

void SimulatedUsb::finish(Urb &urb, int status, std::string_view bytes, int size) {
	std::string copy(bytes);
	if (!copy.empty()) {
		umockdev_ioctl_data_update(
				urb.buffer, 0, reinterpret_cast<guint8 *>(copy.data()), static_cast<gint>(copy.size()));
	}
	// Only these two: the buffer's address must stay the computer's.
	umockdev_ioctl_data_update(urb.urb, G_STRUCT_OFFSET(usbdevfs_urb, status),
			reinterpret_cast<guint8 *>(&status), sizeof status);
	umockdev_ioctl_data_update(urb.urb, G_STRUCT_OFFSET(usbdevfs_urb, actual_length),
			reinterpret_cast<guint8 *>(&size), sizeof size);
	urb.is_done = true;
}
