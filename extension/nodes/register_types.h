#pragma once

#include <godot_cpp/core/defs.hpp>

#include <gdextension_interface.h>

extern "C" GDE_EXPORT GDExtensionBool steadyhand_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization);
