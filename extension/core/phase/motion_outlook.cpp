#include "phase/motion_outlook.h"

#include "signal/lanes.h"
#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// A motion that had not come this far when it was last seen could as well not have begun.
constexpr double VISIBLE_PHASE = 0.06;
/// One that may be the tracker's wandering goes on unseen for so long.
constexpr double DOUBTED_S = 0.25;
constexpr double WAITING_LENGTH = 0.05; ///< phase that a motion still makes that waits to be seen
constexpr double LEAST_WEIGHT = 1e-5;   ///< weight beside the best one's 1
/// Probability that a free hand near the end, or beyond, is at the end, and a tracker that has erred shows it
/// there: such errors are greater than those of UNSOUND.
constexpr double MISTAKEN = 0.6;
constexpr double MISTAKEN_FROM = 0.7, MISTAKEN_TO = 0.9; ///< where that begins to count, and does in full

/// Amplitudes: a free hand that is not seen goes on by no more than this.
constexpr double COASTS = 0.5;

constexpr std::size_t FREE = index_of(Regime::FREE);

STEADYHAND_INLINE LaneVector hand_rates_per_s() {
	return each([](std::size_t i) STEADYHAND_INLINE_LAMBDA {
		return regime_numbers(static_cast<Regime>(i)).hand.rate_per_s;
	});
}

/// Where a hypothesis has the hand.
double hand_of(const HypothesisBank &bank, std::size_t place, const ElementCurve &curve, double t_s) {
	const double deviation = bank.hand_deviation(place);
	if (!bank.on_its_way(place)) {
		return deviation;
	}
	const HypothesisGroup::Course course = bank.course(place);
	const double phase = course.phase(t_s);
	const double elements = curve.at(all(phase)).value[0];
	return deviation + course.gain * (elements + course.shape * (minimum_jerk(phase).value - elements));
}

double share_mistaken(double free_hand, double erred) {
	return MISTAKEN * erred * minimum_jerk((free_hand - MISTAKEN_FROM) / (MISTAKEN_TO - MISTAKEN_FROM)).value;
}

} // namespace

Lanes MotionOutlook::fading(double dt_s) {
	Lanes all;
	store(all, exponential(-hand_rates_per_s() * dt_s));
	all[FREE] = std::exp(-FREE_SLOWING_PER_S * dt_s);
	return all;
}

/// dt_s: since the hypotheses' time
STEADYHAND_WIDE MotionOutlook::Mean MotionOutlook::mean(
		const ElementCurve &curve, double dt_s, const Lanes &fading) const {
	const LaneVector rates = hand_rates_per_s(), fades = load(fading);
	const LaneVector c = load(hand_.v) + rates * load(hand_.x), left = load(hand_.x) + c * dt_s;
	LaneVector value = left * fades, velocity = (c - rates * left) * fades;
	LaneVector acceleration = rates * (rates * left - 2.0 * c) * fades;
	const double slowing_per_s = std::max(FREE_SLOWING_PER_S, std::abs(hand_.v[FREE]) / COASTS);
	const double free_fading =
			slowing_per_s > FREE_SLOWING_PER_S ? std::exp(-slowing_per_s * dt_s) : fading[FREE];
	const double free_velocity = hand_.v[FREE] * free_fading;
	value[FREE] = hand_.x[FREE] + (hand_.v[FREE] - free_velocity) / slowing_per_s;
	velocity[FREE] = free_velocity;
	acceleration[FREE] = -slowing_per_s * free_velocity;
	LaneVector expected_phase{}, phase_rate{};
	for (std::size_t g = 0; g * LANES < count_; ++g) {
		const Courses &courses = courses_[g];
		LaneVector rate = load(courses.rate_per_s), rate_change{};
		LaneVector phase = (filtered_s_ + dt_s - load(courses.onset_s)) * rate;
		const LaneVector waits_from = load(courses.waits_from), over = phase - waits_from;
		if (any(over > 0.0)) {
			const LaneVector slowed = exponential(over > 0.0 ? over / -WAITING_LENGTH : LaneVector{});
			phase = over > 0.0 ? waits_from + WAITING_LENGTH * (1.0 - slowed) : phase;
			rate_change = over > 0.0 ? rate * rate * slowed / -WAITING_LENGTH : LaneVector{};
			rate *= slowed;
		}
		const LaneCurvePoint point = curve.at(phase);
		const LaneVector s = within_one(phase);
		const LaneMinimumJerk jerk(s);
		const LaneVector elements = load(courses.elements), smooth = load(courses.smooth);
		const LaneVector weight = load(courses.weight);
		value += elements * point.value + smooth * jerk.value;
		const LaneVector slope = elements * point.slope + smooth * jerk.first;
		velocity += rate * slope;
		acceleration +=
				rate * rate * (elements * point.curvature + smooth * jerk.second) + rate_change * slope;
		expected_phase += weight * s;
		phase_rate += phase > 0.0 ? (phase < 1.0 ? weight * rate : LaneVector{}) : LaneVector{};
	}
	return { { sum(value), sum(velocity), sum(acceleration), sum(expected_phase) + standing_phase_, moving_,
					 free_phase_ },
		sum(phase_rate) };
}

PhaseEstimate MotionOutlook::beside_piece(const ElementCurve &curve, double t_s) const {
	const double dt_s = std::max(t_s - filtered_s_, 0.0);
	return mean(curve, dt_s, fading(dt_s)).estimate;
}

void MotionOutlook::look(const HypothesisBank &bank, const ElementCurve &curve, double filtered_s,
		double ahead_s, double seen_s, double erred, bool is_halted, double wander) {
	filtered_s_ = filtered_s;
	if (ahead_s != ahead_s_) {
		ahead_s_ = ahead_s;
		fading_from_ = fading(ahead_s);
		fading_to_ = fading(ahead_s + PIECE_S);
	}
	count_ = 0;
	hand_ = {};
	moving_ = free_phase_ = standing_phase_ = 0.0;
	double total = 0.0;
	for (std::size_t i = 0; i < bank.size(); ++i) {
		total += bank.weight(i) > LEAST_WEIGHT ? bank.weight(i) : 0.0;
	}
	for (std::size_t i = 0; i < bank.size(); ++i) {
		if (bank.weight(i) <= LEAST_WEIGHT) {
			continue;
		}
		const double weight = bank.weight(i) / total;
		const Regime regime = is_halted ? Regime::FREE : bank.regime(i);
		double x = bank.hand_deviation(i), v = bank.hand_deviation_rate(i);
		if (bank.regime(i) == Regime::FREE && erred > 0.0) {
			const double hand = hand_of(bank, i, curve, filtered_s), mistaken = share_mistaken(hand, erred);
			x += mistaken * (1.0 - hand);
			v *= 1.0 - mistaken;
		}
		if (bank.regime(i) == Regime::FREE) {
			const double hand = hand_of(bank, i, curve, seen_s) + x - bank.hand_deviation(i);
			const double counted =
					bank.on_its_way(i) ? std::clamp(bank.course(i).phase(seen_s), 0.0, 1.0) : 0.0;
			free_phase_ += weight * (minimum_jerk_share(hand) - counted);
		}
		hand_.x[index_of(regime)] += weight * x;
		hand_.v[index_of(regime)] += weight * v;
		if (bank.on_its_way(i)) {
			const HypothesisGroup::Course course = bank.course(i);
			const double seen_phase = course.phase(seen_s);
			const double way = weight * course.gain;
			Courses &courses = courses_[count_ / LANES];
			const std::size_t lane = count_++ % LANES;
			courses = lane == 0 ? Courses{} : courses;
			courses.onset_s[lane] = course.onset_s;
			courses.rate_per_s[lane] = course.rate_per_s;
			courses.elements[lane] = way * (1.0 - course.shape);
			courses.smooth[lane] = way * course.shape;
			courses.weight[lane] = weight;
			courses.waits_from[lane] = INFINITY;
			if (seen_phase < VISIBLE_PHASE || regime == Regime::FREE) {
				courses.waits_from[lane] = std::max(seen_phase, 0.0);
			} else if (course.gain * minimum_jerk(seen_phase).value < wander) {
				courses.waits_from[lane] = course.phase(seen_s + DOUBTED_S);
			}
			moving_ += weight;
			if (bank.is_standing(i)) { // a gesture of that length is over, the one that is asked for half-way
				standing_phase_ += weight * (minimum_jerk_share(course.gain) - 1.0);
			}
		}
	}
	lay_piece(curve, ahead_s_, fading_from_, fading_to_);
}

/// dt_s: from when on, since the hypotheses' time; fading: there, and at the end.
void MotionOutlook::lay_piece(
		const ElementCurve &curve, double dt_s, const Lanes &fading_from, const Lanes &fading_to) {
	const auto [from, rate_per_s] = mean(curve, dt_s, fading_from);
	const PhaseEstimate to = mean(curve, dt_s + PIECE_S, fading_to).estimate;
	piece_ = QuinticPiece::between({ from.value, from.velocity, from.acceleration },
			{ to.value, to.velocity, to.acceleration }, PIECE_S);
	piece_from_s_ = filtered_s_ + dt_s;
	const double bend = (to.phase - from.phase) / PIECE_S - rate_per_s;
	phase_ = { from.phase, rate_per_s, bend / PIECE_S };
}

void MotionOutlook::go_on(const ElementCurve &curve, double t_s) {
	if (t_s > piece_from_s_ + PIECE_S) {
		const double dt_s = t_s - filtered_s_;
		lay_piece(curve, dt_s, fading(dt_s), fading(dt_s + PIECE_S));
	}
}

} // namespace steadyhand
