#include "classifier_streams.h"
#include "near.h"

#include <algorithm>
#include <iterator>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Event = GestureSpotter::Event;

/// Checks that a gesture begins and ends once, and that there is no other event.
void check_one(const std::vector<Spotted> &spotted, const std::string &gesture) {
	REQUIRE(spotted.size() == 2);
	CHECK(spotted[0].event == Event::STARTED);
	CHECK(spotted[1].event == Event::ENDED);
	CHECK(spotted[0].gesture == gesture);
	CHECK(spotted[1].gesture == gesture);
}

TEST_CASE("drags in four directions begin in motion and end within 0.2 s") {
	struct Row {
		Eigen::Vector3d displacement_m;
		double duration_s;
		std::string gesture;
	};
	for (const auto &[displacement_m, duration_s, gesture] :
			{ Row{ { 0.2, 0.0, 0.0 }, 0.9, "horizontal_drag" },
					Row{ { -0.2, 0.0, 0.0 }, 0.9, "horizontal_drag" },
					Row{ { 0.0, 0.2, 0.0 }, 0.9, "vertical_drag" },
					Row{ { 0.0, -0.2, 0.0 }, 1.2, "vertical_drag" } }) {
		INFO("displacement ", displacement_m.transpose());
		const Reach reach{ .displacement_m = displacement_m, .duration_s = duration_s };
		const std::vector<Spotted> spotted = spot(frames_of(reach));
		check_one(spotted, gesture);
		CHECK(spotted[0].t_s > reach.start_s);
		CHECK(spotted[0].t_s < reach.start_s + 0.75 * duration_s);
		CHECK(std::abs(spotted[1].t_s - (reach.start_s + duration_s)) < 0.2);
		const GestureCandidate &candidate = spotted[1].candidate;
		CHECK((candidate.start_m - reach.from_m).norm() < 0.005);
		CHECK(candidate.axis.dot(displacement_m.normalized()) > 0.999);
		CHECK(candidate.onset_s < reach.start_s + 0.15);
	}
}

TEST_CASE("oblique and short movements end no gesture") {
	CHECK(spot(frames_of({ .displacement_m = { 0.14, 0.14, 0.0 } })).empty());
	CHECK(spot(frames_of({ .displacement_m = { 0.0, 0.0, 0.2 } })).empty()); // towards the user
	CHECK(std::ranges::count(spot(frames_of({ .displacement_m = { 0.07, 0.0, 0.0 } })), Event::ENDED,
				  &Spotted::event) == 0);
}

TEST_CASE("position and time of a gesture do not change the result") {
	const std::vector<Spotted> here = spot(frames_of({}));
	const double hours_s = 3.0 * 3600.0; // whole periods of the symbol clock
	const Reach elsewhere{ .from_m = { 1.15, -0.7, 1.95 }, .clock_s = hours_s + 0.003 };
	const std::vector<Spotted> there = spot(frames_of(elsewhere));
	REQUIRE(here.size() == there.size());
	for (std::size_t i = 0; i < here.size(); ++i) {
		CHECK(there[i].gesture == here[i].gesture);
		CHECK(there[i].t_s - hours_s == near(here[i].t_s).epsilon(1e-6));
		CHECK(there[i].candidate.log_likelihood_ratio ==
				near(here[i].candidate.log_likelihood_ratio).epsilon(1e-6));
	}
}

TEST_CASE("sensors of 30 to 240 Hz end a drag within 0.12 s") {
	const std::vector<Spotted> usual_rate = spot(frames_of({}));
	for (const double rate_hz : { 30.0, 60.0, 90.0, 240.0 }) {
		const std::vector<Spotted> spotted = spot(frames_of({ .rate_hz = rate_hz }));
		CAPTURE(rate_hz);
		check_one(spotted, "horizontal_drag");
		CHECK(std::abs(spotted[1].t_s - usual_rate[1].t_s) < 0.12);
	}
}

bool is_same(const GestureCandidate &one, const GestureCandidate &other) {
	return one.posterior == other.posterior && one.onset_s == other.onset_s && one.start_m == other.start_m &&
			one.axis == other.axis && one.log_likelihood_ratio == other.log_likelihood_ratio &&
			one.end_probability == other.end_probability;
}

TEST_CASE("a reset classifier gives the same bits as a new one") {
	GestureClassifier used = four_gestures();
	for (const HandFrame &frame : frames_of({ .displacement_m = { 0.0, 0.2, 0.0 } })) {
		used.push(frame);
	}
	used.reset();
	GestureClassifier fresh = four_gestures();
	for (const HandFrame &frame : frames_of({ .clock_s = 50.0 })) {
		used.push(frame);
		fresh.push(frame);
		for (std::size_t g = 0; g < FOUR_GESTURES.size(); ++g) {
			REQUIRE(is_same(used.candidates()[g], fresh.candidates()[g]));
		}
	}
}

TEST_CASE("ten minutes of rest before a drag do not change it" * doctest::test_suite("figures")) {
	const std::vector<Spotted> early = spot(frames_of({}));
	const std::vector<Spotted> spotted = spot(frames_of({ .start_s = 601.0, .length_s = 603.0 }));
	check_one(spotted, "horizontal_drag");
	CHECK(spotted[0].t_s - 600.0 == near(early[0].t_s).epsilon(1e-6));
	CHECK(spotted[1].t_s - 600.0 == near(early[1].t_s).epsilon(1e-6));
	CHECK(spotted[1].candidate.log_likelihood_ratio ==
			near(early[1].candidate.log_likelihood_ratio).epsilon(1e-2));
}

TEST_CASE("a gesture is found after equal, earlier and much later stamps") {
	GestureSpotter spotter(four_gestures());
	spot(spotter, frames_of({}));
	spot(spotter, frames_of({})); // all of these are ignored
	check_one(spot(spotter, frames_of({ .clock_s = 3600.0 })), "horizontal_drag");
}

TEST_CASE("an immediate return is no second gesture") {
	const Reach there,
			back{ there.from_m + there.displacement_m, -there.displacement_m, 0.2, 0.9, 3.0, 97.0, 2.503 };
	GestureSpotter spotter(four_gestures());
	std::vector<HandFrame> frames = frames_of({ .length_s = 2.5 });
	std::ranges::copy(frames_of(back), std::back_inserter(frames));
	check_one(spot(spotter, frames), "horizontal_drag");
	check_one(spot(spotter, frames_of({ .clock_s = 10.0 })), "horizontal_drag");
}

TEST_CASE("missing index tips and coordinates of 1e9 m keep posteriors finite") {
	GestureClassifier classifier = four_gestures();
	for (int i = 0; i < 300; ++i) {
		HandFrame frame;
		frame.t_s = 0.01 * i;
		if (i % 3 == 0) {
			frame.set(Joint::INDEX, Eigen::Vector3d::Constant(i % 2 == 0 ? 1e9 : -1e9));
		}
		classifier.push(frame);
		for (const GestureCandidate &candidate : classifier.candidates()) {
			CHECK(std::isfinite(candidate.posterior));
			CHECK(candidate.posterior < 0.5);
		}
	}
}

} // namespace
