// expect(): gestures and tasks that come and go while the hand moves.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double HALF_WAY_S = 1.1;
const Task HERE{ Eigen::Vector3d::Zero(), X, 0.2 }, THERE{ 0.4 * Y, X, 0.2 }, AHEAD{ 0.1 * X, X, 0.2 };
const std::vector<std::optional<Task>> CONTEXTS{ HERE, std::nullopt };

using Expected = std::vector<ExpectedGesture>;

ExpectedGesture drag_at(const std::optional<Task> &task) {
	return { models()[0], task };
}

struct Change {
	double t_s;
	Expected expected;
};

struct Run {
	std::vector<double> values_m;
	std::vector<std::string> said;
	std::vector<int> now; ///< what the last expect() returned
};

Run run(const Expected &first, const std::vector<Change> &changes, double length_s = 2.5,
		const std::vector<Drag> &strokes = { DRAG }) {
	GestureRecogniser recogniser(first);
	Run run;
	std::size_t changed = 0;
	const Way way = [&](double t_s) {
		run.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
		if (changed < changes.size() && t_s > changes[changed].t_s) {
			run.now = recogniser.expect(changes[changed++].expected);
		}
		return Eigen::Vector3d(x_m(strokes, t_s) * X);
	};
	run.said = watch(recogniser, way, length_s).said;
	return run;
}

} // namespace

TEST_CASE("another gesture that comes or goes changes no bit of the motion") {
	for (const std::optional<Task> &here : CONTEXTS) {
		const ExpectedGesture own = drag_at(here);
		const ExpectedGesture other = here ? drag_at(THERE) : ExpectedGesture{ models()[2], std::nullopt };
		const std::vector<double> alone = run({ own }, {}).values_m;
		for (const auto &[first, then, now] : {
					 std::tuple{ Expected{ own, other }, Expected{ own }, std::vector{ 0, -1 } },
					 std::tuple{ Expected{ own }, Expected{ own, other }, std::vector{ 0 } },
					 std::tuple{ Expected{ own, other }, Expected{ other, own }, std::vector{ 1, 0 } },
			 }) {
			const Run changed = run(first, { { HALF_WAY_S, then } });
			CHECK(changed.values_m == alone);
			CHECK(changed.now == now);
			CHECK(changed.said == times(1, "sideways"));
		}
	}
}

TEST_CASE("an active gesture that is expected no longer aborts") {
	const Run gone = run({ drag_at(HERE) }, { { HALF_WAY_S, { drag_at(THERE) } } });
	CHECK(gone.now == std::vector{ -1 });
	CHECK(gone.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	const Run none = run({ drag_at(HERE) }, { { HALF_WAY_S, {} } });
	CHECK(none.now == std::vector{ -1 });
	CHECK(none.values_m.back() == 0.0);
}

TEST_CASE("a task expected before the onset is followed as if expected always") {
	const Run later = run({ drag_at(HERE) }, { { 0.3, { drag_at(AHEAD) } } });
	const Run always = run({ drag_at(AHEAD) }, {});
	CHECK(later.values_m.back() == near(0.1).epsilon(0.05));
	CHECK(later.values_m.back() == near(always.values_m.back()).epsilon(0.01));
}

TEST_CASE("a movement that has ended makes no gesture expected after it") {
	const ExpectedGesture drag = drag_at(HERE), free_drag = drag_at(std::nullopt);
	const std::vector<std::string> once = times(1, "sideways");
	for (const double after_s : { 0.0, 0.5 }) {
		CAPTURE(after_s);
		const double changed_s = 0.6 + 1.0 + after_s; // the hand is at the end, and stays there
		CHECK_MESSAGE(run({ drag }, { { changed_s, { free_drag } } }).said == once, "its task is gone");
		CHECK_MESSAGE(run({ free_drag }, { { changed_s, { drag } } }).said == once, "its task has come");
		CHECK_MESSAGE(run({ drag }, { { changed_s, { drag_at(THERE) } } }).said == once, "it is elsewhere");
	}
	const Run off_and_on = run({ drag }, { { 1.7, {} }, { 2.0, { drag } } }, 6.0,
			{ DRAG, { 2.5, 0.6, -0.2 }, { 4.0, 1.0, 0.2 } });
	CHECK_MESSAGE(off_and_on.said == times(2, "sideways"), "the next movement counts again");
}

TEST_CASE("an active movement ends none of the gestures expected during it") {
	const Task near_by{ 0.01 * X, X, 0.2 }, beside{ 0.01 * Y, X, 0.2 },
			longer{ Eigen::Vector3d::Zero(), X, 0.25 };
	for (const std::optional<Task> &here : CONTEXTS) {
		const ExpectedGesture own = drag_at(here);
		for (const std::optional<Task> &other :
				std::vector<std::optional<Task>>{ here, near_by, beside, longer }) {
			for (const double changed_s : { 0.9, 1.3 }) { // from a fifth of the amplitude on
				CAPTURE(changed_s);
				CHECK(run({ own }, { { changed_s, { own, drag_at(other) } } }).said == times(1, "sideways"));
			}
		}
	}
}

TEST_CASE("a gesture expected during another one counts with the next movement") {
	const ExpectedGesture here = drag_at(HERE), ahead = drag_at(AHEAD);
	CHECK(run({ here }, { { HALF_WAY_S, { here, ahead } }, { 2.0, { ahead } } }, 6.0,
				  { DRAG, { 2.5, 0.6, -0.1 }, { 4.0, 1.0, 0.2 } })
					.said == times(2, "sideways"));
}
