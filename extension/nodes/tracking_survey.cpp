#include "tracking_survey.h"

#include "conversions.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

namespace godot {

namespace {

Dictionary place_dictionary(const steadyhand::TrackingSurvey::Place &p_place) {
	Dictionary place;
	place["position"] = to_godot(p_place.position_m);
	place["seconds"] = p_place.seconds;
	place["lost_share"] = p_place.lost_share;
	place["noise"] = p_place.noise_m;
	return place;
}

} // namespace

Error TrackingSurvey::push(double p_time_s, const Vector3 &p_position) {
	if (!std::isfinite(p_time_s) || !p_position.is_finite() ||
			p_time_s < survey_.newest_s().value_or(p_time_s)) {
		return ERR_INVALID_PARAMETER;
	}
	survey_.push(p_time_s, to_core(p_position));
	return OK;
}

Dictionary TrackingSurvey::propose() const {
	const steadyhand::Result<steadyhand::TrackingSurvey::Proposal> made = survey_.propose();
	Dictionary proposal;
	proposal["error"] = made ? String() : to_godot(made.error());
	if (made) {
		proposal["stable"] = place_dictionary(made.value().stable);
		proposal["unstable"] = place_dictionary(made.value().unstable);
		proposal["contrast"] = made.value().contrast;
		proposal["distinct"] = made.value().distinct();
	}
	return proposal;
}

void TrackingSurvey::_bind_methods() {
	ClassDB::bind_method(D_METHOD("push", "time_s", "position"), &TrackingSurvey::push);
	ClassDB::bind_method(D_METHOD("get_duration"), &TrackingSurvey::get_duration);
	ClassDB::bind_method(D_METHOD("propose"), &TrackingSurvey::propose);
}

} // namespace godot
