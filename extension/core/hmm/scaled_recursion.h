#pragma once

#include "hmm/linear_hmm.h"
#include "hmm/scaled_number.h"

#include <algorithm>
#include <type_traits>

namespace steadyhand {

/// v_j(t) = b_j(o_t) sum_i a_ij v_i(t - 1): the forward variable (Rabiner 1989 eq. (20)); with A transposed,
/// the backward variable times its emission. Of LANES sequences at once.
///
/// In probabilities, and exact to rounding at any length. A pass with one scale a frame loses the states of a
/// left-right model that underflow against the others, though paths through them may win later. Here each
/// state has a scale of its own, v = m 2^e. Exponents are renewed after so many frames that no mantissa can
/// have underflowed by then, by the smallest entries of A and B; until the next time they are part of the
/// transitions, and cost nothing. Where no such number of frames can be told (zeros in B, states without a
/// way to themselves, leaps of likelihood) they are renewed in each. In float, whose exponents are short,
/// that is often.
template <int LANES, class Scalar = double> class ScaledRecursion {
	/// In bits: a mantissa is TOP after a renewal, and between TOP - FALL and TOP + RISE until the next. So
	/// products of two are in range (in float, of one and a transition between the scales); and what vanishes
	/// in one with a power of two, is nothing beside any. RISE leaves room for a factor of expected counts
	/// too.
	static constexpr bool IS_SHORT = std::is_same_v<Scalar, float>;
	static constexpr int TOP = IS_SHORT ? 10 : 250, FALL = IS_SHORT ? 80 : 600, RISE = IS_SHORT ? 40 : 50;

public:
	/// Bits of the smallest mantissa that is not 0.
	static constexpr int LEAST = TOP - FALL;

	/// a: N x N, from, to; b: N x any, all emissions there are. Allocates; nothing else does.
	ScaledRecursion(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b);

	/// Before the lanes are started on other sequences.
	void reset() { left_ = FALL; }
	/// v of a lane from now on: p times b, N probabilities each, whose product may be less than any double.
	/// The others stay.
	void start(int lane, const double *p, const double *b);
	/// b: N x LANES, the emission of state j in lane l at j * LANES + l; exact_b: the same in double, as
	/// float has no number below 1e-45. True where exponents have changed.
	bool step(const Scalar *b, const double *exact_b);

	/// N x LANES, as in step.
	[[nodiscard]] const Scalar *mantissas() const { return m_.data(); }
	[[nodiscard]] const std::int64_t *exponents() const { return e_.data(); }
	/// A lane's sum of v.
	[[nodiscard]] ScaledNumber total(int lane) const;
	/// The state of the greatest v in a lane; the lowest, where several are.
	[[nodiscard]] int greatest(int lane) const;

private:
	struct Stretch {
		Eigen::Index first, end;
	};

	Eigen::Index n_;
	Eigen::MatrixXd a_;
	std::vector<Stretch> from_; ///< of each state: where transitions to it come from
	/// From i to j, in any number of frames.
	Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> leads_;
	double fall_ = 0.0;  ///< bits that a state may lose in a frame, if not all
	bool keeps_ = false; ///< no state loses all in a frame
	int left_ = FALL;    ///< frames until exponents are to be renewed
	std::vector<Scalar> m_, next_;
	std::vector<std::int64_t> e_;
	std::vector<Scalar> scaled_a_; ///< between the scales: stretch by stretch, LANES for each entry
	std::vector<ScaledNumber> v_;

	using Lanes = Eigen::Array<Scalar, LANES, 1>;
	static Eigen::Map<Lanes> lanes(Scalar *p) { return Eigen::Map<Lanes>(p); }
	static Eigen::Map<const Lanes> lanes(const Scalar *p) { return Eigen::Map<const Lanes>(p); }
	static std::size_t place(Eigen::Index state, int lane) {
		return static_cast<std::size_t>(state * LANES + lane);
	}

	/// v of a state, as it is after a renewal.
	void set(Eigen::Index state, int lane, const ScaledNumber &v) {
		m_[place(state, lane)] = static_cast<Scalar>(v.mantissa * power_of_two(TOP));
		e_[place(state, lane)] = v.exponent - TOP;
	}
	void step_plainly(const Scalar *b);
	void step_carefully(int lane, const double *b);
	void scale_transitions(int lane);
	[[nodiscard]] bool is_steady(int lane) const;
};

template <int LANES, class Scalar>
ScaledRecursion<LANES, Scalar>::ScaledRecursion(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b) :
		n_(a.rows()), a_(a), leads_(a.array() > 0.0), m_(place(n_, 0)), next_(m_.size()), e_(m_.size()),
		v_(static_cast<std::size_t>(n_)) {
	const auto bits = [](const Eigen::MatrixXd &p) {
		return -std::log2((p.array() > 0.0).select(p.array(), 1.0).minCoeff());
	};
	fall_ = std::max(bits(a) + bits(b), 1.0);
	keeps_ = a.diagonal().minCoeff() > 0.0 && b.minCoeff() > 0.0;
	std::size_t entries = 0;
	for (Eigen::Index j = 0; j < n_; ++j) {
		Stretch stretch{ 0, n_ };
		while (stretch.end > 1 && a(stretch.end - 1, j) == 0.0) {
			--stretch.end;
		}
		while (stretch.first + 1 < stretch.end && a(stretch.first, j) == 0.0) {
			++stretch.first;
		}
		from_.push_back(stretch);
		entries += place(stretch.end - stretch.first, 0);
	}
	scaled_a_.resize(entries);
	for (Eigen::Index k = 0; k < n_; ++k) { // transitive closure (Warshall 1962)
		for (Eigen::Index i = 0; i < n_; ++i) {
			for (Eigen::Index j = 0; j < n_; ++j) {
				leads_(i, j) = leads_(i, j) || (leads_(i, k) && leads_(k, j));
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
			e_[place(j, lane)] = -TOP; // one scale for all: what is 0 is so in truth
		} else {
			set(j, lane, ScaledNumber(p[j], 0) * b[j]);
		}
	}
	scale_transitions(lane);
	left_ = std::min(left_, static_cast<int>(std::max(room, 0.0) / fall_));
}

template <int LANES, class Scalar>
bool ScaledRecursion<LANES, Scalar>::step(const Scalar *b, const double *exact_b) {
	if (left_ > 0) {
		--left_;
		step_plainly(b);
		return false;
	}
	bool are_steady = keeps_;
	for (int lane = 0; lane < LANES; ++lane) {
		step_carefully(lane, exact_b);
		scale_transitions(lane);
		are_steady = are_steady && is_steady(lane);
	}
	left_ = are_steady ? static_cast<int>(FALL / fall_) : 0;
	return true;
}

template <int LANES, class Scalar> void ScaledRecursion<LANES, Scalar>::step_plainly(const Scalar *b) {
	const Scalar *a = scaled_a_.data();
	for (Eigen::Index j = 0; j < n_; ++j) {
		const auto [first, end] = from_[static_cast<std::size_t>(j)];
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
void ScaledRecursion<LANES, Scalar>::step_carefully(int lane, const double *b) {
	for (Eigen::Index j = 0; j < n_; ++j) {
		v_[static_cast<std::size_t>(j)] = { m_[place(j, lane)], e_[place(j, lane)] };
	}
	for (Eigen::Index j = 0; j < n_; ++j) {
		const auto [first, end] = from_[static_cast<std::size_t>(j)];
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
		const auto [first, end] = from_[static_cast<std::size_t>(j)];
		for (Eigen::Index i = first; i < end; ++i) {
			// No transition is 0 times infinity where a state that it does not lead to has never been.
			const double a =
					a_(i, j) > 0.0 ? a_(i, j) * power_of_two(e_[place(i, lane)] - e_[place(j, lane)]) : 0.0;
			scaled_a_[entry] = static_cast<Scalar>(a);
			entry += LANES;
		}
	}
}

/// All who lead to a state are no further above it than it may rise.
template <int LANES, class Scalar> bool ScaledRecursion<LANES, Scalar>::is_steady(int lane) const {
	for (Eigen::Index j = 0; j < n_; ++j) {
		for (Eigen::Index i = 0; i < n_; ++i) {
			if (leads_(i, j) && e_[place(i, lane)] - e_[place(j, lane)] > RISE) {
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
