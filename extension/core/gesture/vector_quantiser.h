#pragma once

#include "gesture/observation.h"
#include "hmm/discrete_hmm.h"

#include <functional>
#include <span>

namespace steadyhand {

/// A codebook: the symbol of a point of SIZE numbers is the index of the nearest codeword, after each axis is
/// divided by its scale.
template <int SIZE> class Codebook {
public:
	using Point = Eigen::Matrix<double, SIZE, 1>;
	using Codewords = Eigen::Matrix<double, Eigen::Dynamic, SIZE>; ///< one a row

	Codebook() = default;
	/// codebook: M x SIZE, in the points' units; scale: > 0 on each axis.
	Codebook(Codewords codebook, const Point &scale);

	/// Generalised Lloyd algorithm with splitting (Linde, Buzo, Gray 1980, doi:10.1109/TCOM.1980.1094577);
	/// the scale is the standard deviation of each axis. Deterministic. Codewords are sorted by their first
	/// number (position), then the second (velocity), so that symbols read as progress. Fewer distinct
	/// points than `symbols` leave repeated codewords, which is harmless.
	/// go_on: called with the number of codewords found so far; false ends the search there, with fewer.
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

/// Of Observations: what the HMM of a GestureModel reads.
using VectorQuantiser = Codebook<2>;
/// Of MotionObservations: what the HMMs of a ClassifierModel read.
using MotionCodebook = Codebook<6>;

extern template class Codebook<2>;
extern template class Codebook<6>;

} // namespace steadyhand
