#include "gesture/feature.h"
#include "gesture/model_file.h"
#include "gesture/observation.h"
#include "gesture/reference_curve.h"
#include "gesture/trainer.h"
#include "minimum_jerk_drag.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace steadyhand;

TEST_CASE("the velocity of a ramp is its slope at any sampling") {
	std::mt19937_64 random(1);
	std::uniform_real_distribution<double> step(0.001, 0.03);
	ObservationWindow window;
	double t_s = 3600.0;
	for (int i = 0; i < 200; ++i) {
		t_s += step(random);
		window.push(t_s, 1e6 + 0.4 * t_s);
	}
	CHECK(window.velocity_m_s() == test::near(0.4).epsilon(1e-6));
	CHECK(window.normalised(0.2, 0.5).y() == test::near(1.0).epsilon(1e-6));
}

TEST_CASE("equal and backward time stamps leave the velocity finite") {
	ObservationWindow window;
	window.push(1.0, 0.1);
	window.push(1.0, 0.2);
	CHECK(window.velocity_m_s() == 0.0);
	window.push(0.5, 99.0);
	CHECK(window.position_m() == 0.2);
}

TEST_CASE("the quantiser finds the clusters and the nearest codeword") {
	std::mt19937_64 random(2);
	std::normal_distribution<double> noise(0.0, 0.01);
	std::vector<Observation> points;
	for (int i = 0; i < 400; ++i) {
		points.push_back(Observation{ 0.25 * (i % 4) + noise(random), (i / 4) % 2 + noise(random) });
	}
	const VectorQuantiser quantiser = VectorQuantiser::trained(points, 8);
	REQUIRE(quantiser.symbols() == 8);
	for (int k = 0; k < 8; ++k) {
		const int column = k / 2;
		const Observation centre(0.25 * column, k % 2);
		CHECK((quantiser.codebook().row(quantiser.symbol(centre)).transpose() - centre).norm() < 0.01);
	}
}

TEST_CASE("each codeword is the mean of its nearest observations, sorted") {
	std::mt19937_64 random(3);
	std::normal_distribution<double> normal;
	std::vector<Observation> points;
	for (int i = 0; i < 300; ++i) {
		points.push_back(Observation{ 0.01 * normal(random), 5.0 * normal(random) });
	}
	for (const int symbols : { 1, 5, 16 }) {
		const VectorQuantiser quantiser = VectorQuantiser::trained(points, symbols);
		const Eigen::MatrixX2d &codebook = quantiser.codebook();
		Observation mean = Observation::Zero(), deviation = Observation::Zero();
		for (const Observation &point : points) {
			mean += point / 300.0;
		}
		for (const Observation &point : points) {
			deviation += (point - mean).cwiseAbs2() / 300.0;
		}
		CHECK((quantiser.scale() - deviation.cwiseSqrt()).norm() < 1e-12);
		Eigen::MatrixX2d sums = Eigen::MatrixX2d::Zero(symbols, 2);
		Eigen::VectorXd counts = Eigen::VectorXd::Zero(symbols);
		for (const Observation &point : points) {
			Eigen::Index nearest = 0;
			double least = 1e9;
			for (Eigen::Index k = 0; k < symbols; ++k) {
				const Eigen::Vector2d off =
						(codebook.row(k).transpose() - point).cwiseQuotient(deviation.cwiseSqrt());
				nearest = off.norm() < least ? k : nearest;
				least = std::min(least, off.norm());
			}
			CHECK(quantiser.symbol(point) == nearest);
			sums.row(nearest) += point.transpose();
			counts(nearest) += 1.0;
		}
		for (Eigen::Index k = 0; k < symbols; ++k) {
			CHECK((sums.row(k) / counts(k) - codebook.row(k))
							.cwiseQuotient(quantiser.scale().transpose())
							.norm() < 1e-8);
			CHECK((k == 0 || codebook(k - 1, 0) < codebook(k, 0)));
		}
	}
	// At equal positions the slower codeword comes first.
	std::vector<Observation> column;
	for (int i = 0; i < 40; ++i) {
		column.emplace_back(1.0, i % 4);
	}
	const VectorQuantiser ordered = VectorQuantiser::trained(column, 4);
	for (int k = 0; k < 4; ++k) {
		CHECK(ordered.symbol({ 1.0, k }) == k);
	}
}

