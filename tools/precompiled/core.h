// What most of the core's headers bring in, compiled once a variant. Sources include what they need all the
// same: clang-tidy reads them without this file.
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>
