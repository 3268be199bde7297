// The library's entry point, which the extension's C entry function passes to the engine's loader. Class
// reference: a source made by godot-cpp's own recipe (zlib-compressed XML of all classes in one static
// DocDataRegistration) serves these bindings as it is.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/core/gdextension_interface_loader.hpp>

namespace godot {

namespace internal {

class DocDataRegistration {
public:
	// p_data: p_compressed_size bytes of zlib, which unpack to p_uncompressed_size bytes of UTF-8; it must be
	// static.
	DocDataRegistration(
			const char *p_hash, int p_uncompressed_size, int p_compressed_size, const unsigned char *p_data);
};

} // namespace internal

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR,
};

class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel p_level);

	class InitObject {
		GDExtensionInterfaceGetProcAddress get_proc_address_;
		GDExtensionInitialization *initialization_;

	public:
		InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
				GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization);

		void register_initializer(Callback p_initializer) const;
		void register_terminator(Callback p_terminator) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const;
		GDExtensionBool init() const;
	};
};

} // namespace godot
