#include "lsl_library.h"

#include "run_time_library.h"
#include "static_mutex.h"

#include <array>
#include <mutex>

namespace steadyhand {

namespace {

#if defined(_WIN32)
constexpr std::array LSL_NAMES = { "lsl.dll" };
constexpr const char *HOW_TO_INSTALL_LSL = "Put lsl.dll beside the program";
#elif defined(__APPLE__)
// Homebrew's folders, on Apple silicon and on Intel, are not on the loader's path.
constexpr std::array LSL_NAMES = { "liblsl.dylib", "/opt/homebrew/lib/liblsl.dylib",
	"/usr/local/lib/liblsl.dylib" };
constexpr const char *HOW_TO_INSTALL_LSL = "Install it with: brew install labstreaminglayer/tap/lsl";
#else
constexpr std::array LSL_NAMES = { "liblsl.so.2", "liblsl.so" };
constexpr const char *HOW_TO_INSTALL_LSL = "Install liblsl, e.g. the Debian package liblsl";
#endif

bool bind_lsl(LibraryHandle handle, LslLibrary &r_library, std::string &r_why_not) {
	const auto have = [&](const char *symbol, auto &r_function) {
		return bind_symbol(handle, symbol, r_function, r_why_not);
	};
	LslLibrary &l = r_library;
	return have("lsl_create_streaminfo", l.create_streaminfo) &&
			have("lsl_destroy_streaminfo", l.destroy_streaminfo) && have("lsl_get_desc", l.get_desc) &&
			have("lsl_append_child", l.append_child) &&
			have("lsl_append_child_value", l.append_child_value) &&
			have("lsl_create_outlet", l.create_outlet) && have("lsl_destroy_outlet", l.destroy_outlet) &&
			have("lsl_push_sample_dtp", l.push_sample_dtp) &&
			have("lsl_push_sample_strtp", l.push_sample_strtp) && have("lsl_local_clock", l.local_clock);
}

// Both have trivial destructors, so no code runs when the extension is unloaded.
constinit StaticMutex lsl_mutex;
constinit LslLibrary loaded_lsl{};
constinit bool is_lsl_loaded = false;

} // namespace

const LslLibrary *LslLibrary::get(std::string &r_why_not) {
	const std::lock_guard lock(lsl_mutex);
	if (is_lsl_loaded) {
		return &loaded_lsl;
	}
	std::string why_not;
	if (const LibraryHandle handle = open_library("STEADYHAND_LSL", LSL_NAMES, why_not)) {
		is_lsl_loaded = bind_lsl(handle, loaded_lsl, why_not);
		if (is_lsl_loaded) {
			return &loaded_lsl;
		}
		close_library(handle);
	}
	r_why_not = "cannot load liblsl (" + why_not + "). " + HOW_TO_INSTALL_LSL +
			", or name its file in the environment variable STEADYHAND_LSL.";
	return nullptr;
}

} // namespace steadyhand
