#pragma once

#include <optional>
#include <string>
#include <utility>

namespace steadyhand {

/// What went wrong and where, as one sentence for the user: "tracks/a.csv:12: index_x: 'abc' is not a
/// number".
struct Error {
	std::string message;
};

/// A value, or the one error that kept it from being made. The core never throws across its API.
template <class T> class Result {
public:
	Result(T value) : value_(std::move(value)) {}
	Result(Error error) : error_(std::move(error)) {}

	[[nodiscard]] bool ok() const { return value_.has_value(); }
	explicit operator bool() const { return ok(); }

	// NOLINTBEGIN(bugprone-unchecked-optional-access): to ask is the caller's
	/// Only where ok().
	[[nodiscard]] const T &value() const & { return *value_; }
	[[nodiscard]] T &value() & { return *value_; }
	[[nodiscard]] T &&value() && { return *std::move(value_); }
	// NOLINTEND(bugprone-unchecked-optional-access)

	/// Only where not ok().
	[[nodiscard]] const std::string &error() const { return error_.message; }

private:
	std::optional<T> value_;
	Error error_;
};

} // namespace steadyhand
