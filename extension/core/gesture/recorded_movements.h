#pragma once

#include "base/result.h"
#include "gesture/feature.h"
#include "gesture/observation.h"
#include "gesture/reference_curve.h"
#include "gesture/trainer.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// What is left of a recording once its reference has been looked at.
struct Movement {
	const TrainingRecording *recording = nullptr;
	MovementSpan span;

	[[nodiscard]] double duration_s() const { return span.end_s - span.onset_s; }
};

/// A recording that nothing is learnt from.
struct LeftOut {
	const TrainingRecording *recording = nullptr;
	std::string reason;
};

struct RecordedMovements {
	std::vector<Movement> movements;
	std::vector<Eigen::VectorXd> curves; ///< of each, normalised
	std::vector<LeftOut> left_out;
};

/// The motion element along one of its tracks, m, at the stamps in increasing order at which it was seen.
[[nodiscard]] RecordedCurve recorded_motion(
		const Feature &feature, const TrainingRecording &recording, const Track &track);

/// Of those that are not unusable() (recording_oddity.h). The recordings must outlive what is returned.
/// Error: there are none.
Result<RecordedMovements> recorded_movements(
		const Feature &feature, std::span<const TrainingRecording> recordings);

/// Normalised observations at the symbol clock's instants over the movement; empty ones where nothing new was
/// seen.
std::vector<std::optional<Observation>> observe(
		const Feature &feature, const Movement &movement, double duration_mean_s);

} // namespace steadyhand
