#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <random>

namespace steadyhand::bench {

/// Random numbers. Equal seeds give equal numbers.
class Draws {
public:
	explicit Draws(std::uint64_t seed) : random_(7919 * seed + 13) {}

	double between(double low, double high) {
		return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
	}
	/// 0 to count - 1.
	std::size_t below(std::size_t count) { return random_() % count; }
	double normal() { return normal_(random_); }
	Eigen::Vector3d normals() {
		const double z = normal(), y = normal(), x = normal();
		return { x, y, z };
	}
	/// Uniform on the sphere.
	Eigen::Vector3d unit_vector() { return normals().normalized(); }
	/// Uniform on the part of the sphere where is_good is true.
	template <class Predicate> Eigen::Vector3d unit_vector_where(Predicate is_good) {
		Eigen::Vector3d drawn = unit_vector();
		while (!is_good(drawn)) {
			drawn = unit_vector();
		}
		return drawn;
	}

private:
	std::mt19937_64 random_;
	std::normal_distribution<double> normal_;
};

} // namespace steadyhand::bench
