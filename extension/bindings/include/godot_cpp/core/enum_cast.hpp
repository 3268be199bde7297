#pragma once

namespace godot::internal {

// The enum's C++ name, defined by VARIANT_ENUM_CAST.
template <typename T> inline constexpr const char *ENUM_NAME = nullptr;

} // namespace godot::internal

// Lets an enum appear in bound methods; used outside every namespace, after the class that holds it.
#define VARIANT_ENUM_CAST(m_enum)                                                                            \
	namespace godot::internal {                                                                              \
	template <> inline constexpr const char *ENUM_NAME<m_enum> = #m_enum;                                    \
	}
#define VARIANT_BITFIELD_CAST(m_enum) VARIANT_ENUM_CAST(m_enum)
