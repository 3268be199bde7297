#pragma once

#if defined(_WIN32) && !defined(NOMINMAX)
#define NOMINMAX // libusb.h includes windows.h, whose macros would replace std::min and std::max
#endif
#include <libusb.h>

#include <string>

namespace steadyhand {

/// The functions of libusb-1.0 that the devices use, loaded at run time: the extension also works without
/// libusb. Names and types are libusb's own.
struct LibusbLibrary {
	decltype(&libusb_init) init;
	decltype(&libusb_exit) exit;
	decltype(&libusb_get_device_list) get_device_list;
	decltype(&libusb_free_device_list) free_device_list;
	decltype(&libusb_get_device_descriptor) get_device_descriptor;
	decltype(&libusb_open) open;
	decltype(&libusb_close) close;
	decltype(&libusb_get_configuration) get_configuration;
	decltype(&libusb_set_configuration) set_configuration;
	decltype(&libusb_claim_interface) claim_interface;
	decltype(&libusb_release_interface) release_interface;
	decltype(&libusb_bulk_transfer) bulk_transfer;
	decltype(&libusb_alloc_transfer) alloc_transfer;
	decltype(&libusb_free_transfer) free_transfer;
	decltype(&libusb_submit_transfer) submit_transfer;
	decltype(&libusb_cancel_transfer) cancel_transfer;
	decltype(&libusb_handle_events_timeout_completed) handle_events_timeout_completed;
	decltype(&libusb_error_name) error_name;

	/// The library, which stays loaded until the process ends. Null if it cannot be loaded; `r_why_not` then
	/// says why and what to do. The next call tries again. May be called from any thread.
	///
	/// The environment variable STEADYHAND_LIBUSB names the library's file if the system does not find it.
	static const LibusbLibrary *get(std::string &r_why_not);
};

} // namespace steadyhand
