#include "gesture/classifier_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Tests run in the repository's root.
std::string own_text() {
	std::ostringstream text;
	text << std::ifstream("models/gestures.classifier", std::ios::binary).rdbuf();
	return text.str();
}

std::string with(const std::string &from, const std::string &to) {
	std::string text = own_text();
	return text.replace(text.find(from), from.size(), to);
}

std::string error_of(const std::string &text) {
	const Result<ClassifierModel> read = parse_classifier(text, "a.classifier");
	return read ? "" : read.error();
}

TEST_CASE("a classifier's file reads back to the same text") {
	const std::string text = own_text();
	const Result<ClassifierModel> read = parse_classifier(text, "a.classifier");
	REQUIRE_MESSAGE(read.ok(), read.error());
	CHECK(format_classifier(read.value()) == text);
}

TEST_CASE("a damaged classifier file gives one error with line and reason") {
	CHECK(error_of("").starts_with("a.classifier:1: not valid JSON"));
	CHECK(error_of(own_text().substr(0, 5000)).find("not valid JSON") != std::string::npos);
	CHECK(error_of("{}").starts_with("a.classifier:1: "));
	CHECK(error_of(with("steadyhand-classifier", "steadyhand-gesture"))
					.find("not a steadyhand-classifier file") != std::string::npos);
	CHECK(error_of(with("\"version\":1", "\"version\":2")).starts_with("a.classifier:1: version"));
	CHECK(error_of(with("\"gesture\":\"tap\"", "\"gesture\":\"none\"")).find("gesture:") !=
			std::string::npos);
	CHECK(error_of(with("\"reach_deviation\":0.12", "\"reach_deviation\":0")).find("reach_deviation") !=
			std::string::npos);
	CHECK(error_of(with("\"log_pi\"", "\"log_p\"")).find("log_pi") != std::string::npos);
}

TEST_CASE("a classifier file with a gesture that never ends is refused") {
	ClassifierModel model = *own_classifier();
	const double never = -std::numeric_limits<double>::infinity();
	DiscreteHmm &hmm = model.gestures.front().hmm;
	hmm = { Eigen::Vector3d(0.0, never, never), Eigen::MatrixXd::Constant(3, 3, -std::log(3.0)),
		Eigen::MatrixXd(hmm.log_b.topRows(3)) };
	CHECK(error_of(format_classifier(model))
					.ends_with(": log_pi: fewer than 4 states, so the gesture never ends"));
}

} // namespace
