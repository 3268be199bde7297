// Evidence of the movements of a hand with a task.

#include "overlapping_drags.h"
#include "recognition/task_evidence.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double PERIOD_S = 0.01;
constexpr double TASK_M = 0.2; ///< of Task{}

/// A hand whose gesture is active from its onset on.
class JudgedHand {
public:
	template <typename Place> void move(double from_s, double to_s, const Place &place) {
		for (int i = 0; from_s + i * PERIOD_S < to_s; ++i) {
			const double t_s = from_s + i * PERIOD_S;
			const FeaturePlace noise{ trembling_(random_), trembling_(random_), 0.0, 0.0 };
			evidence_.push({ .t_s = t_s }, place(t_s) + noise, !is_active_);
			has_onset_ = has_onset_ || evidence_.has_onset();
			is_active_ = has_onset_;
		}
	}
	void end() { is_active_ = has_onset_ = false; }
	[[nodiscard]] bool has_onset() const { return has_onset_; } ///< at any time
	[[nodiscard]] double log_odds() const { return evidence_.log_odds(); }

private:
	TaskEvidence evidence_{ *find_feature("index_along_axis"), Task{} };
	std::mt19937_64 random_{ 3 };
	std::normal_distribution<double> trembling_{ 0.0, 6e-5 };
	bool has_onset_ = false, is_active_ = false;
};

/// Position along the task's axis and across it.
auto place_of(const std::vector<test::Drag> &along, const std::vector<test::Drag> &aside = {}) {
	return [=](double t_s) { return FeaturePlace(test::x_m(along, t_s), test::x_m(aside, t_s), 0.0, 0.0); };
}

} // namespace

TEST_CASE("two short movements make a gesture together, after any rest") {
	constexpr double SHORT_M = 0.45 * TASK_M;
	for (const double rests_s : { 0.5, 3.0 }) {
		CAPTURE(rests_s);
		const test::Drag first{ .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = SHORT_M };
		const test::Drag second{ .onset_s = 1.5 + rests_s, .duration_s = 0.5, .amplitude_m = SHORT_M };
		JudgedHand hand;
		hand.move(0.0, second.onset_s + 1.0, place_of({ first, second }));
		CHECK(hand.log_odds() > 0.0);
	}
}

TEST_CASE("a movement after a rest is judged from its own onset") {
	const test::Drag drag{ .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = TASK_M };
	const test::Drag aside{ .onset_s = 5.0, .duration_s = 0.5, .amplitude_m = TASK_M };
	JudgedHand hand;
	hand.move(0.0, 4.9, place_of({ drag }, { aside }));
	REQUIRE(hand.log_odds() > 0.0);
	hand.end();
	hand.move(4.9, 6.5, place_of({ drag }, { aside }));
	CHECK(hand.log_odds() < 0.0);
	CHECK_FALSE(hand.has_onset());
}

TEST_CASE("has_onset() needs motion along the axis, not noise, back or aside") {
	const auto has_onset = [](double along_m, double aside_m) {
		JudgedHand hand;
		hand.move(0.0, 2.0,
				place_of({ test::Drag{ .onset_s = 1.0, .duration_s = 0.4, .amplitude_m = along_m } },
						{ test::Drag{ .onset_s = 1.0, .duration_s = 0.4, .amplitude_m = aside_m } }));
		return hand.has_onset();
	};
	CHECK(has_onset(0.1 * TASK_M, 0.0));
	CHECK(has_onset(0.1 * TASK_M, TASK_M));
	CHECK_FALSE(has_onset(0.0, 0.0));
	CHECK_FALSE(has_onset(-0.5 * TASK_M, 0.0));
	CHECK_FALSE(has_onset(0.0, 0.5 * TASK_M));
}

TEST_CASE("a hand that turns at the start in a dropout has an onset") {
	const auto place = [](double t_s) { return FeaturePlace(2.0 * std::abs(t_s - 1.0), 0.0, 0.0, 0.0); };
	JudgedHand hand;
	hand.move(0.7, 0.97, place);
	REQUIRE_FALSE(hand.has_onset());
	hand.move(1.03, 1.1, place);
	CHECK(hand.has_onset());
	CHECK(hand.log_odds() > 0.0);
}

TEST_CASE("a half circle from start to end has lower log odds than a line") {
	const auto arc = [](double height) {
		return [height](double t_s) -> FeaturePlace {
			const double angle = std::numbers::pi * test::x_m({ { 1.0, 0.6, 1.0 } }, t_s);
			return 0.5 * TASK_M * FeaturePlace(1.0 - std::cos(angle), height * std::sin(angle), 0.0, 0.0);
		};
	};
	JudgedHand straight, round;
	straight.move(0.0, 2.0, arc(0.0));
	round.move(0.0, 2.0, arc(1.0));
	CHECK(straight.log_odds() > 0.0);
	CHECK(round.log_odds() < straight.log_odds() - 5.0);
}
