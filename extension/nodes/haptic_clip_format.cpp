#include "haptic_clip_format.h"

#include "conversions.h"
#include "haptic_clip.h"
#include "text_file.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

PackedStringArray HapticClipFormatLoader::_get_recognized_extensions() const {
	return { "haptic", "ahap" };
}

bool HapticClipFormatLoader::_handles_type(const StringName &p_type) const {
	return p_type == StringName("HapticClip") || p_type == StringName("HapticEffect") ||
			p_type == StringName("Resource");
}

String HapticClipFormatLoader::_get_resource_type(const String &p_path) const {
	return _get_recognized_extensions().has(p_path.get_extension().to_lower()) ? "HapticClip" : "";
}

Variant HapticClipFormatLoader::_load(const String &p_path, const String &, bool, int32_t) const {
	const Ref<HapticClip> clip = HapticClip::load_file(p_path);
	return clip.is_valid() ? Variant(clip) : Variant(ERR_FILE_CORRUPT);
}

Error HapticClipFormatSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t) {
	const HapticClip *clip = Object::cast_to<HapticClip>(p_resource.ptr());
	ERR_FAIL_NULL_V_MSG(
			clip, ERR_INVALID_PARAMETER, p_path + String(": only a HapticClip is saved as *.haptic"));
	const String text = clip->to_text();
	ERR_FAIL_COND_V_MSG(text.is_empty(), ERR_INVALID_DATA,
			p_path + String(": this HapticClip is empty; load or record one first"));
	return write_text_file(p_path, to_core(text));
}

bool HapticClipFormatSaver::_recognize(const Ref<Resource> &p_resource) const {
	return Object::cast_to<HapticClip>(p_resource.ptr()) != nullptr;
}

PackedStringArray HapticClipFormatSaver::_get_recognized_extensions(const Ref<Resource> &p_resource) const {
	return _recognize(p_resource) ? PackedStringArray{ "haptic" } : PackedStringArray();
}

} // namespace godot
