#include "gesture_events.h"
#include "signal/minimum_jerk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

// What a tracker holds, loses and shows again, in an order that no single fault has.

namespace {

constexpr double WAY_M = 0.2; ///< of Task{}
constexpr double NEVER_S = 1e9;
constexpr double HALF_MS = 0.5e-3;

HandFrame index_at(double t_s, const Eigen::Vector3d &place_m) {
	HandFrame frame;
	frame.t_s = t_s;
	frame.set(Joint::INDEX, place_m);
	return frame;
}

/// Of a hand that is lost, or whose tracker shows its last pose, from a share of its way on.
struct Loss {
	double share, duration_s;
	bool is_freeze;
};

struct Outcome {
	std::vector<std::string> said;
	double ended_after_s; ///< since the last news of the hand
};

Outcome lost_on_its_way(const Loss &loss) {
	const Drag drag{ .onset_s = 1.0, .duration_s = loss.duration_s, .amplitude_m = WAY_M };
	double lost_s = drag.onset_s;
	while (drag.x_m(lost_s) < loss.share * WAY_M) {
		lost_s += HALF_MS;
	}
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	Tremor tremor(1e-4, 3);
	double news_s = 0.0;
	const Way seen = [&](double t_s) {
		news_s = t_s;
		return Eigen::Vector3d(drag.x_m(t_s) * X + tremor());
	};
	const double lost_from_s = loss.is_freeze ? NEVER_S : lost_s;
	const Way way = held(seen, lost_s, NEVER_S);
	const Events events = watch(recogniser, way, lost_s + 4.0, lost_from_s, NEVER_S, 110.0, 0.0);
	return { events.said, events.last_ended_s - news_s };
}

} // namespace

TEST_CASE("a hand at rest that is held, lost, and seen elsewhere twice in one place") {
	for (const bool has_task : { true, false }) {
		GestureRecogniser recogniser(
				{ models()[0] }, has_task ? std::optional(Task{}) : std::nullopt, MotionMode::PHASE);
		StrokeFinder finder;
		Tremor tremor(3e-4, 1);
		double t_s = 0.0;
		const auto show = [&](const Eigen::Vector3d &place_m) {
			recogniser.push(index_at(t_s, place_m));
			finder.push({ .t_s = t_s }, { place_m.x(), place_m.y(), place_m.z(), 0.0 });
			CHECK(finder.strokes().size() < 10);
			recogniser.advance(t_s);
		};
		Eigen::Vector3d place_m;
		for (int i = 0; i < 200; ++i, t_s += 0.01) {
			place_m = tremor();
			show(place_m);
		}
		for (int i = 0; i < 30; ++i, t_s += 0.01) {
			show(place_m);
		}
		t_s += 1.5;
		for (int i = 0; i < 2; ++i, t_s += 0.01) {
			show({ 0.1, 0.05, 0.0 });
		}
		CHECK(recogniser.confidence() >= 0.0);
	}
}

TEST_CASE("an end that a frozen tracker hides counts as long as one in a gap does") {
	for (const double duration_s : { 0.4, 0.5, 0.7, 1.0, 2.0 }) {
		for (const double share : { 0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.65 }) {
			for (const bool is_freeze : { false, true }) {
				CAPTURE(duration_s);
				CAPTURE(share);
				CAPTURE(is_freeze);
				const Outcome outcome = lost_on_its_way({ share, duration_s, is_freeze });
				const bool has_ended = outcome.said == times(1, "sideways");
				CHECK((!has_ended || outcome.ended_after_s < 0.31));
				// A hand that stops is waited for as long as its tracker repeats itself.
				const std::vector<std::string> begun{ "started sideways" };
				CHECK((has_ended || (outcome.said == begun) == is_freeze));
			}
		}
	}
}

