// Godot's checks: report to the engine's log with file and line, and leave the function. A failed check is a
// programming error or invalid input. It never stops the program.
#pragma once

#include <godot_cpp/core/defs.hpp>

#include <cstdint>

namespace godot {

class String;

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message = "", bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message = "", bool p_is_warning = false);
void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index,
		int64_t p_size, const char *p_index_text, const char *p_size_text);

namespace internal {
// A function, since GCC warns of a comparison with an enumerator's value that the enum does not have.
constexpr bool is_out_of_range(int64_t p_index, int64_t p_size) {
	return p_index < 0 || p_index >= p_size;
}
} // namespace internal

} // namespace godot

#define GODOT_CPP_REPORT(...) ::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, __VA_ARGS__)

// With the `else` each check is one statement that needs its semicolon.
#define ERR_FAIL_COND_V_MSG(m_cond, m_retval, m_msg)                                                         \
	if (m_cond) [[unlikely]] {                                                                               \
		GODOT_CPP_REPORT("Condition \"" #m_cond "\" is true. Returning.", m_msg);                            \
		return m_retval;                                                                                     \
	} else                                                                                                   \
		((void)0)
#define ERR_FAIL_COND_MSG(m_cond, m_msg) ERR_FAIL_COND_V_MSG(m_cond, , m_msg)
#define ERR_FAIL_COND_V(m_cond, m_retval) ERR_FAIL_COND_V_MSG(m_cond, m_retval, "")
#define ERR_FAIL_COND(m_cond) ERR_FAIL_COND_V_MSG(m_cond, , "")

#define ERR_FAIL_NULL_V_MSG(m_param, m_retval, m_msg)                                                        \
	if ((m_param) == nullptr) [[unlikely]] {                                                                 \
		GODOT_CPP_REPORT("Parameter \"" #m_param "\" is null.", m_msg);                                      \
		return m_retval;                                                                                     \
	} else                                                                                                   \
		((void)0)
#define ERR_FAIL_NULL_MSG(m_param, m_msg) ERR_FAIL_NULL_V_MSG(m_param, , m_msg)
#define ERR_FAIL_NULL_V(m_param, m_retval) ERR_FAIL_NULL_V_MSG(m_param, m_retval, "")
#define ERR_FAIL_NULL(m_param) ERR_FAIL_NULL_V_MSG(m_param, , "")

#define ERR_FAIL_INDEX_V(m_index, m_size, m_retval)                                                          \
	if (::godot::internal::is_out_of_range(int64_t(m_index), int64_t(m_size))) [[unlikely]] {                \
		::godot::_err_print_index_error(                                                                     \
				__FUNCTION__, __FILE__, __LINE__, int64_t(m_index), int64_t(m_size), #m_index, #m_size);     \
		return m_retval;                                                                                     \
	} else                                                                                                   \
		((void)0)
#define ERR_FAIL_INDEX(m_index, m_size) ERR_FAIL_INDEX_V(m_index, m_size, )

#define ERR_FAIL_V_MSG(m_retval, m_msg)                                                                      \
	do {                                                                                                     \
		GODOT_CPP_REPORT("Method/function failed. Returning: " #m_retval, m_msg);                            \
		return m_retval;                                                                                     \
	} while (false)
#define ERR_FAIL_MSG(m_msg) ERR_FAIL_V_MSG(, m_msg)
#define ERR_FAIL_V(m_retval) ERR_FAIL_V_MSG(m_retval, "")

#define ERR_PRINT(m_msg) GODOT_CPP_REPORT(m_msg)
#define WARN_PRINT(m_msg) GODOT_CPP_REPORT(m_msg, "", true)
