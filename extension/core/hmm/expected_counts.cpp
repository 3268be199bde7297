#include "hmm/expected_counts.h"

#include "hmm/scaled_recursion.h"

#include <algorithm>
#include <array>

namespace steadyhand {
namespace {

/// Sequences that are processed side by side, for vector instructions.
constexpr int AT_ONCE = 8;
/// Longer sequences, in frames, are processed one by one, because the forward variable of all frames is kept
/// in memory.
constexpr std::size_t LONG = 10'000;

using SequencePointers = std::span<const SymbolSequence *const>;

/// Forward and backward pass over up to LANES sequences side by side. The backward pass computes the backward
/// variable times its emission, u_t(j) = b_j(o_t) beta_t(j). So xi_t(i, j) = alpha_t(i) a_ij u_t+1(j) / P(O).
template <int LANES> class SideBySide {
public:
	SideBySide(const LinearHmm &hmm, ExpectedCounts &r_counts) :
			hmm_(&hmm), counts_(&r_counts), n_(hmm.states()), forward_(hmm.a, hmm.b),
			backward_(hmm.a.transpose(), hmm.b), factors_(size(n_ * n_)), transitions_(size(n_ * n_)),
			gamma_(size(n_)), symbols_(Eigen::MatrixXd::Zero(n_, hmm.b.cols())) {
		for (Eigen::Index i = 0; i < n_; ++i) {
			for (Eigen::Index j = 0; j < n_; ++j) {
				if (hmm.a(i, j) > 0.0) {
					arcs_.push_back({ i, j });
				}
			}
		}
	}

	void add(SequencePointers sequences) {
		align(sequences);
		go_forward();
		go_backward();
	}

	/// Adds the sums of all add() calls to the counts.
	void finish() {
		for (std::size_t k = 0; k < arcs_.size(); ++k) {
			counts_->transitions(arcs_[k].from, arcs_[k].to) += lanes(&transitions_[k * LANES]).sum();
		}
		counts_->symbols += symbols_.leftCols(counts_->symbols.cols());
	}

private:
	struct Arc {
		Eigen::Index from, to;
	};
	/// Exponents of the forward variable, valid from frame `from` on.
	struct Epoch {
		std::size_t from;
		std::vector<std::int64_t> exponents;
	};

	const LinearHmm *hmm_;
	ExpectedCounts *counts_;
	Eigen::Index n_;
	ScaledRecursion<LANES> forward_, backward_;
	std::vector<Arc> arcs_;
	std::size_t length_ = 0; ///< of the longest sequence, frames
	std::array<std::size_t, LANES> lengths_{};
	std::array<ScaledNumber, LANES> likelihoods_;
	std::vector<Eigen::Index> columns_; ///< columns of b: frames x LANES
	std::vector<double> emissions_;     ///< frames x N x LANES
	std::vector<double> alpha_;         ///< mantissas: frames x N x LANES
	std::vector<Epoch> epochs_;
	std::vector<double> factors_;     ///< arcs x LANES: xi / (mantissa of alpha * mantissa of u)
	std::vector<double> transitions_; ///< arcs x LANES: expected counts
	std::vector<double> gamma_;       ///< N x LANES
	Eigen::MatrixXd symbols_;         ///< expected counts, of the shape of b

	using Lanes = Eigen::Array<double, LANES, 1>;
	static Eigen::Map<Lanes> lanes(double *p) { return Eigen::Map<Lanes>(p); }
	static Eigen::Map<const Lanes> lanes(const double *p) { return Eigen::Map<const Lanes>(p); }
	static std::size_t size(Eigen::Index n) { return static_cast<std::size_t>(n * LANES); }
	static std::size_t place(Eigen::Index state, int lane) {
		return static_cast<std::size_t>(state * LANES + lane);
	}
	const double *alpha(std::size_t t) const { return alpha_.data() + t * size(n_); }
	const double *emissions(std::size_t t) const { return emissions_.data() + t * size(n_); }

	/// Pads shorter sequences with UNSEEN frames.
	void align(SequencePointers sequences) {
		length_ = 0;
		lengths_.fill(0);
		for (std::size_t lane = 0; lane < sequences.size(); ++lane) {
			lengths_[lane] = sequences[lane]->size();
			length_ = std::max(length_, lengths_[lane]);
		}
		columns_.assign(length_ * LANES, hmm_->column(UNSEEN));
		for (std::size_t lane = 0; lane < sequences.size(); ++lane) {
			for (std::size_t t = 0; t < lengths_[lane]; ++t) {
				columns_[t * LANES + lane] = hmm_->column((*sequences[lane])[t]);
			}
		}
		emissions_.resize(length_ * size(n_));
		alpha_.resize(emissions_.size());
		double *next = emissions_.data();
		for (auto column = columns_.cbegin(); column != columns_.cend(); column += LANES) {
			for (Eigen::Index j = 0; j < n_; ++j) {
				for (int lane = 0; lane < LANES; ++lane) {
					*next++ = hmm_->b(j, column[lane]);
				}
			}
		}
	}

	Eigen::VectorXd of_lane(const double *values, int lane) const {
		return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<LANES>>(values + lane, n_);
	}

	void go_forward() {
		epochs_.clear();
		forward_.reset();
		for (std::size_t t = 0; t < length_; ++t) {
			const double *const b = emissions(t);
			bool has_changed = t == 0;
			if (t == 0) {
				for (int lane = 0; lane < LANES; ++lane) {
					forward_.start(lane, hmm_->pi.data(), of_lane(b, lane).data());
				}
			} else {
				has_changed = forward_.step(b, b);
			}
			if (has_changed) {
				epochs_.push_back({ t, { forward_.exponents(), forward_.exponents() + size(n_) } });
			}
			std::copy_n(forward_.mantissas(), size(n_), alpha_.data() + t * size(n_));
			for (int lane = 0; lane < LANES; ++lane) {
				if (lengths_[static_cast<std::size_t>(lane)] == t + 1) {
					likelihoods_[static_cast<std::size_t>(lane)] = forward_.total(lane);
					counts_->log_likelihood += likelihoods_[static_cast<std::size_t>(lane)].log();
				}
			}
		}
	}

	void go_backward() {
		backward_.reset();
		const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n_);
		for (int lane = 0; lane < LANES; ++lane) {
			backward_.start(lane, ones.data(), ones.data());
		}
		bool has_changed = true;
		for (std::size_t t = length_; t-- > 0;) {
			if (epochs_.back().from > t) {
				epochs_.pop_back();
				has_changed = true;
			}
			if (has_changed) {
				make_factors(t);
			}
			count(t);
			const double *const b = emissions(t);
			has_changed = backward_.step(b, b);
			for (int lane = 0; lane < LANES; ++lane) {
				if (lengths_[static_cast<std::size_t>(lane)] == t + 1) {
					backward_.start(lane, of_lane(b, lane).data(), ones.data());
					has_changed = true;
				}
			}
		}
	}

