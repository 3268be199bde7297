// Gestures and tasks that come and go while the hand is under way, and frames that come twice.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double CHANGED_S = 1.1; ///< half-way
const Task HERE{ Eigen::Vector3d::Zero(), X, 0.2 }, THERE{ 0.4 * Y, X, 0.2 }, AHEAD{ 0.1 * X, X, 0.2 };

ExpectedGesture drag_at(const std::optional<Task> &task) {
	return { models()[0], task };
}

struct Run {
	std::vector<double> values_m;
	std::vector<std::string> said;
	std::vector<int> now; ///< what expect() returned
};

/// A drag along x, before and after which the hand rests; from CHANGED_S on the others are expected.
Run run(const std::vector<ExpectedGesture> &first, const std::vector<ExpectedGesture> &then,
		double changed_s = CHANGED_S) {
	GestureRecogniser recogniser(first);
	Run run;
	run.said = watch(
			recogniser,
			[&](double t_s) {
				run.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
				if (run.now.empty() && t_s > changed_s) {
					run.now = recogniser.expect(then);
				}
				return Eigen::Vector3d(DRAG.x_m(t_s) * X);
			},
			2.5)
					   .said;
	return run;
}

} // namespace

TEST_CASE("what else is expected may change under way: the motion stays the same to the last bit") {
	for (const std::optional<Task> &here : { std::optional(HERE), std::optional<Task>() }) {
		const std::vector<double> alone = run({ drag_at(here) }, { drag_at(here) }).values_m;
		const ExpectedGesture own = drag_at(here);
		const ExpectedGesture other = here ? drag_at(THERE) : ExpectedGesture{ models()[2], std::nullopt };
		for (const auto &[first, then, now] : {
					 std::tuple{ std::vector{ own, other }, std::vector{ own }, std::vector{ 0, -1 } },
					 std::tuple{ std::vector{ own }, std::vector{ own, other }, std::vector{ 0 } },
					 std::tuple{ std::vector{ own, other }, std::vector{ other, own }, std::vector{ 1, 0 } },
			 }) {
			const Run changed = run(first, then);
			CHECK(changed.values_m == alone);
			CHECK(changed.now == now);
			CHECK(changed.said == times(1, "sideways"));
		}
	}
}