TEST_CASE("identical or no observations give a finite codebook") {
	for (const std::size_t n : { 0U, 1U, 50U }) {
		const VectorQuantiser quantiser =
				VectorQuantiser::trained(std::vector<Observation>(n, { 0.5, 1.0 }), 16);
		CHECK(quantiser.symbols() == 16);
		CHECK(quantiser.codebook().allFinite());
		CHECK(quantiser.symbol({ 0.4, 1e9 }) >= 0);
	}
}

TEST_CASE("a movement's onset is at 5 % of its peak speed") {
	// v / v_peak = 16 s^2 (1 - s)^2 for a minimum-jerk movement. So the onset is at 4 s (1 - s) = sqrt(0.05),
	// s = 0.0594.
	const RecordedCurve curve =
			test::minimum_jerk_curve({ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.2 }, 240.0);
	const MovementSpan span = movement_span(curve, 0.3, 1.6);
	CHECK(span.onset_s == test::near(0.6594).epsilon(0.01));
	CHECK(span.end_s == 1.6);
	const Eigen::VectorXd normalised = normalised_curve(curve, { 0.6, 1.6 });
	for (Eigen::Index i = 0; i < CURVE_POINTS; ++i) {
		const double s = static_cast<double>(i) / 100.0;
		// Tolerance: the change of speed between two samples at 240 Hz.
		CHECK(std::abs(normalised(i) - s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)) < 2e-5);
	}
}

TEST_CASE("outlier curves are dropped from the reference") {
	std::vector<Eigen::VectorXd> curves(9, Eigen::VectorXd::LinSpaced(CURVE_POINTS, 0.0, 1.0));
	curves.push_back(Eigen::VectorXd::LinSpaced(CURVE_POINTS, 1.0, 0.0));
	const ReferenceCurve reference = reference_curve(curves, 0.9);
	CHECK(reference.kept == std::vector<bool>{ true, true, true, true, true, true, true, true, true, false });
	CHECK((reference.mean - curves.front()).norm() < 1e-12);
	CHECK(reference.deviation.maxCoeff() < 1e-12);
	// The mean of all ten is 0.1 + 0.8 s. R^2 of s against it: residual 0.2 s - 0.1, variance of s; 1 - 0.04.
	CHECK(reference.r2.front() == test::near(0.96).epsilon(1e-9));
}

TEST_CASE("training on minimum-jerk drags gives the minimum-jerk curve") {
	const GestureModel model = test::trained_drag_model();
	CHECK(model.provenance.recordings == 12);
	CHECK(model.elements.size() == 4);
	CHECK(model.typical_task.amplitude_m == test::near(0.2));
	for (int percent = 0; percent <= 100; ++percent) {
		const double phase = 0.01 * percent;
		// The span begins at 5 % of the peak speed (s = 0.0594), and ends at s = 1.
		const double s = 0.0594 + phase * (1.0 - 0.0594);
		const double expected = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
		CHECK(std::abs(evaluate(model, phase).value - expected) < 0.01);
	}
	const CurvePoint before = evaluate(model, 0.5 - 1e-5), after = evaluate(model, 0.5 + 1e-5);
	CHECK(evaluate(model, 0.5).slope == test::near((after.value - before.value) / 2e-5).epsilon(1e-3));
	CHECK(evaluate(model, 0.5).curvature == test::near((after.slope - before.slope) / 2e-5).epsilon(1e-2));
	for (const double value : { 0.1, 0.5, 0.9 }) {
		CHECK(evaluate(model, phase_of_value(model, value)).value == test::near(value).epsilon(0.01));
	}
}

