#pragma once

// godot-cpp's home of VARIANT_ENUM_CAST.
#include <godot_cpp/core/type_info.hpp>
