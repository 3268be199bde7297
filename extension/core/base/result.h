#pragma once

#include <optional>
#include <string>
#include <utility>

namespace steadyhand {

/// An error message for the user: one sentence with the cause and the place, as "tracks/a.csv:12: index_x:
/// 'abc' is not a number".
struct Error {
	std::string message;
};

/// A value, or the error why there is none. The API of the core does not throw.
template <class T> class Result {
public:
	Result(T value) : value_(std::move(value)) {}
	Result(Error error) : error_(std::move(error)) {}

	[[nodiscard]] bool ok() const { return value_.has_value(); }
	explicit operator bool() const { return ok(); }

	// NOLINTBEGIN(bugprone-unchecked-optional-access): the caller checks ok()
	/// Requires ok().
	[[nodiscard]] const T &value() const & { return *value_; }
	[[nodiscard]] T &value() & { return *value_; }
	[[nodiscard]] T &&value() && { return *std::move(value_); }
	// NOLINTEND(bugprone-unchecked-optional-access)

	/// Requires !ok().
	[[nodiscard]] const std::string &error() const { return error_.message; }

private:
	std::optional<T> value_;
	Error error_;
};

} // namespace steadyhand
