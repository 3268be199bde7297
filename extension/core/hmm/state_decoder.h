#pragma once

#include "hmm/fixed_lag_viterbi.h"
#include "hmm/forward.h"

#include <variant>

namespace steadyhand {

/// By which rule a stream of symbols is turned into states. The default is the paper's, and what the nodes
/// use; the others are there to be compared with it (docs/method.md, "What accuracy costs").
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
	explicit StateDecoder(const DiscreteHmm &hmm, const StateDecoding &decoding = {}) :
			decoder_(decoder(hmm, decoding)),
			lag_(decoding.rule == StateDecoding::Rule::VITERBI ? decoding.lag : 0) {}

	void reset() {
		std::visit([](auto &decoder) { decoder.reset(); }, decoder_);
	}
	void push(Symbol symbol) {
		std::visit([symbol](auto &decoder) { decoder.push(symbol); }, decoder_);
	}
	/// Of the symbol that is lag() before the newest one.
	[[nodiscard]] int state() const {
		return std::visit([](const auto &decoder) { return decoder.state(); }, decoder_);
	}
	[[nodiscard]] int lag() const { return lag_; }

private:
	using AnyDecoder = std::variant<OnlineViterbi<double>, OnlineViterbi<float>, FixedLagViterbi<double>,
			FixedLagViterbi<float>, ForwardFilter<double>, ForwardFilter<float>>;
	AnyDecoder decoder_;
	int lag_;

	template <class Scalar>
	static AnyDecoder decoder_in(const DiscreteHmm &hmm, const StateDecoding &decoding) {
		if (decoding.rule == StateDecoding::Rule::FILTER) {
			return ForwardFilter<Scalar>(hmm);
		}
		if (decoding.lag > 0) {
			return FixedLagViterbi<Scalar>(hmm, decoding.lag);
		}
		return OnlineViterbi<Scalar>(hmm);
	}
	static AnyDecoder decoder(const DiscreteHmm &hmm, const StateDecoding &decoding) {
		return decoding.precision == StateDecoding::Precision::SINGLE ? decoder_in<float>(hmm, decoding)
																	  : decoder_in<double>(hmm, decoding);
	}
};

} // namespace steadyhand
