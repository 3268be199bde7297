#pragma once

#include "gesture/observation.h"
#include "hmm/discrete_hmm.h"

#include <functional>
#include <span>

namespace steadyhand {

/// A codebook: an observation's symbol is the index of the nearest codeword, after each axis is divided by
/// its scale.
class VectorQuantiser {
public:
	VectorQuantiser() = default;
	/// codebook: M x 2, in normalised units; scale: > 0 on both axes.
	VectorQuantiser(Eigen::MatrixX2d codebook, const Observation &scale);

	/// Generalised Lloyd algorithm with splitting (Linde, Buzo, Gray 1980, doi:10.1109/TCOM.1980.1094577);
	/// the scale is the standard deviation of each axis. Deterministic. Codewords are sorted by position,
	/// then velocity, so that symbols read as progress. Fewer distinct observations than `symbols` leave
	/// repeated codewords, which is harmless.
	/// go_on: called with the number of codewords found so far; false ends the search there, with fewer.
	static VectorQuantiser trained(std::span<const Observation> observations, int symbols,
			const std::function<bool(int codewords)> &go_on = {});

	[[nodiscard]] Symbol symbol(const Observation &observation) const;
	[[nodiscard]] int symbols() const { return static_cast<int>(codebook_.rows()); }
	[[nodiscard]] const Eigen::MatrixX2d &codebook() const { return codebook_; }
	[[nodiscard]] const Observation &scale() const { return scale_; }

private:
	Eigen::MatrixX2d codebook_;
	Observation scale_ = Observation::Ones();
	Eigen::MatrixX2d scaled_; ///< codebook_ / scale_, for symbol()
};

} // namespace steadyhand
