#pragma once

#include "base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

// CSV of tracks and trial sets: UTF-8 (a byte order mark is skipped), separated by commas, LF or CRLF. Cells
// may be quoted (RFC 4180), but must not contain line breaks.

/// Iterates over the lines of a text. Views point into the text, which must outlive them.
class CsvLines {
public:
	explicit CsvLines(std::string_view text);

	/// Gets the next line without its line break. Returns false at the end of the text.
	bool next(std::string_view &r_line);
	[[nodiscard]] bool are_over() const { return rest_.empty(); }
	/// Number of the last line that next() returned, from 1.
	[[nodiscard]] std::size_t line_number() const { return line_number_; }

private:
	std::string_view rest_;
	std::size_t line_number_ = 0;
};

[[nodiscard]] std::string_view trim(std::string_view text);

/// Splits a line into at least one cell. Cells are trimmed of spaces and tabs, and unquoted. Views point into
/// the line or into r_unescaped, which must outlive them. Takes linear time.
void split_cells(std::string_view line, std::vector<std::string_view> &r_cells, std::string &r_unescaped);

/// Offset of the first byte that is not text: a control character other than tab, a malformed or overlong
/// UTF-8 sequence, or a surrogate.
[[nodiscard]] std::optional<std::size_t> find_not_text(std::string_view line);

/// Parses a finite number of at most this magnitude, with a decimal point in every locale. The error names
/// the cell's content. The caller adds the position.
[[nodiscard]] Result<double> parse_number(std::string_view cell, double magnitude_max);

/// Appends the shortest text that reads back as the same double.
void append_number(std::string &r_out, double number);

/// Appends text of a metadata line or a cell. Control characters become spaces, so that the file can be read
/// back. A cell with a comma, or with a quote at its begin, is quoted.
void append_plain_text(std::string &r_out, std::string_view text);
void append_cell(std::string &r_out, std::string_view text);

/// Text for error messages: in single quotes, unprintable bytes as \xNN, at most 40 bytes.
[[nodiscard]] std::string quoted(std::string_view cell);

/// "source:line: what".
[[nodiscard]] Error error_at(std::string_view source, std::size_t line, std::string_view what);
/// "source:line: column: what". A long column name is cut after 40 bytes.
[[nodiscard]] Error error_at(
		std::string_view source, std::size_t line, std::string_view column, std::string_view what);

/// Error of a header: another separator, values instead of names, a byte that is not text, or a duplicate
/// name.
[[nodiscard]] std::optional<Error> check_header(
		std::string_view source, std::size_t line, const std::vector<std::string_view> &names);

/// Error of a row: a byte that is not text, too few cells or too many.
[[nodiscard]] std::optional<Error> check_row(std::string_view source, std::size_t line, std::string_view text,
		const std::vector<std::string_view> &cells, const std::vector<std::string> &names);

} // namespace steadyhand
