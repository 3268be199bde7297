#include "gesture/vector_quantiser.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace steadyhand {
namespace {

Symbol nearest(const Eigen::MatrixX2d &codewords, const Observation &point) {
	Eigen::Index best = 0;
	(codewords.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&best);
	return static_cast<Symbol>(best);
}

/// Lloyd iterations until no codeword moves by more than rounding, or 100 of them.
void settle(Eigen::MatrixX2d &r_codewords, std::span<const Observation> points) {
	for (int iteration = 0; iteration < 100; ++iteration) {
		Eigen::MatrixX2d sums = Eigen::MatrixX2d::Zero(r_codewords.rows(), 2);
		Eigen::VectorXd counts = Eigen::VectorXd::Zero(r_codewords.rows());
		for (const Observation &point : points) {
			const Symbol k = nearest(r_codewords, point);
			sums.row(k) += point.transpose();
			counts(k) += 1.0;
		}
		double moved = 0.0;
		for (Eigen::Index k = 0; k < r_codewords.rows(); ++k) {
			if (counts(k) > 0.0) {
				const Eigen::RowVector2d centroid = sums.row(k) / counts(k);
				moved = std::max(moved, (centroid - r_codewords.row(k)).norm());
				r_codewords.row(k) = centroid;
			}
		}
		if (moved < 1e-9) {
			return;
		}
	}
}

/// The cell whose points lie furthest from their codeword, in sum; and half its spread, along which it is
/// split.
std::pair<Eigen::Index, Eigen::RowVector2d> widest_cell(
		const Eigen::MatrixX2d &codewords, std::span<const Observation> points) {
	Eigen::MatrixX2d spread = Eigen::MatrixX2d::Zero(codewords.rows(), 2);
	Eigen::VectorXd counts = Eigen::VectorXd::Zero(codewords.rows());
	for (const Observation &point : points) {
		const Symbol k = nearest(codewords, point);
		spread.row(k) += (point.transpose() - codewords.row(k)).array().square().matrix();
		counts(k) += 1.0;
	}
	Eigen::Index widest = 0;
	spread.rowwise().sum().maxCoeff(&widest);
	const double n = std::max(counts(widest), 1.0);
	return { widest, (spread.row(widest) / n).array().sqrt() * 0.5 };
}

} // namespace

VectorQuantiser::VectorQuantiser(Eigen::MatrixX2d codebook, const Observation &scale) :
		codebook_(std::move(codebook)), scale_(scale),
		scaled_(codebook_.array().rowwise() / scale_.transpose().array()) {}

Symbol VectorQuantiser::symbol(const Observation &observation) const {
	return nearest(scaled_, observation.cwiseQuotient(scale_));
}

VectorQuantiser VectorQuantiser::trained(std::span<const Observation> observations, int symbols,
		const std::function<bool(int codewords)> &go_on) {
	Observation mean = Observation::Zero();
	for (const Observation &o : observations) {
		mean += o;
	}
	const double n = std::max<double>(static_cast<double>(observations.size()), 1.0);
	mean /= n;
	Observation scale = Observation::Zero();
	for (const Observation &o : observations) {
		scale += (o - mean).cwiseAbs2();
	}
	scale = (scale / n).cwiseSqrt();
	// An axis without spread decides nothing; 1 keeps it finite.
	scale = (scale.array() > 0.0).select(scale, Observation::Ones());

	std::vector<Observation> points;
	points.reserve(observations.size());
	for (const Observation &o : observations) {
		points.push_back(o.cwiseQuotient(scale));
	}
	Eigen::MatrixX2d codewords = mean.cwiseQuotient(scale).transpose();
	while (codewords.rows() < symbols && (!go_on || go_on(static_cast<int>(codewords.rows())))) {
		const auto [cell, offset] = widest_cell(codewords, points);
		const Eigen::RowVector2d centre = codewords.row(cell);
		codewords.conservativeResize(codewords.rows() + 1, Eigen::NoChange);
		codewords.row(cell) = centre - offset;
		codewords.bottomRows<1>() = centre + offset;
		settle(codewords, points);
	}

	std::vector<Eigen::Index> order(static_cast<std::size_t>(codewords.rows()));
	std::iota(order.begin(), order.end(), Eigen::Index{ 0 });
	std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
		return codewords(a, 0) != codewords(b, 0) ? codewords(a, 0) < codewords(b, 0)
												  : codewords(a, 1) < codewords(b, 1);
	});
	Eigen::MatrixX2d sorted(codewords.rows(), 2);
	for (Eigen::Index k = 0; k < sorted.rows(); ++k) {
		sorted.row(k) = codewords.row(order[static_cast<std::size_t>(k)]).cwiseProduct(scale.transpose());
	}
	return { std::move(sorted), scale };
}

} // namespace steadyhand
