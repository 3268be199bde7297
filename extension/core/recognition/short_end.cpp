#include "recognition/short_end.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// A hand that is seen to stay, within so much, for so long.
struct Stay {
	double within;
	double s;
};
constexpr Stay SHORT{ .within = 0.05, .s = 0.4 };
/// Of one that is at the end, wherever the estimate has its phase: it may have hesitated on its way.
constexpr Stay AT_END{ .within = 0.02, .s = 0.2 };
constexpr double END = 0.95;
/// One that turns back from here ended there, once it has come back that far.
constexpr double TURNED_FROM = 0.8;
constexpr double TURNED_BY = 0.1;

constexpr const Stay &stay_at(double value) {
	return value > END ? AT_END : SHORT;
}

} // namespace

void ShortEnd::begin(double t_s) {
	stays_since_s_ = t_s;
	furthest_ = 0.0;
}

void ShortEnd::follow(double t_s, double value, bool is_seen, bool is_sure) {
	value_ = value;
	if (value < NEAREST || std::abs(value - stays_at_) > stay_at(value).within || !is_seen) {
		stays_since_s_ = t_s;
		stays_at_ = value;
	}
	furthest_ = is_sure ? std::max(furthest_, value) : furthest_;
}

bool ShortEnd::has_ended(double t_s) const {
	const bool has_turned = furthest_ > TURNED_FROM && value_ < furthest_ - TURNED_BY;
	return has_turned || t_s - stays_since_s_ > stay_at(value_).s;
}

} // namespace steadyhand
