#include <godot_cpp/core/error_macros.hpp>

#include <godot_cpp/variant/string.hpp>

namespace godot {

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message, bool p_is_warning) {
	namespace gd = gdextension_interface;
	constexpr GDExtensionBool EDITOR_NOTIFY = false;
	if (p_is_warning) {
		gd::print_warning(p_error, p_function, p_file, p_line, EDITOR_NOTIFY);
	} else if (*p_message == '\0') {
		gd::print_error(p_error, p_function, p_file, p_line, EDITOR_NOTIFY);
	} else {
		gd::print_error_with_message(p_error, p_message, p_function, p_file, p_line, EDITOR_NOTIFY);
	}
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error, p_message.utf8().get_data(), p_is_warning);
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error.utf8().get_data(), p_message, p_is_warning);
}

void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index,
		int64_t p_size, const char *p_index_text, const char *p_size_text) {
	const String error = String("Index ") + p_index_text + " = " + itos(p_index) + " is out of bounds (" +
			p_size_text + " = " + itos(p_size) + ").";
	_err_print_error(p_function, p_file, p_line, error, "", false);
}

} // namespace godot
