// HMMs of a user's recordings: training, and their part of the model file.

#include "gesture/classifier_file.h"
#include "gesture/model_file.h"
#include "gesture/recorded_hmms.h"
#include "near.h"
#include "trained_drag.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace steadyhand;

namespace {

using Json = nlohmann::ordered_json;

/// Error of a file of the drag's model with a change of its HMMs; empty if it is read.
std::string error_of(const std::function<void(Json &r_hmms)> &change) {
	static const Json file = Json::parse(format_model(test::drag_model()));
	Json changed = file;
	change(changed["recorded_hmms"]);
	const Result<GestureModel> read = parse_model(changed.dump(), "a.gesture");
	return read.ok() ? std::string() : read.error();
}

std::string error_of_direction(const std::function<void(Json &r_direction)> &change) {
	return error_of([&](Json &r_hmms) { change(r_hmms["directions"][0]); });
}

/// The recordings, of which every second one goes in the opposite direction.
std::vector<TrainingRecording> there_and_back() {
	std::vector<TrainingRecording> drags = test::drag_recordings();
	for (std::size_t i = 1; i < drags.size(); i += 2) {
		for (Track *track : { &drags[i].measured, &drags[i].reference }) {
			for (HandFrame &frame : track->frames) {
				frame.set(Joint::INDEX, -frame.position(Joint::INDEX));
			}
		}
		drags[i].task.axis = -drags[i].task.axis;
	}
	return drags;
}

TEST_CASE("a trained model has an HMM for each recorded direction") {
	const GestureModel model = train("drag", "index_along_axis", there_and_back(), {}).value();
	REQUIRE(model.recorded_hmms.size() == 2);
	for (const DirectedHmm &one : model.recorded_hmms) {
		CHECK(one.gesture == "drag");
		CHECK(std::abs(one.axis.x()) == test::near(1.0).epsilon(1e-9));
		CHECK(one.reach_m == test::near(0.2).epsilon(0.02));
		CHECK(one.hmm.symbols() == own_classifier()->codebook.symbols());
		CHECK(validated(one.hmm).ok());
		CHECK(one.hmm.log_b.allFinite()); // every symbol stays possible
	}
	CHECK(model.recorded_hmms[0].axis.dot(model.recorded_hmms[1].axis) < -0.9);
}

TEST_CASE("a single recording gives an HMM") {
	const std::vector<TrainingRecording> drags = test::drag_recordings();
	const auto model = train("drag", "index_along_axis", std::span(drags).first(1), {});
	CHECK(model.value().recorded_hmms.size() == 1);
}

TEST_CASE("recordings that end with the gesture give no HMM and a warning") {
	std::vector<TrainingRecording> drags = test::drag_recordings();
	for (TrainingRecording &drag : drags) {
		std::erase_if(drag.measured.frames, [&](const HandFrame &frame) { return frame.t_s > drag.end_s; });
	}
	std::string warning;
	const auto model = train("drag", "index_along_axis", drags, {}, nullptr, &warning);
	CHECK(model.value().recorded_hmms.empty());
	CHECK(warning.starts_with("it is not recognised without a task: the measured tracks must show"));
	TrainingOptions options;
	options.without_task = false;
	REQUIRE(train("drag", "index_along_axis", drags, options, nullptr, &warning).ok());
	CHECK(warning.empty());
}

TEST_CASE("a model file with HMMs reads back to the same bits") {
	const GestureModel model = train("drag", "index_along_axis", there_and_back(), {}).value();
	const std::string text = format_model(model);
	const GestureModel read = parse_model(text, "a.gesture").value();
	CHECK(format_model(read) == text);
	REQUIRE(read.recorded_hmms.size() == 2);
	for (std::size_t i = 0; i < 2; ++i) {
		const DirectedHmm &one = read.recorded_hmms[i], &trained = model.recorded_hmms[i];
		CHECK(one.gesture == trained.gesture);
		CHECK(one.axis == trained.axis);
		CHECK(one.reach_m == trained.reach_m);
		CHECK(one.reach_deviation == trained.reach_deviation);
		CHECK(one.hmm.log_pi == trained.hmm.log_pi);
		CHECK(one.hmm.log_a == trained.hmm.log_a);
		CHECK(one.hmm.log_b == trained.hmm.log_b);
	}
	GestureModel bare = model;
	bare.recorded_counts.clear();
	CHECK(text.size() < format_model(bare).size() + 2 * 20'000);
	CHECK(parse_model(format_model(bare), "a.gesture").value().recorded_hmms.empty());
}

TEST_CASE("a model file with HMMs over another codebook asks to train again") {
	CHECK(error_of([](Json &) {}).empty());
	CHECK(error_of([](Json &r_hmms) { r_hmms["codebook"] = "0123456789abcdef"; }) ==
			"a.gesture:1: codebook: not the one of this version. Train the gesture again");
	MotionCodebook other = own_classifier()->codebook;
	CHECK(checksum(other) == checksum(own_classifier()->codebook));
	MotionCodebook::Codewords codewords = other.codebook();
	codewords(3, 2) = std::nextafter(codewords(3, 2), 1.0);
	other = MotionCodebook(codewords, other.scale());
	CHECK(checksum(other) != checksum(own_classifier()->codebook));
}

TEST_CASE("a model file with damaged HMMs gives one error with the cause") {
	CHECK(error_of([](Json &r_hmms) { r_hmms.erase("codebook"); }) == "a.gesture:1: codebook: missing");
	CHECK(error_of([](Json &r_hmms) { r_hmms["directions"] = Json::array(); }) ==
			"a.gesture:1: directions: not an array with entries");
	CHECK(error_of([](Json &r_hmms) { r_hmms["directions"] = Json(33, r_hmms["directions"][0]); }) ==
			"a.gesture:1: directions: more than 32");
	CHECK(error_of_direction([](Json &r_direction) {
		r_direction["axis"] = { 0.0, 0.5, 0.0 };
	}) == "a.gesture:1: axis: its length is not 1");
	CHECK(error_of_direction([](Json &r_direction) {
		r_direction["axis"] = { 0.0, 0.0, 0.0 };
		r_direction["is_radius"] = true;
	}) == "a.gesture:1: is_radius: does not fit the feature");
	CHECK(error_of_direction([](Json &r_direction) {
		r_direction["reach_m"] = 0.0;
	}).starts_with("a.gesture:1: reach_m: not within"));
	CHECK(error_of_direction([](Json &r_direction) { r_direction["symbols"].erase(0); }) ==
			"a.gesture:1: symbols: must have a row for each state");
	CHECK(error_of_direction([](Json &r_direction) { r_direction["transitions"][2][1] = -1; }) ==
			"a.gesture:1: transitions: must be two counts of at least 0 for each state");
	CHECK(error_of_direction([](Json &r_direction) {
		while (r_direction["transitions"].size() > 3) {
			r_direction["transitions"].erase(3);
			r_direction["symbols"].erase(3);
		}
	}) == "a.gesture:1: transitions: not 4 .. 256 states, are 3");
	const auto with_row = [](const Json &row) {
		return error_of_direction([&](Json &r_direction) { r_direction["symbols"][5] = row; });
	};
	const std::string symbol =
			"a.gesture:1: symbols: a symbol is no integer of 0 .. 127, or not greater than the one before";
	CHECK(with_row({ 0, 3, 127, 1 }).empty());
	CHECK(with_row({ 4, 3, 128, 1 }) == symbol);
	CHECK(with_row({ -1, 3 }) == symbol);
	CHECK(with_row({ 4.5, 3 }) == symbol);
	CHECK(with_row({ 4, 3, 4, 1 }) == symbol);
	CHECK(with_row({ 4, 0 }) == "a.gesture:1: symbols: a count is not greater than 0");
	CHECK(with_row({ 4, 3, 5 }) == "a.gesture:1: symbols: the last symbol has no count");
	CHECK(with_row({ 4, nullptr }) == "a.gesture:1: symbols[1]: not a number");
	CHECK(with_row({ 4, 1e300 }) == "a.gesture:1: symbols[1]: beyond 1e9");
}

TEST_CASE("a feature without a place has no HMMs") {
	Json file = Json::parse(format_model(test::drag_model()));
	file["feature"] = "index_along_circle";
	CHECK(parse_model(file.dump(), "a.gesture").error() ==
			"a.gesture:1: recorded_hmms: the feature 'index_along_circle' has none");
	const std::vector<TrainingRecording> drags = test::drag_recordings();
	const Movement movement{ drags.data(), { 0.5, 1.3 } };
	CHECK(recorded_counts(*find_feature("index_along_circle"), { &movement, 1 }).empty());
	CHECK(recorded_counts(*find_feature("index_along_axis"), { &movement, 1 }).size() == 1);
}

TEST_CASE("the symbols of other motion have the stationary distribution") {
	DiscreteHmm other;
	// Leaves the first state at 0.1 and the second at 0.3: stationary are 3/4 and 1/4.
	other.log_pi = Eigen::Vector2d(0.0, NEVER);
	other.log_a = Eigen::Matrix2d{ { 0.9, 0.1 }, { 0.3, 0.7 } }.array().log();
	other.log_b = Eigen::MatrixXd{ { 0.2, 0.3, 0.5 }, { 0.6, 0.3, 0.1 } }.array().log();
	CHECK((symbols_of_other(other) - Eigen::RowVector3d(0.3, 0.3, 0.4)).norm() < 1e-9);
}

} // namespace