TEST_CASE("a model has its recordings' mean start, axis, amplitude and duration") {
	// All have the same duration. The mean duration begins at 5 % of the peak speed, s = 0.0594.
	for (const double duration_s : { 0.5, 2.0 }) {
		CAPTURE(duration_s);
		std::vector<TrainingRecording> recordings;
		for (int i = 0; i < 6; ++i) {
			const test::Drag drag{ .onset_s = 0.5, .duration_s = duration_s, .amplitude_m = 0.1 + 0.02 * i };
			Task task;
			task.start_m = Eigen::Vector3d(0.0, 0.01 * i, -0.02 * i);
			task.amplitude_m = drag.amplitude_m;
			const double end_s = drag.onset_s + drag.duration_s;
			recordings.push_back({ "drag", task, 0.3, end_s, test::drag_track(drag, 110.0, end_s + 0.5),
					test::drag_track(drag, 240.0, end_s + 0.5) });
		}
		// A recording without movement has no influence.
		TrainingRecording &still = recordings.emplace_back(recordings[0]);
		still.name = "still";
		still.reference = test::drag_track({ .amplitude_m = 0.0 }, 240.0, 3.0);
		const GestureModel model = train("drag", "index_along_axis", recordings, {}).value();
		CHECK(model.provenance.recordings == 6);
		CHECK(model.provenance.dropped == std::vector<std::string>{ "still" });
		CHECK(model.typical_task.amplitude_m == test::near(0.15));
		CHECK((model.typical_task.start_m - Eigen::Vector3d(0.0, 0.025, -0.05)).norm() < 1e-12);
		CHECK((model.typical_task.axis - Task{}.axis).norm() < 1e-12);
		CHECK(model.duration_mean_s == test::near(0.9406 * duration_s).epsilon(0.01));
		CHECK(model.duration_deviation_s < 0.01 * duration_s);
		// The peak speed, 1.875 amplitudes / whole duration, relative to that of the model.
		CHECK(model.quantiser.codebook().col(1).maxCoeff() == test::near(1.875 * 0.9406).epsilon(0.06));
	}
	const GestureModel model = test::trained_drag_model();
	// Sample standard deviation of 0.8, 0.85 .. 1.35 s: 0.05 sqrt(13).
	CHECK(model.duration_mean_s == test::near(0.9406 * 1.075).epsilon(0.01));
	CHECK(model.duration_deviation_s == test::near(0.9406 * 0.05 * std::sqrt(13.0)).epsilon(0.02));
	TrainingOptions options;
	options.states = 21;
	CHECK_FALSE(train("drag", "index_along_axis", test::drag_recordings(), options).ok());
	options = {};
	options.symbols = 1025;
	CHECK_FALSE(train("drag", "index_along_axis", test::drag_recordings(), options).ok());
}

TEST_CASE("training is deterministic, and its errors name the cause") {
	CHECK(format_model(test::trained_drag_model()) == format_model(test::trained_drag_model()));
	const std::vector<TrainingRecording> drags = test::drag_recordings();
	CHECK(train("none", "index_along_axis", drags, {}).error() ==
			"the gesture's name 'none' stands for no gesture in results; choose another name");
	CHECK(train("a/b", "index_along_axis", drags, {}).error() ==
			"the gesture's name 'a/b' has a character that no file name may have");
	CHECK(train("drag", "toe_angle", drags, {}).error() ==
			"drag: there is no feature 'toe_angle', there are: index_along_axis tips_circumradius "
			"index_along_circle");
	CHECK(train("drag", "index_along_axis", {}, {}).error() == "drag: there are no recordings");
	TrainingOptions options;
	options.states = 0;
	CHECK(train("drag", "index_along_axis", drags, options).error() == "drag: states: 0 is not in 1..20");
	for (const double threshold : { -0.1, 5.0, std::numeric_limits<double>::quiet_NaN() }) {
		options = {};
		options.r2_threshold = threshold;
		CHECK(train("drag", "index_along_axis", drags, options).error().ends_with("is not in 0..1"));
	}
	// Times in microseconds: symbols at 10 ms would not fit into memory.
	std::vector<TrainingRecording> of_another_unit = drags;
	for (TrainingRecording &recording : of_another_unit) {
		recording.start_s *= 1e6;
		recording.end_s *= 1e6;
		for (Track *const track : { &recording.measured, &recording.reference }) {
			std::ranges::for_each(track->frames, [](HandFrame &frame) { frame.t_s *= 1e6; });
		}
	}
	const std::string too_long = train("drag", "index_along_axis", of_another_unit, {}).error();
	CHECK(too_long ==
			"drag: none of the 12 recordings is usable; " + drags[0].name +
					": its gesture takes 1000000 s, and 3600 are the most; start_s, end_s and t are seconds");
	options = {};
	options.progress = [](double) { return false; };
	CHECK(train("drag", "index_along_axis", drags, options).error() == "drag: training was stopped");
}

TEST_CASE("training refuses pseudo-counts of 0") {
	const std::vector<TrainingRecording> drags = test::drag_recordings();
	for (const double count : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL }) {
		TrainingOptions options;
		options.baum_welch.pseudo.symbol = count;
		CHECK(train("drag", "index_along_axis", drags, options).error().starts_with("drag: pseudo-counts: "));
		options = {};
		options.baum_welch.pseudo.transition = count;
		CHECK(train("drag", "index_along_axis", drags, options).error().starts_with("drag: pseudo-counts: "));
	}
}

