#include "track_file.h"

#include "conversions.h"
#include "text_file.h"

namespace godot {

steadyhand::Result<steadyhand::Track> read_track_file(const String &p_path) {
	const steadyhand::Result<std::string> text = read_text_file(p_path);
	if (!text) {
		return steadyhand::Error{ text.error() };
	}
	return steadyhand::parse_track_csv(text.value(), to_core(p_path));
}

} // namespace godot
