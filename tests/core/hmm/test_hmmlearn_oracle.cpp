#include "hmm/baum_welch.h"
#include "hmm/fixed_lag_viterbi.h"
#include "hmm/forward.h"
#include "hmm/viterbi.h"
#include "near.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>

using namespace steadyhand;

namespace {

Eigen::MatrixXd log_matrix(const nlohmann::json &rows) {
	Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
	for (Eigen::Index i = 0; i < out.rows(); ++i) {
		for (Eigen::Index j = 0; j < out.cols(); ++j) {
			out(i, j) =
					std::log(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>());
		}
	}
	return out;
}

DiscreteHmm model(const nlohmann::json &json) {
	return { log_matrix(nlohmann::json::array({ json["pi"] })).transpose(), log_matrix(json["a"]),
		log_matrix(json["b"]) };
}

} // namespace

// Run by tests/oracles/hmmlearn_oracle.py, which makes the file that STEADYHAND_HMMLEARN names.
TEST_CASE("hmmlearn oracle: likelihoods, paths, online states and training" * doctest::skip()) {
	const char *path = std::getenv("STEADYHAND_HMMLEARN");
	REQUIRE(path != nullptr);
	std::ifstream file(path);
	const nlohmann::json oracle = nlohmann::json::parse(file);

	REQUIRE(oracle["inference"].size() > 0);
	for (const nlohmann::json &one : oracle["inference"]) {
		const DiscreteHmm hmm = model(one["model"]);
		const SymbolSequence symbols = one["symbols"].get<SymbolSequence>();
		CHECK(log_likelihood(hmm, symbols) == test::near(one["log_likelihood"].get<double>()).epsilon(1e-10));
		const ViterbiPath path_found = viterbi(hmm, symbols);
		CHECK(path_found.log_probability == test::near(one["viterbi"].get<double>()).epsilon(1e-10));
		CHECK(path_found.states == one["path"].get<std::vector<int>>());

		FixedLagViterbi lagged(hmm, one["lag"].get<int>());
		ForwardFilter filter(hmm);
		for (std::size_t t = 0; t < one["lagged"].size(); ++t) {
			lagged.push(symbols[t]);
			filter.push(symbols[t]);
			CHECK(lagged.state() == one["lagged"][t].get<int>());
			CHECK(filter.state() == one["filtered"][t].get<int>());
		}
	}

	REQUIRE(oracle["training"].size() > 0);
	for (const nlohmann::json &one : oracle["training"]) {
		BaumWelchOptions options;
		options.max_iterations = one["iterations"].get<int>();
		options.tolerance_nats = -1.0;
		options.pseudo = { one["pseudo_transition"].get<double>(), one["pseudo_symbol"].get<double>() };
		const BaumWelchResult result =
				baum_welch(model(one["start"]), one["sequences"].get<std::vector<SymbolSequence>>(), options);
		const DiscreteHmm expected = model(one["result"]);
		CHECK((result.hmm.log_a.array().exp() - expected.log_a.array().exp()).abs().maxCoeff() < 1e-8);
		CHECK((result.hmm.log_b.array().exp() - expected.log_b.array().exp()).abs().maxCoeff() < 1e-8);
	}
}
