#pragma once

#include "gesture/gesture_model.h"
#include "signal/lanes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace steadyhand {

struct LaneCurvePoint {
	LaneVector value, slope, curvature;
};

/// evaluate_onwards() of one model, made fast for the many hypotheses that ask for it, side by side: the
/// element of a phase is looked up, and powers that no element has are left out. Allocates when made.
class ElementCurve {
public:
	/// model must have elements.
	explicit ElementCurve(const GestureModel &model);

	/// evaluate_onwards(model, phase), up to rounding; 0 where the phase is no number.
	[[nodiscard]] STEADYHAND_INLINE LaneCurvePoint at(const LaneVector &phase) const {
		const LaneVector held = within_one(phase);
		std::array<const Piece *, LANES> pieces;
		for (std::size_t l = 0; l < LANES; ++l) {
			pieces[l] = &piece(held[l]);
		}
		const auto of_each = [&](const auto &number) STEADYHAND_INLINE_LAMBDA {
			return each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA { return number(*pieces[l]); });
		};
		const LaneVector rate = of_each([](const Piece &p) STEADYHAND_INLINE_LAMBDA { return p.rate; });
		const LaneVector s =
				(held - of_each([](const Piece &p) STEADYHAND_INLINE_LAMBDA { return p.begin; })) * rate;
		LaneVector value{}, first{}, half_second{};
		for (std::size_t k = terms_; k-- > 0;) {
			half_second = half_second * s + first;
			first = first * s + value;
			value = value * s +
					of_each([k](const Piece &p) STEADYHAND_INLINE_LAMBDA { return p.coefficients[k]; });
		}
		LaneCurvePoint point{ value, first * rate, 2.0 * half_second * rate * rate };
		if (any(phase > 1.0)) {
			const LaneVector fading = exponential(phase > 1.0 ? (1.0 - phase) / RUN_OUT : LaneVector{});
			const LaneVector slope = end_.slope * fading;
			point.value = phase > 1.0 ? end_.value + end_.slope * RUN_OUT * (1.0 - fading) : point.value;
			point.slope = phase > 1.0 ? slope : point.slope;
			point.curvature = phase > 1.0 ? slope / -RUN_OUT : point.curvature;
		}
		point.value = phase > 0.0 ? point.value : LaneVector{};
		point.slope = phase > 0.0 ? point.slope : LaneVector{};
		point.curvature = phase > 0.0 ? point.curvature : LaneVector{};
		return point;
	}

private:
	static constexpr std::size_t CELLS = 64;

	/// An element.
	struct Piece {
		double begin, end, rate; ///< of phase; 1 / (end - begin)
		std::array<double, Polynomial::MAX_DEGREE + 1> coefficients;
	};

	std::vector<Piece> pieces_;
	std::size_t terms_ = 1;                       ///< coefficients that are not 0 in every element
	std::array<std::uint8_t, CELLS + 1> piece_{}; ///< that a cell of phase begins in
	CurvePoint end_;

	/// 0 <= phase <= 1
	[[nodiscard]] const Piece &piece(double phase) const {
		std::size_t i =
				piece_[static_cast<std::size_t>(static_cast<int>(phase * static_cast<double>(CELLS)))];
		while (i + 1 < pieces_.size() && phase >= pieces_[i].end) {
			++i;
		}
		return pieces_[i];
	}
};

} // namespace steadyhand
