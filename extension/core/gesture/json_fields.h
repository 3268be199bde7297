#pragma once

#include "base/result.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace steadyhand::json_fields {

using Json = nlohmann::ordered_json;

/// A fault of a document, and its place: a value, or the object in which a value is missing. The functions
/// that read a field throw it; read_text() catches it.
struct Fault : std::runtime_error {
	Fault(const Json &value, const std::string &what) : std::runtime_error(what), place(&value) {}
	const Json *place; ///< within the document
};

/// Numbers that read back to the same bits. Numbers that are not finite become null.
template <class Row> Json row_to_json(const Row &row) {
	Json out = Json::array();
	for (Eigen::Index i = 0; i < row.size(); ++i) {
		out.push_back(std::isfinite(row(i)) ? Json(row(i)) : Json());
	}
	return out;
}
template <class Matrix> Json matrix_to_json(const Matrix &matrix) {
	Json out = Json::array();
	for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
		out.push_back(row_to_json(matrix.row(i)));
	}
	return out;
}

/// Most members of an object. ordered_json searches members linearly, so an object with many would take
/// quadratic time.
inline constexpr std::size_t MOST_MEMBERS = 64;

/// Parses `text` into r_document. Throws Json::exception if it is not JSON, and a Fault at r_document if an
/// object has more than MOST_MEMBERS members.
void parse(std::string_view text, Json &r_document);

// "SOURCE:LINE: fault" for each of the three exceptions.
[[nodiscard]] Error error_of(const Json::parse_error &fault, std::string_view text, std::string_view source);
[[nodiscard]] Error error_of(const Json::exception &fault, std::string_view text, std::string_view source);
[[nodiscard]] Error error_of(
		const Fault &fault, const Json &document, std::string_view text, std::string_view source);

/// Parses the text and returns read(document), or the first error with its line in `source`.
template <class Value, class Read>
[[nodiscard]] Result<Value> read_text(std::string_view text, std::string_view source, Read read) {
	Json document; // outlives the faults, which point into it
	try {
		parse(text, document);
		return read(document);
	} catch (const Json::parse_error &fault) {
		return error_of(fault, text, source);
	} catch (const Json::exception &fault) {
		return error_of(fault, text, source);
	} catch (const Fault &fault) {
		return error_of(fault, document, text, source);
	}
}

// The functions below throw a Fault if the value is missing or invalid.

/// Requires these values of the members "format" and "version".
void require_format(const Json &document, const char *format, int version);
[[nodiscard]] const Json &member(const Json &object, const char *key);
/// A finite number.
[[nodiscard]] double number(const Json &object, const char *key);
[[nodiscard]] double within(const Json &object, const char *key, double smallest, double largest);
[[nodiscard]] std::string text(const Json &object, const char *key);
[[nodiscard]] bool flag(const Json &object, const char *key);
/// An array with at least one entry.
[[nodiscard]] const Json &array(const Json &object, const char *key);
/// Numbers of at most 1e9. With null_is_log_zero: logarithms, null for -infinity. key: name in error
/// messages.
[[nodiscard]] Eigen::VectorXd vector(const Json &values, const char *key, bool null_is_log_zero);
[[nodiscard]] Eigen::Vector3d point(const Json &object, const char *key);
/// Rows of equal length, each read by vector().
[[nodiscard]] Eigen::MatrixXd matrix(const Json &object, const char *key, bool null_is_log_zero);

} // namespace steadyhand::json_fields
