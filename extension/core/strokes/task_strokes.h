#pragma once

#include "strokes/stroke_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

namespace steadyhand {

struct Task;

/// What strokes of the hand say of a gesture whose task is known: whether it has set out, and whether it
/// makes the gesture. The gesture may be made of several, however long the hand rested between them.
class TaskStrokes {
public:
	/// A feature that has no place, because its way is no stroke, is taken at its word: the hand always has
	/// set out, and the odds are even.
	TaskStrokes(const Feature &feature, const Task &task);

	/// Strokes that began before t_s are not looked at.
	void ignore_before(double t_s) { not_before_s_ = std::max(not_before_s_, t_s); }
	/// Whether the hand goes, or went, along the task's way, from no further off than its start may be.
	void look(const StrokeFinder &strokes);
	[[nodiscard]] bool has_set_out() const { return has_set_out_; }
	/// And rather along than across it, within 50 degrees.
	[[nodiscard]] bool heads_along() const { return heads_along_; }

	/// How far a hand is from where the gesture begins, m; of a feature that has places.
	[[nodiscard]] double off_start_m(const FeaturePlace &place_m) const;

	/// How far it is from the way of the gesture, m; a radius may grow anywhere.
	[[nodiscard]] double off_way_m(const FeaturePlace &place_m) const;

	/// A gesture begins: it is made of what is added from now on.
	void begin();
	/// The newest, as of now.
	void add(const StrokeFinder &strokes);
	/// log of the posterior odds of the gesture against none, nats: the best of any, and of all as one.
	double judge(const StrokeFinder &strokes);
	/// The best since it began, of strokes that are long enough to say where they go, or of all as one now.
	[[nodiscard]] double best_log_odds() const;

private:
	/// log odds while the hand has not been still yet, from where a stroke could have begun.
	static constexpr double NO_STROKE = -10.0;

	/// What is said without a stroke.
	struct Unseen {
		bool has_set_out = false;
		double log_odds = NO_STROKE;
	};
	Unseen unseen_;
	double amplitude_m_;
	double not_before_s_ = -INFINITY;
	FeaturePlace start_ = FeaturePlace::Zero();
	FeaturePlace way_ = FeaturePlace::Zero(); ///< unit vector of the motion element's growth
	bool has_set_out_ = false, heads_along_ = false;
	double best_of_one_ = 0.0;
	double of_all_ = 0.0;
	std::optional<Stroke> before_last_; ///< as one
	std::optional<Stroke> last_;
	bool has_ended_ = false; ///< the last one

	[[nodiscard]] bool counts(const Stroke &stroke) const { return stroke.onset_s >= not_before_s_; }
	[[nodiscard]] auto counted(const StrokeFinder &strokes) const {
		return strokes.strokes() |
				std::views::filter([this](const Stroke &stroke) { return counts(stroke); });
	}
	[[nodiscard]] bool may_begin(const Stroke &stroke) const;
	[[nodiscard]] double log_odds(const Stroke &stroke) const;
};

} // namespace steadyhand
