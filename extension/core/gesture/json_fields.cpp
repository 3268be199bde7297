#include "gesture/json_fields.h"

#include "tracking/csv_text.h"
#include "tracking/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace steadyhand::json_fields {
namespace {

/// Number of values that begin before `place` in the document's text.
std::size_t values_before(const Json &document, const Json *place) {
	std::vector<const Json *> ahead{ &document };
	for (std::size_t before = 0; !ahead.empty(); ++before) {
		const Json *value = ahead.back();
		if (value == place) {
			return before;
		}
		ahead.pop_back();
		for (auto child = value->rbegin(); child != value->rend() && value->is_structured(); ++child) {
			ahead.push_back(&*child);
		}
	}
	return 0;
}

/// Line of the character at index `place`, from 1.
std::size_t line_at(std::string_view text, std::size_t place) {
	const std::string_view passed = text.substr(0, place);
	return 1 + static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
}

/// Line on which value number `before` begins, from 0, in valid JSON text.
std::size_t line_of_value(std::string_view text, std::size_t before) {
	constexpr std::string_view SPACE = " \t\r\n";
	std::size_t i = text.find_first_not_of(SPACE);
	for (; i < text.size(); i = text.find_first_not_of(SPACE, i)) {
		const std::size_t begin = i++;
		if (text[begin] == '"') {
			while (text[i] != '"') {
				i += text[i] == '\\' ? 2 : 1;
			}
			const std::size_t next = text.find_first_not_of(SPACE, ++i);
			if (next < text.size() && text[next] == ':') {
				continue;
			}
		} else if (std::string_view(",:]}").find(text[begin]) != std::string_view::npos) {
			continue;
		} else if (text[begin] != '[' && text[begin] != '{') {
			i = std::min(text.find_first_of(" \t\r\n,]}", i), text.size());
		}
		if (before-- == 0) {
			i = begin;
			break;
		}
	}
	return line_at(text, i);
}

/// Scans a text until an object has more than MOST_MEMBERS members, without building a document.
class MemberCounter : public nlohmann::json_sax<Json> {
public:
	[[nodiscard]] bool is_exceeded() const { return is_exceeded_; }

	bool start_object(std::size_t /*elements*/) override {
		members_.push_back(0);
		return true;
	}
	bool key(std::string & /*name*/) override {
		is_exceeded_ = ++members_.back() > MOST_MEMBERS;
		return !is_exceeded_;
	}
	bool end_object() override {
		members_.pop_back();
		return true;
	}
	bool null() override { return true; }
	bool boolean(bool /*value*/) override { return true; }
	bool number_integer(Json::number_integer_t /*value*/) override { return true; }
	bool number_unsigned(Json::number_unsigned_t /*value*/) override { return true; }
	bool number_float(Json::number_float_t /*value*/, const std::string & /*digits*/) override {
		return true;
	}
	bool string(std::string & /*value*/) override { return true; }
	bool binary(Json::binary_t & /*value*/) override { return true; }
	bool start_array(std::size_t /*elements*/) override { return true; }
	bool end_array() override { return true; }
	/// Json::parse() reports the error later.
	bool parse_error(std::size_t /*place*/, const std::string & /*token*/,
			const nlohmann::detail::exception & /*fault*/) override {
		return false;
	}

private:
	std::vector<std::size_t> members_; ///< member counts of the open objects
	bool is_exceeded_ = false;
};

Error error_at(std::string_view source, std::size_t line, std::string_view what) {
	return { std::string(source) + ":" + std::to_string(line) + ": " + std::string(what) };
}

} // namespace

void parse(std::string_view text, Json &r_document) {
	MemberCounter counter;
	Json::sax_parse(text, &counter);
	if (counter.is_exceeded()) {
		throw Fault(r_document, "an object has more than " + std::to_string(MOST_MEMBERS) + " members");
	}
	r_document = Json::parse(text);
}

Error error_of(const Json::parse_error &fault, std::string_view text, std::string_view source) {
	return error_at(source, line_at(text, std::max<std::size_t>(fault.byte, 1) - 1),
			fault.byte > text.size() ? "not valid JSON: the file ends here" : "not valid JSON");
}

Error error_of(const Json::exception &fault, std::string_view text, std::string_view source) {
	// "[json.exception.out_of_range.406] number overflow parsing '1e999'" has no position, so search it.
	const std::string_view what = fault.what();
	const std::size_t begin = what.find('\''), end = what.rfind('\'');
	const bool names_number = begin < end && end != std::string_view::npos;
	const std::size_t at = names_number ? text.find(what.substr(begin + 1, end - begin - 1)) : 0;
	return error_at(source, line_at(text, at), what.substr(what.find("] ") + 2));
}

Error error_of(const Fault &fault, const Json &document, std::string_view text, std::string_view source) {
	return error_at(source, line_of_value(text, values_before(document, fault.place)), fault.what());
}

void require_format(const Json &document, const char *format, int version) {
	if (!document.is_object() || text(document, "format") != format) {
		throw Fault(document, std::string("format: not a ") + format + " file");
	}
	if (number(document, "version") != version) {
		throw Fault(document["version"],
				"version: must be " + std::to_string(version) +
						". Update SteadyHand, or make the file again");
	}
}

const Json &member(const Json &object, const char *key) {
	if (!object.is_object() || !object.contains(key)) {
		throw Fault(object, std::string(key) + ": missing");
	}
	return object[key];
}

double number(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_number() || !std::isfinite(value.get<double>())) {
		throw Fault(value, std::string(key) + ": not a number");
	}
	return value.get<double>();
}

double within(const Json &object, const char *key, double smallest, double largest) {
	const double value = number(object, key);
	if (value < smallest || value > largest) {
		std::string message = std::string(key) + ": not within ";
		append_number(message, smallest);
		message += " .. ";
		append_number(message, largest);
		message += ", is ";
		append_number(message, value);
		throw Fault(object[key], message);
	}
	return value;
}

std::string text(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_string()) {
		throw Fault(value, std::string(key) + ": not a string");
	}
	return value.get<std::string>();
}

bool flag(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_boolean()) {
		throw Fault(value, std::string(key) + ": not true or false");
	}
	return value.get<bool>();
}

const Json &array(const Json &object, const char *key) {
	const Json &value = member(object, key);
	if (!value.is_array() || value.empty()) {
		throw Fault(value, std::string(key) + ": not an array with entries");
	}
	return value;
}

Eigen::VectorXd vector(const Json &values, const char *key, bool null_is_log_zero) {
	if (!values.is_array()) {
		throw Fault(values, std::string(key) + ": not an array");
	}
	Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
	for (std::size_t i = 0; i < values.size(); ++i) {
		if (values[i].is_null() && null_is_log_zero) {
			out(static_cast<Eigen::Index>(i)) = -std::numeric_limits<double>::infinity();
		} else if (values[i].is_number()) {
			out(static_cast<Eigen::Index>(i)) = values[i].get<double>();
			if (!null_is_log_zero && std::abs(values[i].get<double>()) > FARTHEST_M) {
				throw Fault(values[i], std::string(key) + "[" + std::to_string(i) + "]: beyond 1e9");
			}
		} else {
			throw Fault(values[i], std::string(key) + "[" + std::to_string(i) + "]: not a number");
		}
	}
	return out;
}

Eigen::Vector3d point(const Json &object, const char *key) {
	const Eigen::VectorXd values = vector(member(object, key), key, false);
	if (values.size() != 3) {
		throw Fault(object[key], std::string(key) + ": not three numbers");
	}
	return values;
}

Eigen::MatrixXd matrix(const Json &object, const char *key, bool null_is_log_zero) {
	const Json &rows = array(object, key);
	Eigen::MatrixXd out;
	for (std::size_t i = 0; i < rows.size(); ++i) {
		const Eigen::VectorXd row = vector(rows[i], key, null_is_log_zero);
		if (i == 0) {
			out.resize(static_cast<Eigen::Index>(rows.size()), row.size());
		}
		if (row.size() != out.cols()) {
			throw Fault(rows[i],
					std::string(key) + ", row " + std::to_string(i) + ": " + std::to_string(row.size()) +
							" numbers where the first row has " + std::to_string(out.cols()));
		}
		out.row(static_cast<Eigen::Index>(i)) = row.transpose();
	}
	return out;
}

} // namespace steadyhand::json_fields
