#pragma once

// Builtin mathematics is stored in single precision, as in the engine's official builds.
namespace godot {
using real_t = float;
} // namespace godot

#ifdef _WIN32
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif
