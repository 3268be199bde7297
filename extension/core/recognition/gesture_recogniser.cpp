#include "recognition/gesture_recogniser.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steadyhand {
namespace {

/// The gesture shown changes for one that is likelier by this factor, in nats.
constexpr double SWITCH_MARGIN = 2.0;
/// What a finger does while several make a gesture it may do by itself, and then hardly moves against the
/// others: nats against that, for each amplitude by which the gesture of several has grown.
constexpr double PART = 12.0;
/// 1/s: from one gesture's motion to another's within a tenth of a second, to a first one's within half of
/// it.
constexpr double LEAD_RATE_PER_S = 50.0;
constexpr double SHOW_RATE_PER_S = 100.0;
/// At rest another task is shown from so much nearer on, of the distance from the one that is.
constexpr double NEARER = 0.8;

} // namespace

/// Of a hand that another was shown for meanwhile nothing was seen.
void GestureRecogniser::WatchedFeature::push(double t_s, const FeaturePlace &place_m) {
	switch (elsewhere.look(t_s, place_m)) {
		case ShownElsewhere::Sight::ON_ITS_WAY:
			break;
		case ShownElsewhere::Sight::LEAVES:
			before_elsewhere = strokes;
			break;
		case ShownElsewhere::Sight::RETURNS:
			strokes.forget_since(before_elsewhere);
			break;
	}
	strokes.push(t_s, place_m);
}

void GestureRecogniser::push(const HandFrame &frame) {
	if (!(std::abs(frame.t_s) <= FARTHEST_S) || frame.t_s < time_s_ || frame.repeats(last_frame_)) {
		return;
	}
	last_frame_ = frame;
	bool was_seen = false;
	if (!followers_.empty()) {
		was_seen = followers_[shown_]->off_start() < INFINITY;
		followers_[shown_]->attend(frame.t_s);
	}
	// What is due before this frame must not see the stroke that it makes.
	advance_followers(std::nextafter(frame.t_s, -INFINITY));
	for (WatchedFeature &watched : watched_) {
		watched.place = watched.feature->place != nullptr ? watched.feature->place(frame) : std::nullopt;
		if (watched.place && !watched.place->allFinite()) {
			watched.place.reset();
		}
		if (watched.place) {
			watched.push(frame.t_s, *watched.place);
		}
	}
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (followers_[i]->push(frame, watched(i).place, watched(i).strokes)) {
			filtered_[i].push(frame.t_s, followers_[i]->measured_m());
		}
	}
	time_s_ = frame.t_s;
	expect_absence();
	decide_claims();
	let_return();
	choose_leader();
	show_nearest(was_seen);
}

void GestureRecogniser::advance(double t_s) {
	if (!(t_s > time_s_) || t_s > FARTHEST_S) {
		return;
	}
	advance_followers(t_s);
	time_s_ = t_s;
	choose_leader();
}

void GestureRecogniser::expect_absence() {
	next_absence_s_ = INFINITY;
	for (const WatchedFeature &watched : watched_) {
		for (const double absence_s : GestureFollower::ABSENCES_S) {
			const double due_s = watched.strokes.news_s() + absence_s;
			const bool is_to_come = due_s >= time_s_ && due_s > last_absence_s_; // of a frame then, after it
			next_absence_s_ = is_to_come ? std::min(next_absence_s_, due_s) : next_absence_s_;
		}
	}
}

void GestureRecogniser::advance_followers(double t_s) {
	while (next_absence_s_ <= t_s) {
		time_s_ = last_absence_s_ = next_absence_s_;
		step_followers(time_s_);
		for (std::size_t i = 0; i < followers_.size(); ++i) {
			followers_[i]->miss(time_s_, watched(i).strokes);
		}
		decide_claims();
		choose_leader();
		expect_absence();
	}
	step_followers(t_s);
}

void GestureRecogniser::step_followers(double t_s) {
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		followers_[i]->advance(t_s, watched(i).strokes);
	}
}

