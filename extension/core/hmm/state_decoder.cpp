#include "hmm/state_decoder.h"

namespace steadyhand {
namespace {

template <class Any, class Scalar> Any decoder_in(const DiscreteHmm &hmm, const StateDecoding &decoding) {
	if (decoding.rule == StateDecoding::Rule::FILTER) {
		return ForwardFilter<Scalar>(hmm);
	}
	if (decoding.lag > 0) {
		return FixedLagViterbi<Scalar>(hmm, decoding.lag);
	}
	return OnlineViterbi<Scalar>(hmm);
}

} // namespace

StateDecoder::StateDecoder(const DiscreteHmm &hmm, const StateDecoding &decoding) :
		decoder_(decoding.precision == StateDecoding::Precision::SINGLE
						? decoder_in<AnyDecoder, float>(hmm, decoding)
						: decoder_in<AnyDecoder, double>(hmm, decoding)),
		lag_(decoding.rule == StateDecoding::Rule::VITERBI ? decoding.lag : 0) {}

void StateDecoder::reset() {
	std::visit([](auto &decoder) { decoder.reset(); }, decoder_);
}

void StateDecoder::push(Symbol symbol) {
	std::visit([symbol](auto &decoder) { decoder.push(symbol); }, decoder_);
}

int StateDecoder::state() const {
	return std::visit([](const auto &decoder) { return decoder.state(); }, decoder_);
}

} // namespace steadyhand
