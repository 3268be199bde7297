#include "tracking/csv_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace steadyhand {

namespace {

constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";
constexpr std::size_t SHOWN_MAX = 40;

std::string hex_byte(char byte) {
	constexpr std::string_view DIGITS = "0123456789abcdef";
	const auto value = static_cast<unsigned char>(byte);
	return { DIGITS[value >> 4], DIGITS[value & 15] };
}

bool is_control(char character) {
	const auto value = static_cast<unsigned char>(character);
	return (value < 0x20 && character != '\t') || value == 0x7F;
}

/// Length of the well-formed multi-byte sequence at the begin of text (Unicode 15, table 3-7); 0 if there is
/// none.
std::size_t utf8_sequence_length(std::string_view text) {
	const auto byte = [text](std::size_t i) {
		return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
	};
	const auto continues = [&byte](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
	const unsigned lead = byte(0);
	if (lead >= 0xC2 && lead <= 0xDF) {
		return continues(1) ? 2 : 0;
	}
	if (lead >= 0xE0 && lead <= 0xEF) {
		const unsigned low = lead == 0xE0 ? 0xA0 : 0x80;
		const unsigned high = lead == 0xED ? 0x9F : 0xBF;
		return byte(1) >= low && byte(1) <= high && continues(2) ? 3 : 0;
	}
	if (lead >= 0xF0 && lead <= 0xF4) {
		const unsigned low = lead == 0xF0 ? 0x90 : 0x80;
		const unsigned high = lead == 0xF4 ? 0x8F : 0xBF;
		return byte(1) >= low && byte(1) <= high && continues(2) && continues(3) ? 4 : 0;
	}
	return 0;
}

std::string not_text(char byte) {
	return "byte 0x" + hex_byte(byte) + " is not text";
}

/// At most SHOWN_MAX bytes of text, cut between characters.
std::string shortened(std::string_view text) {
	if (text.size() <= SHOWN_MAX) {
		return std::string(text);
	}
	std::size_t length = SHOWN_MAX;
	while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
		--length;
	}
	return std::string(text.substr(0, length)) + "...";
}

std::string counted(std::size_t count, std::string_view noun) {
	return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

} // namespace

CsvLines::CsvLines(std::string_view text) : rest_(text) {
	if (rest_.starts_with(BYTE_ORDER_MARK)) {
		rest_.remove_prefix(BYTE_ORDER_MARK.size());
	}
}

bool CsvLines::next(std::string_view &r_line) {
	if (rest_.empty()) {
		return false;
	}
	const std::size_t end = std::min(rest_.find('\n'), rest_.size());
	r_line = rest_.substr(0, end);
	rest_.remove_prefix(std::min(end + 1, rest_.size()));
	if (r_line.ends_with('\r')) {
		r_line.remove_suffix(1);
	}
	++line_number_;
	return true;
}

std::string_view trim(std::string_view text) {
	while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
		text.remove_prefix(1);
	}
	while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
		text.remove_suffix(1);
	}
	return text;
}

std::optional<std::size_t> find_not_text(std::string_view line) {
	for (std::size_t i = 0; i < line.size();) {
		const auto value = static_cast<unsigned char>(line[i]);
		if (value >= 0x20 && value < 0x7F) {
			++i;
			continue;
		}
		const std::size_t length =
				value < 0x80 ? (is_control(line[i]) ? 0 : 1) : utf8_sequence_length(line.substr(i));
		if (length == 0) {
			return i;
		}
		i += length;
	}
	return std::nullopt;
}

Result<double> parse_number(std::string_view cell, double magnitude_max) {
	const std::string_view digits = cell.starts_with('+') ? cell.substr(1) : cell;
	double number = 0.0;
	const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
	const bool whole = end == digits.data() + digits.size() && !digits.empty();
	if (!whole || code == std::errc::invalid_argument || digits.starts_with('-') != cell.starts_with('-')) {
		return Error{ quoted(cell) + " is not a number" };
	}
	if (code == std::errc::result_out_of_range) {
		return Error{ quoted(cell) + " is out of range" };
	}
	if (!std::isfinite(number)) {
		return Error{ quoted(cell) + " is not finite" };
	}
	if (std::abs(number) > magnitude_max) {
		std::string message = quoted(cell) + " is out of range, at most ";
		append_number(message, magnitude_max);
		return Error{ std::move(message) };
	}
	return number;
}