double GestureRecogniser::log_odds(std::size_t follower) const {
	const std::uint8_t joints = watched(follower).feature->joints;
	double whole = 0.0; // how far a gesture has grown of which this one's motion would be a part
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		const GestureFollower &other = *followers_[i];
		const std::uint8_t others = watched(i).feature->joints;
		const bool is_part = others != joints && (others & joints) == joints;
		if (is_part && other.stage() == GestureFollower::Stage::MOVING) {
			whole = std::max(whole, std::min(other.measured_m() / other.task().amplitude_m, 1.0));
		}
	}
	return followers_[follower]->log_odds() - PART * whole;
}

double GestureRecogniser::posterior(std::size_t follower) const {
	// Odds against none, the largest taken out of the sum so that none overflows.
	const double odds = log_odds(follower), largest = std::max(odds, 0.0);
	double all = std::exp(-largest);
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (i == follower || followers_[i]->stage() == GestureFollower::Stage::MOVING) {
			all += std::exp(log_odds(i) - largest);
		}
	}
	return std::exp(odds - largest) / all;
}

double GestureRecogniser::confidence() const {
	return leader_ >= 0 ? posterior(shown()) : 0.0;
}

bool GestureRecogniser::is_likely(std::size_t follower) const {
	return min_confidence_ <= 0.0 || gestures_[follower].task || posterior(follower) >= min_confidence_;
}

template <class Predicate> int GestureRecogniser::likeliest(Predicate is_candidate) const {
	int best = -1;
	double best_odds = -INFINITY;
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (!is_candidate(i)) {
			continue;
		}
		if (const double odds = log_odds(i); odds > best_odds) {
			best = static_cast<int>(i);
			best_odds = odds;
		}
	}
	return best;
}

bool GestureRecogniser::ends_to_the_side(std::size_t one, std::size_t other) const {
	const std::optional<Task> &way = gestures_[one].task, &beside = gestures_[other].task;
	const auto ends_at_a_place = [this](std::size_t i) {
		const Feature &feature = *watched(i).feature;
		return feature.direction != nullptr && !feature.is_radius;
	};
	if (!way || !beside || !ends_at_a_place(one) || !ends_at_a_place(other)) {
		return false;
	}
	const auto end_m = [](const Task &task) { return task.start_m + task.amplitude_m * task.axis; };
	const Eigen::Vector3d apart_m = end_m(*beside) - end_m(*way);
	const double along_m = apart_m.dot(way->axis);
	return (apart_m - along_m * way->axis).norm() > std::abs(along_m);
}

void GestureRecogniser::decide_claims() {
	const int best = likeliest([&](std::size_t i) { return followers_[i]->claims(); });
	if (best < 0) {
		return;
	}
	const int task = likeliest([&](std::size_t i) { return followers_[i]->nears_end(); });
	const double odds = log_odds(static_cast<std::size_t>(best));
	// What is done at a task will say itself when it ends.
	const bool is_of_task = task >= 0 && log_odds(static_cast<std::size_t>(task)) > odds;
	if (is_of_task || !is_likely(static_cast<std::size_t>(best))) {
		for (const std::unique_ptr<GestureFollower> &follower : followers_) {
			if (follower->claims()) {
				follower->give_way(time_s_);
			}
		}
		return;
	}
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (static_cast<int>(i) == best) {
			followers_[i]->confirm(time_s_);
		} else {
			followers_[i]->give_way(time_s_);
		}
	}
	lead(best);
}

/// A hand on its way back after a gesture may look like another one's: fingers that close after a zoom, like
/// a drag of the index.
void GestureRecogniser::let_return() {
	if (leader_ < 0 || follower()->stage() != GestureFollower::Stage::ARRIVED) {
		return;
	}
	for (const std::unique_ptr<GestureFollower> &other : followers_) {
		if (other.get() != follower() &&
				follower()->log_odds_of_return() > std::max(other->log_odds(), 0.0)) {
			other->give_way(time_s_);
		}
	}
}

