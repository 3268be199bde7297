#pragma once

#include "gesture/observation.h"
#include "hmm/discrete_hmm.h"

#include <functional>
#include <span>

namespace steadyhand {

/// A codebook of points with SIZE numbers. The symbol of a point is the index of the nearest codeword, after
/// each axis is divided by its scale.
template <int SIZE> class Codebook {
public:
	using Point = Eigen::Matrix<double, SIZE, 1>;
	using Codewords = Eigen::Matrix<double, Eigen::Dynamic, SIZE>; ///< one codeword in each row

	Codebook() = default;
	/// codebook: M x SIZE, in the units of the points. scale: > 0 for each axis.
	Codebook(Codewords codebook, const Point &scale);

	/// Generalised Lloyd algorithm with splitting (Linde, Buzo, Gray 1980, doi:10.1109/TCOM.1980.1094577).
	/// The scale is the standard deviation of each axis. Deterministic. Codewords are sorted by their first
	/// number, then by the second. If there are fewer distinct points than `symbols`, some codewords are
	/// equal, which is harmless.
	/// go_on: called with the number of codewords so far; if it returns false, the codebook has only these.
	/// most_iterations: of the Lloyd algorithm after each split.
	static Codebook trained(std::span<const Point> observations, int symbols,
			const std::function<bool(int codewords)> &go_on = {}, int most_iterations = 100);

	[[nodiscard]] Symbol symbol(const Point &observation) const;
	[[nodiscard]] int symbols() const { return static_cast<int>(codebook_.rows()); }
	[[nodiscard]] const Codewords &codebook() const { return codebook_; }
	[[nodiscard]] const Point &scale() const { return scale_; }

private:
	Codewords codebook_;
	Point scale_ = Point::Ones();
	Codewords scaled_; ///< codebook_ / scale_, for symbol()
};

/// Codebook of Observations, for the HMM of a GestureModel.
using VectorQuantiser = Codebook<2>;
/// Codebook of MotionObservations, for the HMMs of a ClassifierModel.
using MotionCodebook = Codebook<6>;

extern template class Codebook<2>;
extern template class Codebook<6>;

} // namespace steadyhand
