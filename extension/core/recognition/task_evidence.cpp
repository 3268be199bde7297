#include "recognition/task_evidence.h"

#include "base/parameters.h"
#include "gesture/feature_track.h"
#include "recognition/path_densities.h"

#include <numbers>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

} // namespace

TaskEvidence::TaskEvidence(const Feature &feature, const Task &task) :
		feature_(&feature), amplitude_m_(task.amplitude_m) {
	if (feature.place != nullptr) {
		direction_ = feature.direction(task);
		start_ = feature.is_radius ? FeaturePlace(0.0, 0.0, 0.0, task.start_m.x())
								   : place_of(feature, task.start_m);
	}
}

void TaskEvidence::ignore_before(double t_s) {
	not_before_s_ = std::max(not_before_s_, t_s);
	now_.t_s = std::max(now_.t_s, t_s);
}

void TaskEvidence::push(const Measurement &measurement, const FeaturePlace &place_m, bool is_idle) {
	const double since_s = measurement.t_s - now_.t_s;
	if (!measurement.is_usable() || since_s < LEAST_FRAME_S) {
		return;
	}
	const auto weights = Eigen::Map<const FeaturePlace>(feature_->coordinate_weights.data());
	now_ = { .t_s = measurement.t_s,
		.place_m = weights.cwiseProduct(place_m),
		.displacement_m = weights.cwiseProduct(place_of(*feature_, measurement.displacement_m)),
		.is_entry = samples_.empty() || since_s > LONG_DROPOUT_S };
	if (since_s > LONG_DROPOUT_S) {
		window_.clear();
		samples_.clear();
		onset_ = knot_ = now_;
	}
	const double piece_m = (now_.place_m - knot_.place_m).norm();
	now_.path_m = knot_.path_m + piece_m;
	now_.sum = knot_.sum + 0.5 * piece_m * (now_.place_m + knot_.place_m);
	if (piece_m > SMALLEST_PIECE * amplitude_m_) {
		knot_ = now_;
	}
	window_.push(now_.t_s, now_.place_m, WINDOW_S);
	now_.velocity_m_s = window_.slope();
	if (samples_.empty() || now_.t_s - samples_.newest().t_s >= APART_S) {
		samples_.push(now_);
	}
	if (is_idle) {
		find_onset();
	}
}

/// After a rest that is longer than the samples, the onset is now. If they have no slow moment, it stays.
void TaskEvidence::find_onset() {
	double peak_m_s = 0.0;
	bool is_away = false;
	for (std::size_t i = samples_.size(); i > 0 && samples_[i - 1].t_s > onset_.t_s; --i) {
		const Sample &sample = samples_[i - 1];
		const FeaturePlace chord_m = now_.place_m - sample.place_m;
		is_away = is_away || chord_m.norm() > START_VALUE * amplitude_m_;
		const double speed_m_s = sample.velocity_m_s.norm();
		const bool has_turned = sample.velocity_m_s.dot(chord_m) < -PARALLEL * speed_m_s * chord_m.norm();
		if (is_away && !sample.is_entry && (speed_m_s < SPEED_SHARE * peak_m_s || has_turned)) {
			onset_ = sample;
			return;
		}
		peak_m_s = std::max(peak_m_s, speed_m_s);
	}
	if (!is_away && samples_.size() == SAMPLES && samples_[0].t_s > onset_.t_s) {
		onset_ = now_;
	}
}

bool TaskEvidence::has_onset() const {
	const bool is_forward = chord_m().dot(direction_) > START_VALUE * amplitude_m_;
	const bool is_near =
			!onset_.is_entry || (onset_.place_m - start_).dot(direction_) <= UNSEEN_PART * amplitude_m_;
	return feature_->place == nullptr ||
			(is_forward && is_near && onset_.t_s >= not_before_s_ && max_log_odds() > 0.0);
}

bool TaskEvidence::is_along_axis() const {
	return feature_->place == nullptr || chord_m().dot(direction_) > PARALLEL * chord_m().norm();
}

/// Vector, m, from the nearest position where the gesture may begin to the onset. A gesture begins at the
/// task's start. If the hand came into view while it moved, the gesture may have begun in the first part of
/// the path. The tracker may be displaced at the onset or now: the shorter one of both vectors counts.
FeaturePlace TaskEvidence::start_error() const {
	const auto off = [this](const FeaturePlace &displacement_m) -> FeaturePlace {
		const FeaturePlace from_m = onset_.place_m + displacement_m - start_;
		const double along_m = from_m.dot(direction_);
		const double unseen_m = onset_.is_entry ? std::max(along_m, 0.0) : 0.0;
		// A radius has no position.
		return (feature_->is_radius ? FeaturePlace(along_m * direction_) : from_m) - unseen_m * direction_;
	};
	const FeaturePlace now = off(now_.displacement_m), then = off(onset_.displacement_m);
	return now.squaredNorm() < then.squaredNorm() ? now : then;
}

/// Log odds of a movement from this onset straight to the task's end. The gesture's onsets are normal about
/// the task's start, or about a path of length UNSEEN_PART; its directions are normal about the aim. Those of
/// other movements are uniform in a ball and on the sphere.
double TaskEvidence::max_log_odds() const {
	const double across = 2.0 * std::numbers::pi * START * START;
	const double along = onset_.is_entry ? UNSEEN_PART : std::sqrt(across);
	const double ball = 4.0 / 3.0 * std::numbers::pi * OTHER_STARTS * OTHER_STARTS * OTHER_STARTS;
	const double z = start_error().norm() / (START * amplitude_m_);
	return LOG_PRIOR_TASK + std::log(ball / (across * along)) - 0.5 * z * z -
			(onset_.is_entry ? REST_UNSEEN : 0.0) + std::log(2.0 / (TASK_DIRECTION * TASK_DIRECTION)) +
			log_bow_ratio(0.0, BOW);
}

double TaskEvidence::log_odds() const {
	if (feature_->place == nullptr) {
		return 0.0;
	}
	// Hands aim at the end also from beside the start.
	const FeaturePlace aim = (amplitude_m_ * direction_ - start_error()).normalized();
	const double z = (chord_m().normalized() - aim).norm() / TASK_DIRECTION;
	return max_log_odds() - 0.5 * z * z + log_bow_ratio(bow(), BOW) - log_bow_ratio(0.0, BOW);
}

/// Mean distance of the path from its chord, in lengths of the chord.
double TaskEvidence::bow() const {
	const double length_m = chord_m().norm(), path_m = now_.path_m - onset_.path_m;
	if (path_m < 0.5 * length_m || !(path_m > 0.0)) {
		return 0.0; // of few pieces
	}
	const FeaturePlace bent_m = (now_.sum - onset_.sum) / path_m - 0.5 * (now_.place_m + onset_.place_m);
	const FeaturePlace along = chord_m().normalized();
	return (bent_m - bent_m.dot(along) * along).norm() / length_m;
}

double TaskEvidence::start_distance_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	return feature_->is_radius ? std::abs(off_m.dot(direction_)) : off_m.norm();
}

double TaskEvidence::path_distance_m(const FeaturePlace &place_m) const {
	const FeaturePlace off_m = place_m - start_;
	const double along_m = std::clamp(off_m.dot(direction_), 0.0, amplitude_m_);
	return feature_->is_radius ? 0.0 : (off_m - along_m * direction_).norm();
}

} // namespace steadyhand