/// Tasks beside one another are begun by one stroke, which ends at one of them.
void GestureRecogniser::settle() {
	if (leader_ < 0 || follower()->stage() != GestureFollower::Stage::ARRIVED || follower()->end_told()) {
		return;
	}
	followers_[shown()]->tell_end();
	ended_begun_s_ = follower()->begun_s();
	for (std::size_t i = 0; i < followers_.size(); ++i) {
		if (ends_to_the_side(shown(), i)) {
			followers_[i]->give_way(time_s_);
		}
	}
}

void GestureRecogniser::choose_leader() {
	using Stage = GestureFollower::Stage;
	settle();
	const auto is_moving = [&](std::size_t i) { return followers_[i]->stage() == Stage::MOVING; };
	if (leader_ < 0 || follower()->stage() == Stage::RESTING) {
		lead(likeliest([&](std::size_t i) { return is_moving(i) && is_likely(i); }));
		return;
	}
	// What has arrived keeps its end until the hand does something else that is likelier than none: of tasks
	// on one way the one that the hand comes to first ends first, and the next one's end is told when the
	// hand gets there.
	const bool has_arrived = follower()->stage() == Stage::ARRIVED;
	const double odds = log_odds(shown()), since_s = follower()->stage_began_s();
	const int best = likeliest([&](std::size_t i) {
		const Stage stage = followers_[i]->stage();
		const bool is_news = stage != Stage::RESTING && followers_[i]->stage_began_s() > since_s &&
				!followers_[i]->end_told();
		const double doubt = ends_to_the_side(shown(), i) ? 0.0 : SWITCH_MARGIN;
		const bool wins = has_arrived ? is_news && (stage == Stage::ARRIVED || log_odds(i) > 0.0)
				: is_moving(i)        ? log_odds(i) > odds + SWITCH_MARGIN
									  : is_news && log_odds(i) > odds - doubt;
		return wins && is_likely(i);
	});
	if (best >= 0) {
		lead(best);
	}
}

void GestureRecogniser::lead(int follower) {
	if (follower == leader_) {
		return;
	}
	const Motion before = motion(MotionSource::SYNTHESISED);
	const double rate_per_s = leader_ < 0 ? SHOW_RATE_PER_S : LEAD_RATE_PER_S;
	leader_ = follower;
	if (leader_ >= 0) {
		shown_ = static_cast<std::size_t>(leader_);
	} else if (!gestures_[shown_].task) {
		shown_ = 0;
	}
	blend_.start(time_s_, before, synthesised(time_s_), rate_per_s);
}

/// So that a gesture begins where the motion already is. was_seen: the hand, by the one shown, before the
/// newest frame.
void GestureRecogniser::show_nearest(bool was_seen) {
	if (leader_ >= 0 || followers_.empty()) {
		return;
	}
	const auto nearest = std::ranges::min_element(
			followers_, {}, [](const std::unique_ptr<GestureFollower> &one) { return one->off_start(); });
	if (!((*nearest)->off_start() < NEARER * followers_[shown_]->off_start())) {
		return;
	}
	if ((*nearest)->is_elsewhere()) {
		(*nearest)->attend(time_s_); // and is shown from the next frame on
		return;
	}
	const Motion before = motion(MotionSource::SYNTHESISED);
	shown_ = static_cast<std::size_t>(nearest - followers_.begin());
	blend_ = {};
	if (was_seen) {
		blend_.start(time_s_, before, synthesised(time_s_), LEAD_RATE_PER_S);
	}
}

/// A hand at a task is shown at rest too.
Motion GestureRecogniser::synthesised(double t_s) const {
	return leader_ >= 0 || gestures_[shown_].task ? followers_[shown_]->motion(t_s) : Motion{};
}

Motion GestureRecogniser::motion(MotionSource source, double t_s) const {
	if (followers_.empty()) {
		return {};
	}
	const GestureFollower &follower = *followers_[shown()];
	if (source == MotionSource::SYNTHESISED) {
		return blend_.completed(synthesised(t_s), t_s);
	}
	const double value_m = filtered_[shown()].value_m(source);
	return { value_m, 0.0, 0.0, std::clamp(value_m / follower.task().amplitude_m, 0.0, 1.0) };
}

} // namespace steadyhand
