// Model files that are valid JSON, but no valid model.

#include "gesture/model_file.h"
#include "near.h"
#include "trained_drag.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

using namespace steadyhand;

namespace {

using Json = nlohmann::ordered_json;

/// Error of a file of the drag's model with a change; empty if it is read.
std::string error_of(const std::function<void(Json &r_file)> &change) {
	static const Json file = Json::parse(format_model(test::drag_model()));
	Json changed = file;
	change(changed);
	const Result<GestureModel> read = parse_model(changed.dump(), "a.gesture");
	return read.ok() ? std::string() : read.error();
}

} // namespace

TEST_CASE("a model file with inconsistent shapes is refused") {
	CHECK(error_of([](Json &) {}).empty());
	const std::string counts =
			"a.gesture:1: the counts of states (elements) and symbols (codebook) differ from the hmm's";
	CHECK(error_of([](Json &r_file) { r_file["elements"].erase(0); }) == counts);
	CHECK(error_of([](Json &r_file) { r_file["quantiser"]["codebook"].erase(0); }) == counts);
	CHECK(error_of([](Json &r_file) {
		Json &codebook = r_file["quantiser"]["codebook"];
		codebook.push_back(codebook[0]);
	}) == counts);
	const std::string shape =
			"a.gesture:1: quantiser: the codebook must be M x 2, the scale two numbers greater than 0";
	CHECK(error_of([](Json &r_file) {
		for (Json &row : r_file["quantiser"]["codebook"]) {
			row.push_back(0.0);
		}
	}) == shape);
	CHECK(error_of([](Json &r_file) { r_file["quantiser"]["scale"] = { 1.0, 0.0 }; }) == shape);
	CHECK(error_of([](Json &r_file) { r_file["quantiser"]["scale"] = { 1.0 }; }) == shape);
	CHECK(error_of([](Json &r_file) {
		r_file["hmm"]["log_b"][2].erase(0);
	}).starts_with("a.gesture:1: log_b, row 2: "));
	CHECK(error_of([](Json &r_file) {
		r_file["hmm"]["log_b"][2].push_back(nullptr);
	}).starts_with("a.gesture:1: log_b, row 2: "));
	CHECK(error_of([](Json &r_file) {
		r_file["hmm"]["log_pi"].push_back(nullptr);
	}).starts_with("a.gesture:1: hmm: the sizes of pi (5)"));
	for (const char *const curve : { "reference_mean", "reference_deviation" }) {
		CHECK(error_of([&](Json &r_file) { r_file[curve].push_back(1.0); }) ==
				"a.gesture:1: " + std::string(curve) + ": 102 points, not 101");
		CHECK(error_of([&](Json &r_file) { r_file[curve].erase(0); }) ==
				"a.gesture:1: " + std::string(curve) + ": 100 points, not 101");
	}
	CHECK(error_of([](Json &r_file) { r_file["typical_axis"].push_back(0.0); }) ==
			"a.gesture:1: typical_axis: not three numbers");
	CHECK(error_of([](Json &r_file) {
		Json &polynomial = r_file["elements"][1]["polynomial"];
		polynomial.push_back(0.0);
	}) == "a.gesture:1: polynomial: more than 8 coefficients");
	CHECK(error_of([](Json &r_file) { r_file["elements"][1]["polynomial"][0] = -1e300; }) ==
			"a.gesture:1: polynomial[0]: beyond 1e9");
	CHECK(error_of([](Json &r_file) { r_file["elements"][1]["polynomial"][0] = 1e5; }) ==
			"a.gesture:1: polynomial: its values leave -2 .. 2");
	CHECK(error_of([](Json &r_file) { r_file["elements"][1]["phase_begin"] = 0.0; }) ==
			"a.gesture:1: elements: each phase_begin must be the phase_end before it, and the first 0");
	CHECK(error_of([](Json &r_file) { r_file["elements"].back()["phase_end"] = 1e20; }) ==
			"a.gesture:1: elements: the last phase_end must be 1");
	CHECK(error_of([](Json &r_file) {
		Json &elements = r_file["elements"];
		while (elements.size() <= 256) {
			elements.push_back(elements[0]);
		}
	}) == "a.gesture:1: elements: more than 256 states");
}

