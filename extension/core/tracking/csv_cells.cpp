// Splits a line of CSV into cells.

#include "tracking/csv_text.h"

#include <algorithm>
#include <array>

namespace steadyhand {

namespace {

/// Whether only blanks precede the next comma or the end of the line.
bool ends_cell(std::string_view after) {
	const std::size_t next = after.find_first_not_of(" \t");
	return next == std::string_view::npos || after[next] == ',';
}

/// Finds the ends of the quoted cells of one line. After a search without a result, later cells do not search
/// again, so the time is linear for any number of open quotes.
class QuotedCells {
public:
	struct Extent {
		std::size_t length = 0;          ///< of the quoted cell with its quotes; 0 if it is not quoted
		bool has_doubled_quotes = false; ///< quotes within the cell are doubled
	};

	/// Extent of the cell at the begin of text, the rest of the line. A doubled quote ends the cell only if
	/// no other quote does. Such cells are malformed.
	Extent at(std::string_view text) {
		if (!text.starts_with('"')) {
			return {};
		}
		for (const bool may_be_doubled : { true, false }) {
			if (const std::size_t end = find_end(text, may_be_doubled); end > 0) {
				return { end, may_be_doubled };
			}
		}
		return {};
	}

private:
	std::size_t find_end(std::string_view text, bool may_be_doubled) {
		bool &was_searched = was_searched_[may_be_doubled ? 1 : 0];
		for (std::size_t run = text.find('"', 1); run != std::string_view::npos;) {
			const std::size_t after = std::min(text.find_first_not_of('"', run), text.size());
			const bool is_single = (after - run) % 2 == 1; // one quote more than pairs
			if ((is_single || !may_be_doubled) && ends_cell(text.substr(after))) {
				return after;
			}
			// An earlier search has covered all runs but the first, which the cell's opening quote shortens.
			if (was_searched) {
				return 0;
			}
			run = text.find('"', after);
		}
		was_searched = true;
		return 0;
	}

	std::array<bool, 2> was_searched_{}; ///< to the line's end without a result; [1]: quotes may be doubled
};

/// Text with doubled quotes replaced by single ones. Appends to r_out if there are any.
std::string_view unescaped(std::string_view text, std::string &r_out) {
	if (text.find("\"\"") == std::string_view::npos) {
		return text;
	}
	const std::size_t begin = r_out.size();
	for (std::size_t i = 0; i < text.size(); i += text.substr(i).starts_with("\"\"") ? 2 : 1) {
		r_out += text[i];
	}
	return std::string_view(r_out).substr(begin);
}

} // namespace

void split_cells(std::string_view line, std::vector<std::string_view> &r_cells, std::string &r_unescaped) {
	r_cells.clear();
	r_unescaped.clear();
	r_unescaped.reserve(line.size()); // never reallocated, so that views into it stay valid
	QuotedCells quoted_cells;
	for (std::size_t comma = 0; comma != std::string_view::npos; line.remove_prefix(comma + 1)) {
		line = trim(line);
		const QuotedCells::Extent extent = quoted_cells.at(line);
		comma = line.find(',', extent.length);
		const std::string_view inside =
				extent.length > 0 ? line.substr(1, extent.length - 2) : line.substr(0, comma);
		r_cells.push_back(trim(extent.has_doubled_quotes ? unescaped(inside, r_unescaped) : inside));
		if (comma == std::string_view::npos) {
			return;
		}
	}
}

} // namespace steadyhand
