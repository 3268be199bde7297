// expect() while the hand moves: gestures and tasks are added and removed.

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
	EventNames names;
	std::vector<int> now; ///< result of the last expect()
};

Run run(const Expected &first, const std::vector<Change> &changes, double length_s = 2.5,
		const std::vector<Drag> &strokes = { DRAG }) {
	GestureRecogniser recogniser(first);
	Run run;
	std::size_t changed = 0;
	const TestPath path = [&](double t_s) {
		run.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
		if (changed < changes.size() && t_s > changes[changed].t_s) {
			run.now = recogniser.expect(changes[changed++].expected);
		}
		return Eigen::Vector3d(x_m(strokes, t_s) * X);
	};
	run.names = watch(recogniser, path, length_s).names;
	return run;
}

} // namespace

TEST_CASE("adding or removing another gesture changes no bit of the motion") {
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
			CHECK(changed.names == ENDS);
		}
	}
}

TEST_CASE("an active gesture that expect() removes aborts") {
	const Run gone = run({ drag_at(HERE) }, { { HALF_WAY_S, { drag_at(THERE) } } });
	CHECK(gone.now == std::vector{ -1 });
	CHECK(gone.names == ABORTS);
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

TEST_CASE("gestures expected after or during a movement do not end by it") {
	const ExpectedGesture drag = drag_at(HERE), free_drag = drag_at(std::nullopt);
	for (const double changed_s : { 1.6, 2.1 }) { // the hand rests at the end
		CAPTURE(changed_s);
		CHECK_MESSAGE(run({ drag }, { { changed_s, { free_drag } } }).names == ENDS, "task removed");
		CHECK_MESSAGE(run({ free_drag }, { { changed_s, { drag } } }).names == ENDS, "task added");
		CHECK_MESSAGE(run({ drag }, { { changed_s, { drag_at(THERE) } } }).names == ENDS, "another task");
	}
	const Task near_by{ 0.01 * X, X, 0.2 }, beside{ 0.01 * Y, X, 0.2 }, longer{ 0.0 * X, X, 0.25 };
	for (const std::optional<Task> &here : CONTEXTS) {
		const ExpectedGesture own = drag_at(here);
		for (const std::optional<Task> &other : { here, { near_by }, { beside }, { longer } }) {
			for (const double changed_s : { 0.9, 1.3 }) { // beyond a fifth of the amplitude
				CAPTURE(changed_s);
				CHECK(run({ own }, { { changed_s, { own, drag_at(other) } } }).names == ENDS);
			}
		}
	}
}

TEST_CASE("a gesture expected during or after another counts with the next movement") {
	const ExpectedGesture here = drag_at(HERE), ahead = drag_at(AHEAD);
	CHECK(run({ here }, { { HALF_WAY_S, { here, ahead } }, { 2.0, { ahead } } }, 6.0,
				  { DRAG, { 2.5, 0.6, -0.1 }, { 4.0, 1.0, 0.2 } })
					.names == times(2, "horizontal_drag"));
	CHECK(run({ here }, { { 1.7, {} }, { 2.0, { here } } }, 6.0,
				  { DRAG, { 2.5, 0.6, -0.2 }, { 4.0, 1.0, 0.2 } })
					.names == times(2, "horizontal_drag"));
}