TEST_CASE("a gesture that is expected no longer is none, and its motion begins anew") {
	const Run gone = run({ drag_at(HERE) }, { drag_at(THERE) });
	CHECK(gone.now == std::vector{ -1 });
	CHECK(gone.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	const Run none = run({ drag_at(HERE) }, {});
	CHECK(none.now == std::vector{ -1 });
	CHECK(none.values_m.back() == 0.0);
}

TEST_CASE("a place that is expected later is followed from then on") {
	// The hand is at its start, as if it had been expected all along: 0.1 m on.
	const Run later = run({ drag_at(HERE) }, { drag_at(AHEAD) }, 0.3);
	const Run always = run({ drag_at(AHEAD) }, { drag_at(AHEAD) });
	CHECK(later.values_m.back() == near(0.1).epsilon(0.05));
	CHECK(later.values_m.back() == near(always.values_m.back()).epsilon(0.01));
}

TEST_CASE("a stroke that has ended as a gesture is no other one's that is expected after it") {
	const ExpectedGesture drag = drag_at(HERE), free_drag = drag_at(std::nullopt);
	const std::vector<std::string> once = times(1, "sideways");
	for (const double after_s : { 0.0, 0.05, 0.2, 0.5 }) {
		CAPTURE(after_s);
		const double changed_s = 0.6 + 1.0 + after_s; // the hand is at the end, and stays there
		CHECK_MESSAGE(run({ drag }, { free_drag }, changed_s).said == once, "its task is gone");
		CHECK_MESSAGE(run({ free_drag }, { drag }, changed_s).said == once, "its task has come");
		CHECK_MESSAGE(run({ drag }, { drag_at(THERE) }, changed_s).said == once, "its task is elsewhere");
	}
	GestureRecogniser recogniser({ drag });
	bool is_off = false, is_on_again = false;
	const Events events = watch(
			recogniser,
			[&](double t_s) {
				if (!is_off && t_s > 1.7) {
					is_off = true;
					recogniser.expect({});
				} else if (!is_on_again && t_s > 2.0) {
					is_on_again = true;
					recogniser.expect({ drag });
				}
				// Back, and the drag once more.
				return Eigen::Vector3d(x_m({ DRAG, { 2.5, 0.6, -0.2 }, { 4.0, 1.0, 0.2 } }, t_s) * X);
			},
			6.0);
	CHECK_MESSAGE(events.said == times(2, "sideways"), "off and on: the next one counts again");
}

TEST_CASE("a stroke that makes a gesture is none of one that is expected while it is under way") {
	const Task near_by{ 0.01 * X, X, 0.2 }, beside{ 0.01 * Y, X, 0.2 },
			longer{ Eigen::Vector3d::Zero(), X, 0.25 };
	for (const std::optional<Task> &here : { std::optional(HERE), std::optional<Task>() }) {
		const ExpectedGesture own = drag_at(here);
		const ExpectedGesture again = own;
		for (const ExpectedGesture &other : { again, drag_at(near_by), drag_at(beside), drag_at(longer) }) {
			for (const double changed_s : { 0.9, CHANGED_S, 1.3 }) { // from a fifth of the way on
				CAPTURE(changed_s);
				GestureRecogniser recogniser({ own });
				bool is_changed = false;
				const Way way = [&](double t_s) {
					if (!is_changed && t_s > changed_s) {
						is_changed = true;
						recogniser.expect({ own, other });
					}
					return Eigen::Vector3d(x_m({ DRAG, { 3.0, 1.0, -0.2 } }, t_s) * X);
				};
				CHECK(watch(recogniser, way, 2.5).said == times(1, "sideways"));
			}
		}
	}
}

TEST_CASE("what was expected while another gesture was under way counts with the next stroke") {
	GestureRecogniser recogniser({ drag_at(HERE) });
	bool is_added = false, is_left = false;
	const Way way = [&](double t_s) {
		if (!is_added && t_s > CHANGED_S) {
			is_added = true;
			recogniser.expect({ drag_at(HERE), drag_at(AHEAD) });
		} else if (!is_left && t_s > 2.0) {
			is_left = true;
			recogniser.expect({ drag_at(AHEAD) });
		}
		return Eigen::Vector3d(x_m({ DRAG, { 2.5, 0.6, -0.1 }, { 4.0, 1.0, 0.2 } }, t_s) * X);
	};
	CHECK(watch(recogniser, way, 6.0).said == times(2, "sideways"));
}

TEST_CASE("the way back may have begun before the end was told that brings its task") {
	const ExpectedGesture there = drag_at(HERE), back{ models()[0], Task{ 0.2 * X, -X, 0.2 } };
	for (const double back_s : { 0.95, 1.0 }) { // 95 % of the way are made by then
		for (const double late_s : { 0.0, 0.1, 0.2 }) {
			CAPTURE(back_s);
			CAPTURE(late_s);
			GestureRecogniser recogniser({ there });
			double flip_s = 1e9;
			const Way way = [&](double t_s) {
				const GestureSession *session = recogniser.session();
				if (flip_s == 1e9 && session && session->stage() == GestureSession::Stage::ENDED) {
					flip_s = t_s + late_s;
				}
				if (t_s >= flip_s) {
					flip_s = INFINITY;
					recogniser.expect({ back });
				}
				return Eigen::Vector3d(x_m({ { 0.6, 0.4, 0.2 }, { back_s, 0.4, -0.2 } }, t_s) * X);
			};
			CHECK(watch(recogniser, way, 3.0).said == times(2, "sideways"));
		}
	}
}

TEST_CASE("of a gesture that was expected three times two go on where it is expected twice") {
	const ExpectedGesture drag = drag_at(HERE);
	const std::vector<double> alone = run({ drag }, { drag }).values_m;
	const Run fewer = run({ drag, drag, drag }, { drag, drag });
	CHECK(fewer.now == std::vector{ 0, 1, -1 });
	CHECK(fewer.values_m == alone);
}

TEST_CASE("a gesture that is expected from then on is shown as it is, with nothing of one that went") {
	// The first one's motion is still being handed over to the second one's when both go.
	const ExpectedGesture first{ model("first", X, false), std::nullopt };
	const ExpectedGesture second{ model("second", Y, false), std::nullopt };
	GestureRecogniser recogniser({ first, second });
	const Drag up{ .onset_s = 2.0, .duration_s = 0.5, .amplitude_m = 0.2 };
	double taken_over_s = INFINITY, left_m = INFINITY;
	const Way way = [&](double t_s) {
		taken_over_s = recogniser.gesture() == 1 ? std::min(taken_over_s, t_s) : taken_over_s;
		if (left_m == INFINITY && t_s > taken_over_s + 0.02) {
			recogniser.expect({ drag_at(THERE) });
			const double with_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
			const Motion own = recogniser.motion(MotionSource::SYNTHESISED, t_s + 1.0);
			left_m = std::abs(with_m - own.value_m);
		}
		return Eigen::Vector3d(DRAG.x_m(t_s) * X + up.x_m(t_s) * Y);
	};
	watch(recogniser, way, 2.6);
	CHECK(left_m < 1e-6);
}

TEST_CASE("a frame that comes twice, or late, is passed over") {
	for (const std::optional<Task> &task : { std::optional(HERE), std::optional<Task>() }) {
		GestureRecogniser once({ drag_at(task) }), twice({ drag_at(task) });
		for (int i = 0; i < 220; ++i) {
			HandFrame frame;
			frame.t_s = i / 90.0;
			frame.set(Joint::INDEX, (DRAG.x_m(frame.t_s) + 1e-4 * std::sin(777.0 * i)) * X);
			once.push(frame);
			twice.push(frame);
			twice.push(frame);
			HandFrame late = frame;
			late.t_s -= 0.005;
			late.set(Joint::INDEX, 0.3 * Y);
			twice.push(late);
			for (const MotionSource source : { MotionSource::SYNTHESISED, MotionSource::AVERAGE }) {
				REQUIRE(once.motion(source).value_m == twice.motion(source).value_m);
			}
			REQUIRE(once.gesture() == twice.gesture());
		}
	}
}