TEST_CASE("training warns of more states than the recordings determine") {
	std::mt19937_64 random(8);
	std::normal_distribution<double> odd(0.0, 0.04);
	std::vector<TrainingRecording> drags = test::drag_recordings();
	drags.resize(3);
	std::string warning = "?";
	TrainingOptions options;
	options.states = 4;
	REQUIRE(train("drag", "index_along_axis", drags, options, nullptr, &warning).ok());
	CHECK(warning.empty());
	for (TrainingRecording &drag : drags) {
		for (HandFrame &frame : drag.reference.frames) {
			frame.set(Joint::INDEX, frame.position(Joint::INDEX) + Eigen::Vector3d(odd(random), 0.0, 0.0));
		}
	}
	options.states = 15;
	const Result<GestureModel> model = train("drag", "index_along_axis", drags, options, nullptr, &warning);
	REQUIRE(model.ok());
	CHECK(warning.starts_with("polynomials of degree 5 in 15 states leave the recordings' mean; "));
	for (int i = 0; i <= 1000; ++i) {
		REQUIRE(std::abs(evaluate(model.value(), 0.001 * i).value) < 1.6);
	}
}

TEST_CASE("the date of a recording does not change the model") {
	const auto codebook = [](double later_s) {
		std::vector<TrainingRecording> recordings = test::drag_recordings();
		// Times are multiples of 1 / 1024 s, so that a shift does not round them.
		const auto moved = [&](double t_s) { return std::round(1024.0 * t_s) / 1024.0 + later_s; };
		for (TrainingRecording &recording : recordings) {
			recording.start_s = moved(recording.start_s);
			recording.end_s = moved(recording.end_s);
			for (Track *track : { &recording.measured, &recording.reference }) {
				for (HandFrame &frame : track->frames) {
					frame.t_s = moved(frame.t_s);
				}
			}
		}
		return train("drag", "index_along_axis", recordings, {}).value().quantiser.codebook();
	};
	CHECK((codebook(-64.0) - codebook(0.0)).cwiseAbs().maxCoeff() < 1e-9);
	CHECK((codebook(64.0) - codebook(0.0)).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("a model has each direction of its recordings") {
	std::vector<TrainingRecording> drags = test::drag_recordings();
	CHECK(train("drag", "index_along_axis", drags, {}).value().other_axes.empty());
	// Half of them are reversed, so that a mean of the axes would be 0.
	for (std::size_t i = 1; i < drags.size(); i += 2) {
		for (Track *track : { &drags[i].measured, &drags[i].reference }) {
			for (HandFrame &frame : track->frames) {
				frame.set(Joint::INDEX, -frame.position(Joint::INDEX));
			}
		}
		drags[i].task.axis = -drags[i].task.axis;
	}
	const GestureModel both = train("drag", "index_along_axis", drags, {}).value();
	CHECK(both.other_axes == std::vector{ Eigen::Vector3d(-Task{}.axis) });
	CHECK(both.typical_task.axis == Task{}.axis);
	CHECK(parse_model(format_model(both), "a.gesture").value().other_axes == both.other_axes);
}

TEST_CASE("training reports progress from 0 to 1 and stops on request") {
	std::vector<TrainingRecording> drags = test::drag_recordings();
	drags.erase(drags.begin() + 4, drags.end()); // it is trained anew for each step
	TrainingOptions options;
	std::vector<double> steps;
	options.progress = [&](double done) {
		steps.push_back(done);
		return true;
	};
	std::vector<NormalisedRecording> recordings;
	const GestureModel model = train("drag", "index_along_axis", drags, options, &recordings).value();
	REQUIRE(steps.size() > 20);
	CHECK(std::is_sorted(steps.begin(), steps.end()));
	CHECK(steps.front() >= 0.0);
	CHECK(steps.back() == 1.0);
	for (std::size_t last = 0; last < steps.size(); ++last) {
		std::size_t told = 0;
		options.progress = [&](double) { return told++ < last; };
		CHECK(train("drag", "index_along_axis", drags, options).error() == "drag: training was stopped");
		CHECK(told == last + 1);
	}
	REQUIRE(recordings.size() == drags.size());
	CHECK(recordings.front().name == drags.front().name);
	Eigen::VectorXd sum = Eigen::VectorXd::Zero(CURVE_POINTS);
	for (const NormalisedRecording &recording : recordings) {
		CHECK(recording.kept == (recording.r2 >= options.r2_threshold));
		sum += recording.kept ? recording.curve : Eigen::VectorXd::Zero(CURVE_POINTS);
	}
	CHECK((sum / model.provenance.recordings - model.reference_mean).norm() < 1e-12);
}

TEST_CASE("one recording, or recordings of one frame, give a model or error") {
	std::vector<TrainingRecording> one = test::drag_recordings();
	one.resize(1);
	CHECK(train("drag", "index_along_axis", one, {}).ok());
	one[0].measured.frames.resize(1);
	CHECK(train("drag", "index_along_axis", one, {}).error() ==
			"drag: none of the 1 recordings is usable; " + one[0].name +
					": its measured track has no motion of index_along_axis");
}

TEST_CASE("a model file reads back to the same bits") {
	const GestureModel model = test::trained_drag_model();
	const std::string text = format_model(model);
	const Result<GestureModel> read = parse_model(text, "a.gesture");
	REQUIRE(read.ok());
	CHECK(format_model(read.value()) == text);
	CHECK(read.value().hmm.log_b == model.hmm.log_b);
	CHECK(read.value().reference_mean == model.reference_mean);
}

TEST_CASE("a damaged model file gives one error with cause and place") {
	const std::string text = format_model(test::trained_drag_model());
	const auto replaced = [&](const std::string &what, const std::string &with) {
		std::string damaged = text;
		damaged.replace(damaged.find(what), what.size(), with);
		return parse_model(damaged, "a.gesture").error();
	};
	CHECK(parse_model("", "a.gesture").error() == "a.gesture:1: not valid JSON: the file ends here");
	CHECK(parse_model("{ \"format\": x }", "a.gesture").error() == "a.gesture:1: not valid JSON");
	const std::string cut = text.substr(0, text.find("\"duration_mean_s\"") + 4);
	const auto last_line = 1 + std::count(cut.begin(), cut.end(), '\n');
	CHECK(parse_model(cut, "a.gesture").error() ==
			"a.gesture:" + std::to_string(last_line) + ": not valid JSON: the file ends here");
	CHECK(replaced("\"version\": 1", "\"version\": 1e400") == "a.gesture:3: number overflow parsing '1e400'");
	CHECK(parse_model("\n[1, 2]", "a.gesture").error() ==
			"a.gesture:2: format: not a steadyhand-gesture file");
	const auto at = [&](const std::string &key) {
		const std::size_t place = text.find("\"" + key + "\"");
		return "a.gesture:" +
				std::to_string(1 +
						std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n')) +
				": ";
	};
	CHECK(replaced("\"version\": 1", "\"version\": 9") ==
			at("version") + "version: must be 1. Update SteadyHand, or make the file again");
	CHECK(replaced("\"feature\": \"index_along_axis\"", "\"feature\": \"toe\"") ==
			at("feature") + "feature: there is no feature 'toe'");
	CHECK(replaced("\"duration_mean_s\": ", "\"duration_mean_s\": -")
					.starts_with(at("duration_mean_s") + "duration_mean_s: not within 1e-05 .. 3600, is -"));
	const auto field = [&](const std::string &key, const std::string &value) {
		std::string damaged = text;
		const std::size_t from = damaged.find("\"" + key + "\": ") + key.size() + 4;
		damaged.replace(from, damaged.find_first_of(",\n", from) - from, value);
		return parse_model(damaged, "a.gesture").error();
	};
	CHECK(field("typical_amplitude_m", "0") ==
			at("typical_amplitude_m") + "typical_amplitude_m: not within 1e-06 .. 1e+09, is 0");
	CHECK(field("recordings", "-1") == at("recordings") + "recordings: not a number of recordings");
	CHECK(field("recordings", "1e10") == at("recordings") + "recordings: not a number of recordings");
	CHECK(field("version", "0") ==
			at("version") + "version: must be 1. Update SteadyHand, or make the file again");
	CHECK(field("phase_end", "0.0") ==
			at("phase_end") + "elements: phase_end must be phase_begin + 0.01 at least");
	CHECK(field("deviation", "null") == at("deviation") + "deviation: not a number");
	CHECK(replaced("\"other_axes\": []", "\"other_axes\": 0") ==
			at("other_axes") + "other_axes: not a list of axes");
	CHECK(replaced("\"other_axes\": []", "\"other_axes\": [[0, 2, 0]]") ==
			at("other_axes") + "other_axes: not an axis of length 1");
	CHECK(replaced("\"log_b\"", "\"log_x\"") == at("hmm") + "log_b: missing");
	for (std::size_t length = 0; length < text.size(); length += 97) {
		CHECK_FALSE(parse_model(text.substr(0, length), "cut").ok());
	}
}