TEST_CASE("a gesture in two halves counts however long the hand trembled between them" *
		doctest::test_suite("figures")) {
	constexpr double RATE_HZ = 110.0;
	for (const double rests_s : { 5.0, 20.0 }) {
		for (unsigned seed = 0; seed < 40; ++seed) {
			CAPTURE(rests_s);
			CAPTURE(seed);
			const std::vector<Drag> halves{ { .onset_s = 1.0, .duration_s = 0.6, .amplitude_m = 0.5 * WAY_M },
				{ .onset_s = 1.6 + rests_s, .duration_s = 0.6, .amplitude_m = 0.5 * WAY_M } };
			Tremor tremor(2e-3, seed);
			GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
			const Way way = [&](double t_s) { return Eigen::Vector3d(x_m(halves, t_s) * X + tremor()); };
			const Events events = watch(recogniser, way, rests_s + 4.0, NEVER_S, NEVER_S, RATE_HZ, 0.0);
			CHECK(std::ranges::count(events.said, "ended sideways") == 1);
		}
	}
}

TEST_CASE("without a task a tracker's step before the gesture shifts no start, at any rate") {
	const std::vector<Drag> strokes{ { .onset_s = 4.0, .duration_s = 0.4, .amplitude_m = 0.018 },
		{ .onset_s = 5.15, .duration_s = 0.8, .amplitude_m = 0.182 } };
	for (const double rate_hz : { 110.0, 250.0, 1000.0 }) {
		for (const double step_m : { 0.0, 0.05, -0.05 }) {
			CAPTURE(rate_hz);
			CAPTURE(step_m);
			Tremor tremor(1e-4, 3);
			const Way way = [&](double t_s) {
				return Eigen::Vector3d((x_m(strokes, t_s) + (t_s > 2.0 ? step_m : 0.0)) * X + tremor());
			};
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Events events = watch(recogniser, way, 6.2, NEVER_S, NEVER_S, rate_hz, 0.0);
			CHECK(std::abs(events.last_value_m - WAY_M) < 0.005);
		}
	}
}

TEST_CASE("a finger that is lost while a zoom's hand closes hides no drag that comes next") {
	constexpr double OPENS_S = 1.0, CLOSES_S = 2.4, RADIUS_M = 0.03;
	const std::array joints{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
	const std::array angles_rad{ 3.6, 1.5, 0.4 };
	for (const double closes_for_s : { 0.15, 0.2, 0.25, 0.3 }) {
		for (const double drag_s : { 2.9, 3.4 }) {
			CAPTURE(closes_for_s);
			CAPTURE(drag_s);
			GestureRecogniser recogniser({ zoom_model(RADIUS_M, RADIUS_M), models()[0], models()[1] },
					std::nullopt, MotionMode::PHASE);
			Tremor tremor(2e-4, 3);
			const double lost_s = CLOSES_S + closes_for_s; // the thumb
			bool has_ended = false;
			for (int i = 0; i < 500; ++i) {
				const double t_s = i / 110.0;
				const double gone = minimum_jerk((t_s - OPENS_S) / 0.9).value -
						minimum_jerk((std::min(t_s, lost_s) - CLOSES_S) / 0.8).value;
				HandFrame frame;
				frame.t_s = t_s;
				for (std::size_t j = t_s < lost_s ? 0 : 1; j < joints.size(); ++j) {
					const Eigen::Vector3d tip(std::cos(angles_rad[j]), std::sin(angles_rad[j]), 0.0);
					frame.set(joints[j],
							WAY_M * minimum_jerk((t_s - drag_s) / 0.8).value * X + tremor() +
									RADIUS_M * (1.0 + gone) * tip);
				}
				recogniser.push(frame);
				recogniser.advance(t_s);
				const GestureSession *const session = recogniser.session();
				has_ended = has_ended ||
						(session != nullptr && session->model().gesture == "sideways" &&
								session->stage() == GestureSession::Stage::ENDED);
			}
			CHECK(has_ended);
		}
	}
}
