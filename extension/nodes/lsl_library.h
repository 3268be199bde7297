#pragma once

#include <cstdint>
#include <string>

// liblsl's own opaque types.
struct lsl_streaminfo_struct_;
struct lsl_outlet_struct_;
struct lsl_xml_ptr_struct_;

namespace steadyhand {

/// The functions of liblsl (Lab Streaming Layer) that LslOutlet uses, loaded at run time. Its headers are not
/// needed. Names and types are those of its C interface.
struct LslLibrary {
	using StreamInfo = lsl_streaminfo_struct_ *;
	using Outlet = lsl_outlet_struct_ *;
	using Xml = lsl_xml_ptr_struct_ *;

	/// Values of lsl_channel_format_t.
	static constexpr int32_t DOUBLE64 = 2;
	static constexpr int32_t STRING = 3;
	static constexpr double IRREGULAR_RATE = 0.0;

	StreamInfo (*create_streaminfo)(const char *name, const char *type, int32_t channel_count,
			double nominal_srate, int32_t channel_format, const char *source_id);
	void (*destroy_streaminfo)(StreamInfo info);
	Xml (*get_desc)(StreamInfo info);
	/// Returns the new child.
	Xml (*append_child)(Xml element, const char *name);
	/// Returns `element`.
	Xml (*append_child_value)(Xml element, const char *name, const char *value);
	/// `chunk_size` 0: as pushed. `max_buffered_s`: size of the buffer for slow receivers.
	Outlet (*create_outlet)(StreamInfo info, int32_t chunk_size, int32_t max_buffered_s);
	void (*destroy_outlet)(Outlet outlet);
	/// Both return 0 or an error code.
	int32_t (*push_sample_dtp)(Outlet outlet, const double *data, double timestamp_s, int32_t pushthrough);
	int32_t (*push_sample_strtp)(Outlet outlet, const char **data, double timestamp_s, int32_t pushthrough);
	double (*local_clock)();

	/// The library, which stays loaded until the process ends. Null if it cannot be loaded; `r_why_not` then
	/// says why and what to do. The next call tries again. May be called from any thread.
	///
	/// The environment variable STEADYHAND_LSL names the library's file if the system does not find it.
	static const LslLibrary *get(std::string &r_why_not);
};

} // namespace steadyhand
