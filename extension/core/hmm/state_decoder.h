#pragma once

#include "hmm/fixed_lag_viterbi.h"
#include "hmm/forward.h"

#include <variant>

namespace steadyhand {

/// How a stream of symbols is decoded into states. The nodes use the default, which is the paper's.
/// bench_quality compares the others with it.
struct StateDecoding {
	enum class Rule {
		VITERBI, ///< the state `lag` symbols ago on the best path over the symbols so far
		FILTER,  ///< the most probable state of the newest symbol, given all so far
	};
	enum class Precision { DOUBLE, SINGLE };

	Rule rule = Rule::VITERBI;
	int lag = 0; ///< of VITERBI, in symbols
	Precision precision = Precision::DOUBLE;
};

/// The decoder of a StateDecoding. Only the constructor allocates.
class StateDecoder {
public:
	explicit StateDecoder(const DiscreteHmm &hmm, const StateDecoding &decoding = {});

	void reset();
	void push(Symbol symbol);
	/// State of the symbol lag() before the newest one.
	[[nodiscard]] int state() const;
	[[nodiscard]] int lag() const { return lag_; }

private:
	using AnyDecoder = std::variant<OnlineViterbi<double>, OnlineViterbi<float>, FixedLagViterbi<double>,
			FixedLagViterbi<float>, ForwardFilter<double>, ForwardFilter<float>>;
	AnyDecoder decoder_;
	int lag_;
};

} // namespace steadyhand
