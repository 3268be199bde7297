#include <godot_cpp/godot.hpp>

#include <godot_cpp/core/cached_name.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object_binding.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdio>
#include <cstring>

namespace godot {

namespace gdextension_interface {

#define GODOT_CPP_DEFINE(m_name, m_type) GDExtensionInterface##m_type m_name = nullptr;
GODOT_CPP_INTERFACE(GODOT_CPP_DEFINE)
#undef GODOT_CPP_DEFINE

GDExtensionClassLibraryPtr library = nullptr;

} // namespace gdextension_interface

namespace {

struct Library {
	GDExtensionBinding::Callback initializer = nullptr;
	GDExtensionBinding::Callback terminator = nullptr;
	GDExtensionInitializationLevel minimum_level = GDEXTENSION_INITIALIZATION_CORE;
};
Library the_library;

struct ClassReference {
	int uncompressed_size = 0;
	int compressed_size = 0;
	const unsigned char *data = nullptr;
};
ClassReference class_reference;

bool load_interface(GDExtensionInterfaceGetProcAddress p_get_proc_address) {
	bool complete = true;
	const auto load = [&](auto &r_function, const char *p_name) {
		r_function =
				reinterpret_cast<std::remove_reference_t<decltype(r_function)>>(p_get_proc_address(p_name));
		if (r_function == nullptr) {
			std::fprintf(stderr, "ERROR: this engine has no '%s'; Godot 4.4 or newer is needed.\n", p_name);
			complete = false;
		}
	};
#define GODOT_CPP_LOAD(m_name, m_type) load(gdextension_interface::m_name, #m_name);
	GODOT_CPP_INTERFACE(GODOT_CPP_LOAD)
#undef GODOT_CPP_LOAD
	return complete;
}

void load_class_reference() {
	if (class_reference.data == nullptr) {
		return;
	}
	constexpr int64_t DEFLATE = 1; // FileAccess::COMPRESSION_DEFLATE
	PackedByteArray packed;
	packed.resize(class_reference.compressed_size);
	std::memcpy(packed.ptrw(), class_reference.data, size_t(class_reference.compressed_size));
	const PackedByteArray xml = packed.decompress(class_reference.uncompressed_size, DEFLATE);
	gdextension_interface::editor_help_load_xml_from_utf8_chars_and_len(
			reinterpret_cast<const char *>(xml.ptr()), xml.size());
}

void initialize_level(void *, GDExtensionInitializationLevel p_level) {
	the_library.initializer(ModuleInitializationLevel(p_level));
	if (p_level == GDEXTENSION_INITIALIZATION_EDITOR) {
		load_class_reference();
	}
}

// Levels end in reverse order: the lowest level is the last call into the library.
void deinitialize_level(void *, GDExtensionInitializationLevel p_level) {
	the_library.terminator(ModuleInitializationLevel(p_level));
	if (p_level == the_library.minimum_level) {
		ClassDB::_unregister_all();
		internal::release_bindings();
		internal::CachedName::free_all();
	}
}

} // namespace

internal::DocDataRegistration::DocDataRegistration(
		const char *, int p_uncompressed_size, int p_compressed_size, const unsigned char *p_data) {
	class_reference = { p_uncompressed_size, p_compressed_size, p_data };
}

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) :
		get_proc_address_(p_get_proc_address),
		initialization_(r_initialization) {
	gdextension_interface::library = p_library;
}

void GDExtensionBinding::InitObject::register_initializer(Callback p_initializer) const {
	the_library.initializer = p_initializer;
}

void GDExtensionBinding::InitObject::register_terminator(Callback p_terminator) const {
	the_library.terminator = p_terminator;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(
		ModuleInitializationLevel p_level) const {
	the_library.minimum_level = GDExtensionInitializationLevel(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	if (!load_interface(get_proc_address_)) {
		return false;
	}
	initialization_->minimum_initialization_level = the_library.minimum_level;
	initialization_->userdata = nullptr;
	initialization_->initialize = &initialize_level;
	initialization_->deinitialize = &deinitialize_level;
	return true;
}

} // namespace godot
