#pragma once

#include "strokes/stroke_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

namespace steadyhand {

struct Task;

/// Evidence of the hand's strokes for a gesture with a task: whether it has begun, and its log odds. The
/// gesture may consist of several strokes, with rests of any length between them.
class TaskStrokes {
public:
	/// A feature without a position has no straight strokes. Then has_onset() is always true and the log odds
	/// are 0.
	TaskStrokes(const Feature &feature, const Task &task);

	/// Strokes with an onset before t_s are not used.
	void ignore_before(double t_s) { not_before_s_ = std::max(not_before_s_, t_s); }
	/// Updates has_onset() and is_along_axis().
	void update(const StrokeFinder &strokes);
	/// One of the strokes moves along the task's axis from near its start.
	[[nodiscard]] bool has_onset() const { return has_onset_; }
	/// has_onset(), by a stroke whose direction is near the axis (parameters::sessions::PARALLEL).
	[[nodiscard]] bool is_along_axis() const { return is_along_axis_; }

	/// Distance, m, of a hand from the start of the gesture; for features with a position.
	[[nodiscard]] double start_distance_m(const FeaturePlace &place_m) const;

	/// Distance, m, of a hand from the straight path of the task; 0 for a radius, which may grow anywhere.
	[[nodiscard]] double path_distance_m(const FeaturePlace &place_m) const;

	/// A gesture begins. It consists of the strokes that are added from now on.
	void begin();
	/// Adds the newest stroke, or updates it.
	void add(const StrokeFinder &strokes);
	/// log of the posterior odds of the gesture against none, nats: the greatest of each stroke and of all
	/// joined.
	double judge(const StrokeFinder &strokes);
	/// The greatest since begin() of any stroke that is long enough to have a direction, and the present one
	/// of all joined.
	[[nodiscard]] double best_log_odds() const;

private:
	/// Log odds without a stroke.
	static constexpr double NO_STROKE = -10.0;

	/// Results without a stroke.
	struct WithoutStroke {
		bool has_onset = false;
		double log_odds = NO_STROKE;
	};
	WithoutStroke without_stroke_;
	double amplitude_m_;
	double not_before_s_ = -INFINITY;
	FeaturePlace start_ = FeaturePlace::Zero();
	FeaturePlace direction_ = FeaturePlace::Zero(); ///< unit vector in which the motion element grows
	bool has_onset_ = false, is_along_axis_ = false;
	double best_of_one_ = 0.0;      ///< greatest log odds of a single stroke
	double of_all_ = 0.0;           ///< log odds of all strokes joined
	std::optional<Stroke> earlier_; ///< strokes before the last one, joined
	std::optional<Stroke> last_;
	bool has_ended_ = false; ///< the last stroke

	[[nodiscard]] bool counts(const Stroke &stroke) const { return stroke.onset_s >= not_before_s_; }
	[[nodiscard]] auto counted(const StrokeFinder &strokes) const {
		return strokes.strokes() |
				std::views::filter([this](const Stroke &stroke) { return counts(stroke); });
	}
	[[nodiscard]] bool may_begin(const Stroke &stroke) const;
	[[nodiscard]] double log_odds(const Stroke &stroke) const;
};

} // namespace steadyhand
