#pragma once

#include "base/result.h"
#include "gesture/feature.h"
#include "gesture/observation.h"
#include "gesture/reference_curve.h"
#include "gesture/trainer.h"

#include <optional>
#include <span>
#include <vector>

namespace steadyhand {

/// What is left of a recording once its reference has been looked at.
struct Movement {
	const TrainingRecording *recording = nullptr;
	MovementSpan span;

	[[nodiscard]] double duration_s() const { return span.end_s - span.onset_s; }
};

/// Those in which the feature moves.
struct RecordedMovements {
	std::vector<Movement> movements;
	std::vector<Eigen::VectorXd> curves; ///< of each, normalised
};

/// The motion element along one of its tracks, m, at the stamps in increasing order at which it was seen.
[[nodiscard]] RecordedCurve recorded_motion(
		const Feature &feature, const TrainingRecording &recording, const Track &track);

/// The recordings must outlive what is returned. Errors: an amplitude that is not above 0, a span that is not
/// within its reference or takes more than an hour, no recording in which the feature moves.
Result<RecordedMovements> recorded_movements(
		const Feature &feature, std::span<const TrainingRecording> recordings);

/// Normalised observations at the symbol clock's instants over the movement; empty ones where nothing new was
/// seen.
std::vector<std::optional<Observation>> observe(
		const Feature &feature, const Movement &movement, double duration_mean_s);

} // namespace steadyhand
