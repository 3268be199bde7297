#include "gesture/vector_quantiser.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace steadyhand {
namespace {

// clang 14, which builds the fuzzers, needs a typename that C++20 makes optional.
template <int SIZE> using Point = typename Codebook<SIZE>::Point; // NOLINT(readability-redundant-typename)
template <int SIZE>
using Codewords = typename Codebook<SIZE>::Codewords; // NOLINT(readability-redundant-typename)

/// Index of the nearest codeword. Computes eight distances at once, for vector registers.
template <int SIZE> Symbol nearest(const Codewords<SIZE> &codewords, const Point<SIZE> &point) {
	constexpr Eigen::Index BLOCK = 8;
	const Eigen::Index n = codewords.rows();
	Eigen::Index best = 0;
	double least = INFINITY;
	for (Eigen::Index i = 0; i < n; i += BLOCK) {
		Eigen::Array<double, BLOCK, 1> distances = Eigen::Array<double, BLOCK, 1>::Constant(INFINITY);
		if (i + BLOCK <= n) {
			distances.setZero();
			for (Eigen::Index k = 0; k < SIZE; ++k) {
				distances += (codewords.col(k).template segment<BLOCK>(i).array() - point(k)).square();
			}
		} else {
			for (Eigen::Index j = i; j < n; ++j) {
				distances(j - i) = (codewords.row(j) - point.transpose()).squaredNorm();
			}
		}
		Eigen::Index nearest_of_block = 0;
		if (const double distance = distances.minCoeff(&nearest_of_block); distance < least) {
			least = distance;
			best = i + nearest_of_block;
		}
	}
	return static_cast<Symbol>(best);
}

/// Lloyd iterations, until no codeword moves by more than 1e-9, or most_iterations.
template <int SIZE>
void settle(Codewords<SIZE> &r_codewords, std::span<const Point<SIZE>> points, int most_iterations) {
	for (int iteration = 0; iteration < most_iterations; ++iteration) {
		Codewords<SIZE> sums = Codewords<SIZE>::Zero(r_codewords.rows(), SIZE);
		Eigen::VectorXd counts = Eigen::VectorXd::Zero(r_codewords.rows());
		for (const Point<SIZE> &point : points) {
			const Symbol k = nearest<SIZE>(r_codewords, point);
			sums.row(k) += point.transpose();
			counts(k) += 1.0;
		}
		double moved = 0.0;
		for (Eigen::Index k = 0; k < r_codewords.rows(); ++k) {
			if (counts(k) > 0.0) {
				const Eigen::Matrix<double, 1, SIZE> centroid = sums.row(k) / counts(k);
				moved = std::max(moved, (centroid - r_codewords.row(k)).norm());
				r_codewords.row(k) = centroid;
			}
		}
		if (moved < 1e-9) {
			return;
		}
	}
}

/// The cell with the greatest sum of squared distances from its codeword, and half its standard deviation for
/// each axis: the offset of the split.
template <int SIZE>
std::pair<Eigen::Index, Eigen::Matrix<double, 1, SIZE>> widest_cell(
		const Codewords<SIZE> &codewords, std::span<const Point<SIZE>> points) {
	Codewords<SIZE> spread = Codewords<SIZE>::Zero(codewords.rows(), SIZE);
	Eigen::VectorXd counts = Eigen::VectorXd::Zero(codewords.rows());
	for (const Point<SIZE> &point : points) {
		const Symbol k = nearest<SIZE>(codewords, point);
		spread.row(k) += (point.transpose() - codewords.row(k)).array().square().matrix();
		counts(k) += 1.0;
	}
	Eigen::Index widest = 0;
	spread.rowwise().sum().maxCoeff(&widest);
	const double n = std::max(counts(widest), 1.0);
	return { widest, (spread.row(widest) / n).array().sqrt() * 0.5 };
}

} // namespace

template <int SIZE>
Codebook<SIZE>::Codebook(Codewords codebook, const Point &scale) :
		codebook_(std::move(codebook)), scale_(scale),
		scaled_(codebook_.array().rowwise() / scale_.transpose().array()) {}

template <int SIZE> Symbol Codebook<SIZE>::symbol(const Point &observation) const {
	return nearest<SIZE>(scaled_, observation.cwiseQuotient(scale_));
}

template <int SIZE>
Codebook<SIZE> Codebook<SIZE>::trained(std::span<const Point> observations, int symbols,
		const std::function<bool(int codewords)> &go_on, int most_iterations) {
	Point mean = Point::Zero();
	for (const Point &o : observations) {
		mean += o;
	}
	const double n = std::max<double>(static_cast<double>(observations.size()), 1.0);
	mean /= n;
	Point scale = Point::Zero();
	for (const Point &o : observations) {
		scale += (o - mean).cwiseAbs2();
	}
	scale = (scale / n).cwiseSqrt();
	// An axis without spread has no effect. A scale of 1 keeps it finite.
	scale = (scale.array() > 0.0).select(scale, Point::Ones());

	std::vector<Point> points;
	points.reserve(observations.size());
	for (const Point &o : observations) {
		points.push_back(o.cwiseQuotient(scale));
	}
	Codewords codewords = mean.cwiseQuotient(scale).transpose();
	while (codewords.rows() < symbols && (!go_on || go_on(static_cast<int>(codewords.rows())))) {
		const auto [cell, offset] = widest_cell<SIZE>(codewords, points);
		const Eigen::Matrix<double, 1, SIZE> centre = codewords.row(cell);
		codewords.conservativeResize(codewords.rows() + 1, Eigen::NoChange);
		codewords.row(cell) = centre - offset;
		codewords.template bottomRows<1>() = centre + offset;
		settle<SIZE>(codewords, points, most_iterations);
	}

	std::vector<Eigen::Index> order(static_cast<std::size_t>(codewords.rows()));
	std::iota(order.begin(), order.end(), Eigen::Index{ 0 });
	std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
		return codewords(a, 0) != codewords(b, 0) ? codewords(a, 0) < codewords(b, 0)
												  : codewords(a, 1) < codewords(b, 1);
	});
	Codewords sorted(codewords.rows(), SIZE);
	for (Eigen::Index k = 0; k < sorted.rows(); ++k) {
		sorted.row(k) = codewords.row(order[static_cast<std::size_t>(k)]).cwiseProduct(scale.transpose());
	}
	return { std::move(sorted), scale };
}

template class Codebook<2>;
template class Codebook<6>;

} // namespace steadyhand
