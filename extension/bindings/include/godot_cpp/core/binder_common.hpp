#pragma once

// godot-cpp has VARIANT_ENUM_CAST in this header.
#include <godot_cpp/core/type_info.hpp>