TEST_CASE("a model file with an invalid number is refused") {
	const auto first_element = [](const char *key, const Json &value) {
		return error_of([&](Json &r_file) { r_file["elements"][0][key] = value; });
	};
	CHECK(first_element("phase_end", 0.0) ==
			"a.gesture:1: elements: phase_end must be phase_begin + 0.01 at least");
	CHECK(first_element("duration_mean_s", 0.0) ==
			"a.gesture:1: duration_mean_s: not within 1e-05 .. 3600, is 0");
	CHECK(first_element("duration_mean_s", "1") == "a.gesture:1: duration_mean_s: not a number");
	CHECK(error_of([](Json &r_file) { r_file["typical_amplitude_m"] = 0.0; }) ==
			"a.gesture:1: typical_amplitude_m: not within 1e-06 .. 1e+09, is 0");
	CHECK(error_of([](Json &r_file) { r_file["quantiser"]["codebook"][3][1] = nullptr; }) ==
			"a.gesture:1: codebook[1]: not a number");
	CHECK(error_of([](Json &r_file) { r_file["reference_mean"][7] = nullptr; }) ==
			"a.gesture:1: reference_mean[7]: not a number");
	// A log probability may be null, which is log 0.
	CHECK(error_of([](Json &r_file) { r_file["provenance"]["objective"] = { nullptr, -3.0 }; }).empty());
	for (const Json &recordings : { Json(-1), Json(2e9), Json("12") }) {
		CHECK(error_of([&](Json &r_file) {
			r_file["provenance"]["recordings"] = recordings;
		}).starts_with("a.gesture:1: recordings: not a number"));
	}
	for (const Json &version : { Json(0), Json(2), Json(1.5) }) {
		CHECK(error_of([&](Json &r_file) { r_file["version"] = version; }) ==
				"a.gesture:1: version: must be 1. Update SteadyHand, or make the file again");
	}
}

TEST_CASE("a model file whose gesture name is no file name is refused") {
	CHECK(error_of([](Json &r_file) { r_file["gesture"] = ""; }) == "a.gesture:1: gesture: '' is empty");
	CHECK(error_of([](Json &r_file) { r_file["gesture"] = "a/b"; }) ==
			"a.gesture:1: gesture: 'a/b' has a character that no file name may have");
	CHECK(error_of([](Json &r_file) { r_file["gesture"] = "none"; }) ==
			"a.gesture:1: gesture: 'none' stands for no gesture in results; choose another name");
	for (const char *const good : { "a circle", "None", "none2" }) {
		CHECK(error_of([&](Json &r_file) { r_file["gesture"] = good; }).empty());
	}
	CHECK(error_of([](Json &r_file) { r_file["reference_deviation"][4] = -3.0; }) ==
			"a.gesture:1: reference_deviation: less than 0");
}

TEST_CASE("a model file of 300,000 members is refused at once") {
	std::string text = "{\n\"a\": [";
	for (int i = 0; i < 300'000; ++i) {
		text += (i == 0 ? "{\"k" : ",\"k") + std::to_string(i) + "\": 0";
	}
	const Result<GestureModel> read = parse_model(text + "}]}", "a.gesture");
	REQUIRE_FALSE(read.ok());
	CHECK(read.error() == "a.gesture:1: an object has more than 64 members");
}

