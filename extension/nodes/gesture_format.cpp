#include "gesture_format.h"

#include "conversions.h"
#include "gesture_model.h"
#include "text_file.h"

#include "gesture/model_file.h"

#include <godot_cpp/core/class_db.hpp>

namespace godot {

PackedStringArray GestureFormatLoader::_get_recognized_extensions() const {
	return { "gesture" };
}

bool GestureFormatLoader::_handles_type(const StringName &p_type) const {
	return p_type == StringName("GestureModel") || p_type == StringName("Resource");
}

String GestureFormatLoader::_get_resource_type(const String &p_path) const {
	return p_path.get_extension().to_lower() == "gesture" ? "GestureModel" : "";
}

Variant GestureFormatLoader::_load(const String &p_path, const String &, bool, int32_t) const {
	const Ref<GestureModel> model = GestureModel::load_file(p_path);
	return model.is_valid() ? Variant(model) : Variant(ERR_FILE_CORRUPT);
}

Error GestureFormatSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t) {
	const GestureModel *model = Object::cast_to<GestureModel>(p_resource.ptr());
	ERR_FAIL_NULL_V_MSG(
			model, ERR_INVALID_PARAMETER, p_path + String(": only a GestureModel is saved as *.gesture"));
	ERR_FAIL_COND_V_MSG(model->core() == nullptr, ERR_INVALID_DATA,
			p_path + String(": this GestureModel is empty; train it or load one first"));
	return write_text_file(p_path, steadyhand::format_model(*model->core()));
}

bool GestureFormatSaver::_recognize(const Ref<Resource> &p_resource) const {
	return Object::cast_to<GestureModel>(p_resource.ptr()) != nullptr;
}

PackedStringArray GestureFormatSaver::_get_recognized_extensions(const Ref<Resource> &p_resource) const {
	return _recognize(p_resource) ? PackedStringArray{ "gesture" } : PackedStringArray();
}

} // namespace godot
