#pragma once

#include "hmm/fixed_lag_viterbi.h"
#include "hmm/forward.h"

#include <variant>

namespace steadyhand {

/// By which rule a stream of symbols is turned into states. The default is the paper's, and what the nodes
/// use; the others are there to be compared with it (bench_quality).
struct StateDecoding {
	enum class Rule {
		VITERBI, ///< the state `lag` symbols ago on the best path over the symbols so far
		FILTER,  ///< the most probable state of the newest symbol, given all so far
	};
	enum class Precision { DOUBLE, SINGLE };

	Rule rule = Rule::VITERBI;
	int lag = 0; ///< symbols; of VITERBI
	Precision precision = Precision::DOUBLE;
};

/// The decoder that a StateDecoding asks for. After construction nothing is allocated.
class StateDecoder {
public:
	explicit StateDecoder(const DiscreteHmm &hmm, const StateDecoding &decoding = {});

	void reset();
	void push(Symbol symbol);
	/// Of the symbol that is lag() before the newest one.
	[[nodiscard]] int state() const;
	[[nodiscard]] int lag() const { return lag_; }

private:
	using AnyDecoder = std::variant<OnlineViterbi<double>, OnlineViterbi<float>, FixedLagViterbi<double>,
			FixedLagViterbi<float>, ForwardFilter<double>, ForwardFilter<float>>;
	AnyDecoder decoder_;
	int lag_;
};

} // namespace steadyhand
