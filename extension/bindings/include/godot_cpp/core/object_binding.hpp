#pragma once

#include <godot_cpp/classes/wrapped.hpp>

namespace godot::internal {

// The callbacks of an engine class or of one of ours, for the wrappers that get_instance_binding() makes.
void register_binding_callbacks(
		const StringName &p_class, const GDExtensionInstanceBindingCallbacks *p_callbacks);

// Callbacks of every engine class in the manifest; written by the generator.
void register_engine_classes();

// The engine's name of the class above p_class; empty at the top.
StringName parent_class(const StringName &p_class);

// Frees the wrappers of the engine's singletons, which outlive the library, and drops the callbacks.
void release_bindings();

} // namespace godot::internal
