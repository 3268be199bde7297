#pragma once

#include "hmm/linear_hmm.h"
#include "hmm/scaled_number.h"

#include <algorithm>
#include <type_traits>

namespace steadyhand {

/// Recursion v_j(t) = b_j(o_t) sum_i a_ij v_i(t - 1) for LANES sequences at once. It gives the forward
/// variable (Rabiner 1989 eq. (20)); with A transposed, the backward variable times its emission.
///
/// It works with probabilities, and is exact to rounding at any length. With one common scale for each frame,
/// states of a left-right model underflow, although paths through them may win later. So each state has its
/// own scale, v = m 2^e.
///
/// Exponents are renormalised only every few frames. The smallest entries of A and B bound the number of
/// frames in which no mantissa can underflow. Until then the exponents are part of the transitions and cost
/// nothing. Without such a bound (zeros in B, states without a self-transition, states whose likelihoods
/// differ too much) exponents are renormalised at each frame. float, with its short exponents, needs this
/// often.
template <int LANES, class Scalar = double> class ScaledRecursion {
	/// In bits. A mantissa is at TOP after a renormalisation, and between TOP - FALL and TOP + RISE until the
	/// next. So the product of two mantissas is in range (in float: of a mantissa and a scaled transition).
	/// A term that underflows in a product with a power of two is negligible in every sum. RISE also leaves
	/// room for the factors of ExpectedCounts.
	static constexpr bool IS_SHORT = std::is_same_v<Scalar, float>;
	static constexpr int TOP = IS_SHORT ? 10 : 250, FALL = IS_SHORT ? 80 : 600, RISE = IS_SHORT ? 40 : 50;

public:
	/// log2 of the smallest mantissa other than 0.
	static constexpr int LEAST = TOP - FALL;

	/// a: N x N, (from, to). b: N x any, all emissions that occur. Only the constructor allocates.
	ScaledRecursion(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b);

	/// Call it before start() of the lanes with new sequences.
	void reset() { frames_left_ = FALL; }
	/// Sets v of a lane to p_j b_j, N probabilities each. The product may be below the range of double.
	void start(int lane, const double *p, const double *b);
	/// b: N x LANES, the emission of state j in lane l at j * LANES + l. exact_b: the same in double, because
	/// float has no number below 1e-45. Returns true if exponents have changed.
	bool step(const Scalar *b, const double *exact_b);

	/// N x LANES, in the layout of step().
	[[nodiscard]] const Scalar *mantissas() const { return m_.data(); }
	[[nodiscard]] const std::int64_t *exponents() const { return e_.data(); }
	/// Sum of v over the states of a lane.
	[[nodiscard]] ScaledNumber total(int lane) const;
	/// State with the greatest v in a lane. Ties go to the lower state.
	[[nodiscard]] int greatest(int lane) const;

private:
	struct Range {
		Eigen::Index first, end;
	};

	Eigen::Index n_;
	Eigen::MatrixXd a_;
	std::vector<Range> predecessors_; ///< for each state: range of its predecessors
	/// (i, j): state j is reachable from state i, in any number of frames.
	Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> reaches_;
	double most_loss_ = 0.0;  ///< most bits that a mantissa can lose in a frame, unless it becomes 0
	bool never_zero_ = false; ///< no mantissa can become 0 in a frame
	int frames_left_ = FALL;  ///< frames until the next renormalisation
	std::vector<Scalar> m_, next_;
	std::vector<std::int64_t> e_;
	std::vector<Scalar> scaled_a_; ///< a times 2^(e_from - e_to): range by range, LANES for each entry
	std::vector<ScaledNumber> v_;

	using Lanes = Eigen::Array<Scalar, LANES, 1>;
	static Eigen::Map<Lanes> lanes(Scalar *p) { return Eigen::Map<Lanes>(p); }
	static Eigen::Map<const Lanes> lanes(const Scalar *p) { return Eigen::Map<const Lanes>(p); }
	static std::size_t place(Eigen::Index state, int lane) {
		return static_cast<std::size_t>(state * LANES + lane);
	}

	/// Sets v of a state, renormalised.
	void set(Eigen::Index state, int lane, const ScaledNumber &v) {
		m_[place(state, lane)] = static_cast<Scalar>(v.mantissa * power_of_two(TOP));
		e_[place(state, lane)] = v.exponent - TOP;
	}
	void step_fast(const Scalar *b);
	void step_renormalised(int lane, const double *b);
	void scale_transitions(int lane);
	[[nodiscard]] bool is_steady(int lane) const;
};

template <int LANES, class Scalar>
ScaledRecursion<LANES, Scalar>::ScaledRecursion(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b) :
		n_(a.rows()), a_(a), reaches_(a.array() > 0.0), m_(place(n_, 0)), next_(m_.size()), e_(m_.size()),
		v_(static_cast<std::size_t>(n_)) {
	const auto bits = [](const Eigen::MatrixXd &p) {
		return -std::log2((p.array() > 0.0).select(p.array(), 1.0).minCoeff());
	};
	most_loss_ = std::max(bits(a) + bits(b), 1.0);
	never_zero_ = a.diagonal().minCoeff() > 0.0 && b.minCoeff() > 0.0;
	std::size_t entries = 0;
	for (Eigen::Index j = 0; j < n_; ++j) {
		Range range{ 0, n_ };
		while (range.end > 1 && a(range.end - 1, j) == 0.0) {
			--range.end;
		}
		while (range.first + 1 < range.end && a(range.first, j) == 0.0) {
			++range.first;
		}
		predecessors_.push_back(range);
		entries += place(range.end - range.first, 0);
	}
	scaled_a_.resize(entries);
	for (Eigen::Index k = 0; k < n_; ++k) { // transitive closure (Warshall 1962)
		for (Eigen::Index i = 0; i < n_; ++i) {
			for (Eigen::Index j = 0; j < n_; ++j) {
				reaches_(i, j) = reaches_(i, j) || (reaches_(i, k) && reaches_(k, j));
			}
		}
	}
}

template <int LANES, class Scalar>
void ScaledRecursion<LANES, Scalar>::start(int lane, const double *p, const double *b) {
	double room = FALL; // bits
	for (Eigen::Index j = 0; j < n_; ++j) {
		room = p[j] > 0.0 && b[j] > 0.0 ? std::min(room, FALL + std::log2(p[j]) + std::log2(b[j])) : room;
	}
	for (Eigen::Index j = 0; j < n_; ++j) {
		if (room >= 0.0) {
			m_[place(j, lane)] = static_cast<Scalar>(p[j] * b[j] * power_of_two(TOP));
			e_[place(j, lane)] = -TOP; // a common scale: a mantissa of 0 is an exact 0
		} else {
			set(j, lane, ScaledNumber(p[j], 0) * b[j]);
		}
	}
	scale_transitions(lane);
	frames_left_ = std::min(frames_left_, static_cast<int>(std::max(room, 0.0) / most_loss_));
}

template <int LANES, class Scalar>
bool ScaledRecursion<LANES, Scalar>::step(const Scalar *b, const double *exact_b) {
	if (frames_left_ > 0) {
		--frames_left_;
		step_fast(b);
		return false;
	}
	bool are_steady = never_zero_;
	for (int lane = 0; lane < LANES; ++lane) {
		step_renormalised(lane, exact_b);
		scale_transitions(lane);
		are_steady = are_steady && is_steady(lane);
	}
	frames_left_ = are_steady ? static_cast<int>(FALL / most_loss_) : 0;
	return true;
}

template <int LANES, class Scalar> void ScaledRecursion<LANES, Scalar>::step_fast(const Scalar *b) {
	const Scalar *a = scaled_a_.data();
	for (Eigen::Index j = 0; j < n_; ++j) {
		const auto [first, end] = predecessors_[static_cast<std::size_t>(j)];
		const Scalar *m = m_.data() + first * LANES;
		Lanes sum = lanes(m) * lanes(a);
		for (Eigen::Index i = first + 1; i < end; ++i) {
			m += LANES;
			a += LANES;
			sum += lanes(m) * lanes(a);
		}
		a += LANES;
		lanes(next_.data() + j * LANES) = sum * lanes(b + j * LANES);
	}
	m_.swap(next_);
}

template <int LANES, class Scalar>
void ScaledRecursion<LANES, Scalar>::step_renormalised(int lane, const double *b) {
	for (Eigen::Index j = 0; j < n_; ++j) {
		v_[static_cast<std::size_t>(j)] = { m_[place(j, lane)], e_[place(j, lane)] };
	}
	for (Eigen::Index j = 0; j < n_; ++j) {
		const auto [first, end] = predecessors_[static_cast<std::size_t>(j)];
		ScaledNumber sum;
		for (Eigen::Index i = first; i < end; ++i) {
			sum = sum + v_[static_cast<std::size_t>(i)] * a_(i, j);
		}
		set(j, lane, sum * b[place(j, lane)]);
	}
}

template <int LANES, class Scalar> void ScaledRecursion<LANES, Scalar>::scale_transitions(int lane) {
	std::size_t entry = static_cast<std::size_t>(lane);
	for (Eigen::Index j = 0; j < n_; ++j) {
		const auto [first, end] = predecessors_[static_cast<std::size_t>(j)];
		for (Eigen::Index i = first; i < end; ++i) {
			// Without this check, 0 times infinity would give NaN for a state that was never reached.
			const double a =
					a_(i, j) > 0.0 ? a_(i, j) * power_of_two(e_[place(i, lane)] - e_[place(j, lane)]) : 0.0;
			scaled_a_[entry] = static_cast<Scalar>(a);
			entry += LANES;
		}
	}
}

/// For each state, the exponents of the states that lead to it are at most RISE bits above its own.
template <int LANES, class Scalar> bool ScaledRecursion<LANES, Scalar>::is_steady(int lane) const {
	for (Eigen::Index j = 0; j < n_; ++j) {
		for (Eigen::Index i = 0; i < n_; ++i) {
			if (reaches_(i, j) && e_[place(i, lane)] - e_[place(j, lane)] > RISE) {
				return false;
			}
		}
	}
	return true;
}

template <int LANES, class Scalar> ScaledNumber ScaledRecursion<LANES, Scalar>::total(int lane) const {
	ScaledNumber sum;
	for (Eigen::Index j = 0; j < n_; ++j) {
		sum = sum + ScaledNumber(m_[place(j, lane)], e_[place(j, lane)]);
	}
	return sum;
}

template <int LANES, class Scalar> int ScaledRecursion<LANES, Scalar>::greatest(int lane) const {
	ScaledNumber best(m_[place(0, lane)], e_[place(0, lane)]);
	int state = 0;
	for (int j = 1; j < n_; ++j) {
		const ScaledNumber v(m_[place(j, lane)], e_[place(j, lane)]);
		if (best < v) {
			best = v;
			state = j;
		}
	}
	return state;
}

} // namespace steadyhand