TEST_CASE("a model file of nested arrays is refused") {
	const std::string deep(300'000, '[');
	CHECK_FALSE(parse_model(deep, "a.gesture").ok());
	CHECK_FALSE(parse_model(deep + std::string(300'000, ']'), "a.gesture").ok());
}

TEST_CASE("a model file with an extreme duration or deviation is refused") {
	for (const double mean_s : { 1e-300, -1.0, 1e200 }) {
		const std::string wanted = "a.gesture:1: duration_mean_s: not within 1e-05 .. 3600, is ";
		CHECK(error_of([&](Json &r_file) { r_file["duration_mean_s"] = mean_s; }).starts_with(wanted));
		CHECK(error_of([&](Json &r_file) {
			r_file["elements"][2]["duration_mean_s"] = mean_s;
		}).starts_with(wanted));
	}
	for (const double deviation_s : { 1e200, -1e200, -1.0 }) {
		const std::string wanted = "a.gesture:1: duration_deviation_s: not within 0 .. ";
		CHECK(error_of([&](Json &r_file) {
			r_file["duration_deviation_s"] = deviation_s;
		}).starts_with(wanted));
		CHECK(error_of([&](Json &r_file) {
			r_file["elements"][2]["duration_deviation_s"] = deviation_s;
		}).starts_with(wanted));
	}
	CHECK(error_of([](Json &r_file) { r_file["elements"][2]["deviation"] = -0.1; }) ==
			"a.gesture:1: deviation: not within 0 .. 10, is -0.1");
	CHECK(error_of([](Json &r_file) { r_file["typical_amplitude_m"] = 1e-300; }) ==
			"a.gesture:1: typical_amplitude_m: not within 1e-06 .. 1e+09, is 1e-300");
}

TEST_CASE("a model file with a too short motion element is refused") {
	const auto with_end = [](std::size_t element, double phase) {
		return error_of([&](Json &r_file) {
			r_file["elements"][element]["phase_end"] = phase;
			r_file["elements"][element + 1]["phase_begin"] = phase;
		});
	};
	const double begin = test::drag_model().elements[1].phase_begin;
	for (const double length : { 1e-300, 0.0, 1e-15, 1e-9, 1e-4, 0.0099 }) {
		CAPTURE(length);
		CHECK(with_end(1, std::nextafter(begin + length, 1.0)) ==
				"a.gesture:1: elements: phase_end must be phase_begin + 0.01 at least");
	}
	CHECK(with_end(0, 1e-12) == "a.gesture:1: elements: phase_end must be phase_begin + 0.01 at least");
	CHECK(with_end(1, begin + 0.011).empty());
}

TEST_CASE("a model file with a wrong axis is refused") {
	const auto with_axis = [](const char *feature, const Json &axis) {
		return error_of([&](Json &r_file) {
			r_file["feature"] = feature;
			r_file["typical_axis"] = axis;
			r_file.erase("recorded_hmms"); // of a drag
		});
	};
	const std::string wanted = "a.gesture:1: typical_axis: its length is not 1";
	CHECK(with_axis("index_along_axis", { 2.0, 0.0, 0.0 }) == wanted);
	CHECK(with_axis("index_along_axis", { 0.6, 0.6, 0.0 }) == wanted);
	CHECK(with_axis("index_along_axis", { 0.0, 0.0, 0.0 }) == wanted);
	CHECK(with_axis("index_along_axis", { 0.6, 0.0, -0.8 }).empty());
	CHECK(with_axis("index_along_axis", { 0.58, 0.58, 0.57 }).empty()); // rounded
	CHECK(with_axis("tips_circumradius", { 0.0, 0.0, 0.0 }).empty());
	CHECK(with_axis("tips_circumradius", { 2.0, 0.0, 0.0 }).empty());
}

TEST_CASE("phase_of_value inverts the reference, 0 below it, 1 beyond it") {
	GestureModel model;
	model.reference_mean = Eigen::VectorXd::LinSpaced(101, 0.1, 0.9);
	CHECK(phase_of_value(model, 0.0) == 0.0);
	CHECK(phase_of_value(model, 0.1) == 0.0);
	CHECK(phase_of_value(model, 0.95) == 1.0);
	for (const double phase : { 0.004, 0.25, 0.333, 0.999 }) {
		CHECK(phase_of_value(model, 0.1 + 0.8 * phase) == test::near(phase).epsilon(1e-9));
	}
}
