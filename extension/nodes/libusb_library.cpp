#include "libusb_library.h"

#include "run_time_library.h"
#include "static_mutex.h"

#include <array>
#include <mutex>

namespace steadyhand {

namespace {

#if defined(_WIN32)
constexpr std::array LIBUSB_NAMES = { "libusb-1.0.dll" };
constexpr const char *HOW_TO_INSTALL_LIBUSB = "Put libusb-1.0.dll beside the program.";
#elif defined(__APPLE__)
// Homebrew's folders, on Apple silicon and on Intel, are not on the loader's path.
constexpr std::array LIBUSB_NAMES = { "libusb-1.0.0.dylib", "/opt/homebrew/lib/libusb-1.0.0.dylib",
	"/usr/local/lib/libusb-1.0.0.dylib" };
constexpr const char *HOW_TO_INSTALL_LIBUSB = "Install it with: brew install libusb";
#else
constexpr std::array LIBUSB_NAMES = { "libusb-1.0.so.0" };
constexpr const char *HOW_TO_INSTALL_LIBUSB =
		"Install the package libusb-1.0-0 (Debian, Ubuntu) or libusb1 (Fedora).";
#endif

bool bind_libusb(LibraryHandle handle, LibusbLibrary &r_library, std::string &r_why_not) {
	const auto have = [&](const char *symbol, auto &r_function) {
		return bind_symbol(handle, symbol, r_function, r_why_not);
	};
	LibusbLibrary &l = r_library;
	return have("libusb_init", l.init) && have("libusb_exit", l.exit) &&
			have("libusb_get_device_list", l.get_device_list) &&
			have("libusb_free_device_list", l.free_device_list) &&
			have("libusb_get_device_descriptor", l.get_device_descriptor) && have("libusb_open", l.open) &&
			have("libusb_close", l.close) && have("libusb_get_configuration", l.get_configuration) &&
			have("libusb_set_configuration", l.set_configuration) &&
			have("libusb_claim_interface", l.claim_interface) &&
			have("libusb_release_interface", l.release_interface) &&
			have("libusb_bulk_transfer", l.bulk_transfer) &&
			have("libusb_alloc_transfer", l.alloc_transfer) &&
			have("libusb_free_transfer", l.free_transfer) &&
			have("libusb_submit_transfer", l.submit_transfer) &&
			have("libusb_cancel_transfer", l.cancel_transfer) &&
			have("libusb_handle_events_timeout_completed", l.handle_events_timeout_completed) &&
			have("libusb_error_name", l.error_name);
}

// Both have trivial destructors, so no code runs when the extension is unloaded.
constinit StaticMutex libusb_mutex;
constinit LibusbLibrary loaded_libusb{};
constinit bool is_libusb_loaded = false;

} // namespace

const LibusbLibrary *LibusbLibrary::get(std::string &r_why_not) {
	const std::lock_guard lock(libusb_mutex);
	if (is_libusb_loaded) {
		return &loaded_libusb;
	}
	std::string why_not;
	if (const LibraryHandle handle = open_library("STEADYHAND_LIBUSB", LIBUSB_NAMES, why_not)) {
		is_libusb_loaded = bind_libusb(handle, loaded_libusb, why_not);
		if (is_libusb_loaded) {
			return &loaded_libusb;
		}
		close_library(handle);
	}
	r_why_not = "cannot load libusb-1.0 (" + why_not + "). " + HOW_TO_INSTALL_LIBUSB;
	return nullptr;
}

} // namespace steadyhand
