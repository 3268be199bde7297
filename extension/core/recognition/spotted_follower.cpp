#include "recognition/spotted_follower.h"

#include <algorithm>

namespace steadyhand {
namespace {

using News = GestureSpotter::News;

constexpr double STARTING_RATE_PER_S = 100.0;
constexpr double LEAST_DOUBT = 1e-12; ///< keeps log odds finite

FeaturePlace vector_of(const Eigen::Vector3d &tip, double radius) {
	return { tip.x(), tip.y(), tip.z(), radius };
}

double log_odds_of(double posterior) {
	return std::log(posterior / std::max(1.0 - posterior, LEAST_DOUBT));
}

} // namespace

SpottedFollower::SpottedFollower(
		const GestureModel &model, const Synthesis &synthesis, GestureSpotter &r_spotter) :
		GestureFollower(model, model.typical_task, synthesis, false),
		spotter_(&r_spotter), way_(feature().direction(task())) {}

bool SpottedFollower::can_follow(const GestureModel &model, const ClassifierModel &hmms) {
	return std::ranges::any_of(hmms.gestures, [&](const DirectedHmm &one) {
		return one.gesture == model.gesture &&
				model.feature == (one.is_radius ? "tips_circumradius" : "index_along_axis");
	});
}

std::optional<double> SpottedFollower::see(
		const HandFrame &frame, bool has_place, const StrokeFinder &strokes) {
	claims_ = false;
	const bool has_begun = spotter_->news() == News::BEGUN;
	if (has_begun && is_under_way()) {
		begin_at_onset(frame.t_s, strokes);
	} else if (stage() == Stage::MOVING) {
		look_for_end(frame.t_s);
	} else if (stage() == Stage::ARRIVED) {
		const bool is_back = along(last_place()) < BACK * task().amplitude_m;
		if (has_begun || is_back || frame.t_s - stage_began_s() > HOLD_S) {
			rest(frame.t_s);
		}
	}
	if (!has_place) {
		return std::nullopt;
	}
	if (stage() == Stage::RESTING) {
		start_ = last_place();
	}
	return along(last_place());
}

void SpottedFollower::aim() {
	const GestureCandidate &found = spotter_->candidate();
	if (!feature().is_radius) {
		way_ = vector_of(found.axis, 0.0);
	}
	set_log_odds(log_odds_of(found.posterior));
}

void SpottedFollower::begin_at_onset(double t_s, const StrokeFinder &strokes) {
	const Motion before = motion(t_s);
	const GestureCandidate &found = spotter_->candidate();
	start_ = feature().is_radius ? vector_of(Eigen::Vector3d::Zero(), found.start_radius_m)
								 : vector_of(found.start_m, 0.0);
	start_ -= strokes.displacement_m();
	aim();
	forget_frames();
	begin(found.onset_s, 0.0);
	double symbol_s = found.onset_s + SymbolClock::PERIOD_S;
	strokes.frames_since(found.onset_s, [&](double frame_s, const FeaturePlace &place) {
		while (symbol_s < std::min(frame_s, t_s)) {
			decode_recalled(symbol_s);
			symbol_s += SymbolClock::PERIOD_S;
		}
		if (frame_s < t_s) {
			recall(frame_s, along(place));
		}
	});
	blend_from(before, t_s, STARTING_RATE_PER_S);
}

void SpottedFollower::look_for_end(double t_s) {
	if (is_under_way()) {
		aim();
	} else if (spotter_->news() == News::ENDED) {
		aim();
		claims_ = true;
	} else {
		rest(t_s);
	}
}

void SpottedFollower::confirm(double t_s) {
	claims_ = false;
	arrive(t_s);
}

void SpottedFollower::give_way(double t_s) {
	claims_ = false;
	if (is_under_way()) {
		spotter_->drop();
	}
	if (stage() != Stage::RESTING) {
		rest(t_s);
	}
}

void SpottedFollower::miss(double t_s, const StrokeFinder &strokes) {
	if (t_s >= strokes.news_s() + ABSENCES_S.back()) {
		give_way(t_s);
	}
}

} // namespace steadyhand
