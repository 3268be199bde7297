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

/// What is wrong with a document, and where: a value of it, or the object in which one is missing. Thrown by
/// those that read a field, for the one who parses to catch.
struct Fault : std::runtime_error {
	Fault(const Json &value, const std::string &what) : std::runtime_error(what), place(&value) {}
	const Json *place; ///< of the document that is read
};

/// Numbers that read back to the same bits; what is not finite as null.
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

/// No object of a file has more members: to find one, an ordered_json goes through all of them, so a file of
/// many would take quadratic time.
inline constexpr std::size_t MOST_MEMBERS = 64;

/// Reads `text` into r_document. Throws Json::exception where it is not JSON, and a Fault at r_document where
/// an object has more than MOST_MEMBERS members.
void parse(std::string_view text, Json &r_document);

// "SOURCE:LINE: what is wrong", of each of the three ways in which reading a text ends.
[[nodiscard]] Error error_of(const Json::parse_error &fault, std::string_view text, std::string_view source);
[[nodiscard]] Error error_of(const Json::exception &fault, std::string_view text, std::string_view source);
[[nodiscard]] Error error_of(
		const Fault &fault, const Json &document, std::string_view text, std::string_view source);

/// What `read` makes of the document, or the one error, with its line in the file `source`.
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

/// Throws a Fault where the members "format" and "version" differ.
void require_format(const Json &document, const char *format, int version);
[[nodiscard]] const Json &member(const Json &object, const char *key);
/// Finite.
[[nodiscard]] double number(const Json &object, const char *key);
[[nodiscard]] double within(const Json &object, const char *key, double smallest, double largest);
[[nodiscard]] std::string text(const Json &object, const char *key);
[[nodiscard]] bool flag(const Json &object, const char *key);
/// With one entry at least.
[[nodiscard]] const Json &array(const Json &object, const char *key);
/// Numbers, of 1e9 at most; with null_is_log_zero logarithms, null for that of 0. key: what they are called.
[[nodiscard]] Eigen::VectorXd vector(const Json &values, const char *key, bool null_is_log_zero);
[[nodiscard]] Eigen::Vector3d point(const Json &object, const char *key);
/// Rows of equal length, as of vector().
[[nodiscard]] Eigen::MatrixXd matrix(const Json &object, const char *key, bool null_is_log_zero);

} // namespace steadyhand::json_fields