void append_number(std::string &r_out, double number) {
	std::array<char, 32> digits;
	const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
	r_out.append(digits.data(), written.ptr);
}

void append_plain_text(std::string &r_out, std::string_view text) {
	const std::string_view trimmed = trim(text);
	std::replace_copy_if(trimmed.begin(), trimmed.end(), std::back_inserter(r_out), is_control, ' ');
}

void append_cell(std::string &r_out, std::string_view text) {
	const std::string_view cell = trim(text);
	if (!cell.starts_with('"') && cell.find(',') == std::string_view::npos) {
		append_plain_text(r_out, cell);
		return;
	}
	std::string plain;
	append_plain_text(plain, cell);
	r_out += '"';
	for (const char character : plain) {
		r_out.append(character == '"' ? 2 : 1, character);
	}
	r_out += '"';
}

std::string quoted(std::string_view cell) {
	std::string text = "'";
	for (const char character : cell.substr(0, SHOWN_MAX)) {
		const bool prints = character >= 0x20 && character < 0x7F;
		text += prints ? std::string(1, character) : "\\x" + hex_byte(character);
	}
	return text + (cell.size() > SHOWN_MAX ? "...'" : "'");
}

Error error_at(std::string_view source, std::size_t line, std::string_view what) {
	return Error{ std::string(source) + ':' + std::to_string(line) + ": " + std::string(what) };
}

Error error_at(std::string_view source, std::size_t line, std::string_view column, std::string_view what) {
	return error_at(source, line, shortened(column) + ": " + std::string(what));
}

std::optional<Error> check_header(
		std::string_view source, std::size_t line, const std::vector<std::string_view> &names) {
	std::set<std::string_view> seen;
	for (std::size_t i = 0; i < names.size(); ++i) {
		if (parse_number(names[i], std::numeric_limits<double>::max())) {
			return error_at(source, line, "no header line: the first line holds values, " + quoted(names[i]));
		}
		if (const auto offset = find_not_text(names[i])) {
			return error_at(source, line, "column " + std::to_string(i + 1), not_text(names[i][*offset]));
		}
		if (!seen.insert(names[i]).second) {
			return error_at(source, line, names[i], "the column comes twice");
		}
	}
	// Spreadsheets write ';' in locales with a decimal comma, and copy cells with tabs.
	for (const auto &[separator, name] : { std::pair(';', "';'"), std::pair('\t', "tabs") }) {
		if (names.size() == 1 && names.front().find(separator) != std::string_view::npos) {
			return error_at(source, line,
					"cells are separated by " + std::string(name) +
							": they must be by ',', and numbers have a '.'");
		}
	}
	return std::nullopt;
}

std::optional<Error> check_row(std::string_view source, std::size_t line, std::string_view text,
		const std::vector<std::string_view> &cells, const std::vector<std::string> &names) {
	if (const auto offset = find_not_text(text)) {
		const auto commas = static_cast<std::size_t>(
				std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*offset), ','));
		const std::string column =
				commas < names.size() ? names[commas] : "column " + std::to_string(commas + 1);
		return error_at(source, line, column, not_text(text[*offset]));
	}
	if (cells.size() < names.size()) {
		return error_at(source, line, names[cells.size()],
				"the row ends after " + counted(cells.size(), "cell") + " of " +
						std::to_string(names.size()));
	}
	if (cells.size() > names.size()) {
		return error_at(source, line,
				counted(cells.size(), "cell") + " under a header of " + std::to_string(names.size()));
	}
	return std::nullopt;
}

} // namespace steadyhand
