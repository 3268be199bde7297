#pragma once

#include "base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

// The plain CSV of tracks and trial sets: UTF-8 (a byte order mark is skipped), comma, LF or CRLF. Cells may
// be in quotes (RFC 4180), as other programs write them, but for line breaks in them.

/// Walks a text line by line. Views point into the text, which must outlive them.
class CsvLines {
public:
	explicit CsvLines(std::string_view text);

	/// False at the end of the text. A line comes without its line break.
	bool next(std::string_view &r_line);
	[[nodiscard]] bool are_over() const { return rest_.empty(); }
	/// 1 for the first line; the one that next() gave last.
	[[nodiscard]] std::size_t line_number() const { return line_number_; }

private:
	std::string_view rest_;
	std::size_t line_number_ = 0;
};

[[nodiscard]] std::string_view trim(std::string_view text);

/// Cells of a line, trimmed of spaces and tabs, without the quotes around them; a doubled quote within these
/// is one. Always at least one. Views point into the line or into r_unescaped, which must outlive them. The
/// time grows linearly with the line's length.
void split_cells(std::string_view line, std::vector<std::string_view> &r_cells, std::string &r_unescaped);

/// Offset of the first byte that no UTF-8 text holds: a control character other than tab, a malformed or
/// overlong sequence, a surrogate.
[[nodiscard]] std::optional<std::size_t> find_not_text(std::string_view line);

/// A finite number of the given magnitude at most, decimal point whatever the locale. The error names the
/// cell's content only; where it stands is the caller's to say.
[[nodiscard]] Result<double> parse_number(std::string_view cell, double magnitude_max);

/// The shortest text that reads back as the same double.
void append_number(std::string &r_out, double number);

/// Text for one metadata line, or one cell: control characters become spaces, so that what is written can
/// always be read back. A cell that holds a comma, or begins with a quote, is put in quotes, and its own
/// quotes are doubled.
void append_plain_text(std::string &r_out, std::string_view text);
void append_cell(std::string &r_out, std::string_view text);

/// For error messages: quoted, bytes that do not print as \xNN, cut after 40 characters.
[[nodiscard]] std::string quoted(std::string_view cell);

/// "source:line: what is wrong".
[[nodiscard]] Error error_at(std::string_view source, std::size_t line, std::string_view what);
/// "source:line: column: what is wrong". A long column name is cut after 40 bytes.
[[nodiscard]] Error error_at(
		std::string_view source, std::size_t line, std::string_view column, std::string_view what);

/// Why these header cells are no header: another separator, a byte that is not text or a name that comes
/// twice.
[[nodiscard]] std::optional<Error> check_header(
		std::string_view source, std::size_t line, const std::vector<std::string_view> &names);

/// Why this line is no row of the header's columns: a byte that is not text, too few cells or too many.
[[nodiscard]] std::optional<Error> check_row(std::string_view source, std::size_t line, std::string_view text,
		const std::vector<std::string_view> &cells, const std::vector<std::string> &names);

} // namespace steadyhand