	/// Computes factors_ for frame t and the frames before it, until exponents change.
	void make_factors(std::size_t t) {
		const std::vector<std::int64_t> &alpha_e = epochs_.back().exponents;
		const std::int64_t *const u_e = backward_.exponents();
		for (int lane = 0; lane < LANES; ++lane) {
			const auto l = static_cast<std::size_t>(lane);
			const ScaledNumber &likelihood = likelihoods_[l];
			const bool counts = t + 1 < lengths_[l] && likelihood.mantissa > 0.0;
			for (std::size_t k = 0; k < arcs_.size(); ++k) {
				const auto [i, j] = arcs_[k];
				const ScaledNumber factor = counts
						? ScaledNumber(hmm_->a(i, j) / likelihood.mantissa,
								  alpha_e[place(i, lane)] + u_e[place(j, lane)] - likelihood.exponent)
						: ScaledNumber();
				// xi <= 1, and mantissas other than 0 have at least LEAST bits. So if the factor is greater,
				// one of the two mantissas is 0 in all these frames.
				constexpr std::int64_t MOST = -2 * ScaledRecursion<LANES>::LEAST;
				factors_[k * LANES + l] =
						factor.exponent <= MOST ? factor.mantissa * power_of_two(factor.exponent) : 0.0;
			}
		}
	}

	/// Counts transitions from frame t and the symbols of frame t. gamma_t(i) is the sum of xi_t(i, j) over
	/// j; in the last frame it is alpha_t(i) / P(O).
	void count(std::size_t t) {
		const double *const m = alpha(t), *const u = backward_.mantissas();
		const Arc *arc = arcs_.data();
		const double *factor = factors_.data();
		double *transition = transitions_.data();
		for (Eigen::Index i = 0; i < n_; ++i) {
			const Lanes alpha = lanes(m + i * LANES);
			Lanes gamma = Lanes::Zero();
			for (; arc != arcs_.data() + arcs_.size() && arc->from == i; ++arc) {
				const Lanes xi = alpha * lanes(factor) * lanes(u + arc->to * LANES);
				lanes(transition) += xi;
				gamma += xi;
				factor += LANES;
				transition += LANES;
			}
			lanes(&gamma_[place(i, 0)]) = gamma;
		}
		for (int lane = 0; lane < LANES; ++lane) {
			const auto l = static_cast<std::size_t>(lane);
			double *const symbol = symbols_.col(columns_[t * LANES + l]).data();
			if (lengths_[l] == t + 1 && likelihoods_[l].mantissa > 0.0) {
				for (Eigen::Index i = 0; i < n_; ++i) {
					const auto e = epochs_.back().exponents[place(i, lane)] - likelihoods_[l].exponent;
					symbol[i] += m[place(i, lane)] * power_of_two(e) / likelihoods_[l].mantissa;
				}
			} else {
				for (Eigen::Index i = 0; i < n_; ++i) {
					symbol[i] += gamma_[place(i, lane)];
				}
			}
		}
	}
};

} // namespace

ExpectedCounts expected_counts(const DiscreteHmm &hmm, std::span<const SymbolSequence> sequences) {
	ExpectedCounts counts;
	counts.transitions = Eigen::MatrixXd::Zero(hmm.states(), hmm.states());
	counts.symbols = Eigen::MatrixXd::Zero(hmm.states(), hmm.symbols());
	std::vector<const SymbolSequence *> by_length;
	for (const SymbolSequence &sequence : sequences) {
		if (!sequence.empty()) {
			by_length.push_back(&sequence);
		}
	}
	std::stable_sort(by_length.begin(), by_length.end(),
			[](const SymbolSequence *a, const SymbolSequence *b) { return a->size() > b->size(); });

	const LinearHmm linear(hmm);
	SequencePointers left(by_length);
	SideBySide<1> one_by_one(linear, counts);
	while (!left.empty() && left.front()->size() > LONG) {
		one_by_one.add(left.first(1));
		left = left.subspan(1);
	}
	one_by_one.finish();
	SideBySide<AT_ONCE> at_once(linear, counts);
	while (!left.empty()) {
		const std::size_t count = std::min<std::size_t>(left.size(), AT_ONCE);
		at_once.add(left.first(count));
		left = left.subspan(count);
	}
	at_once.finish();
	return counts;
}

} // namespace steadyhand
