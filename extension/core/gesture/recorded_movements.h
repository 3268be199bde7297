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

/// A usable recording, and the span of its movement.
struct Movement {
	const TrainingRecording *recording = nullptr;
	MovementSpan span;

	[[nodiscard]] double duration_s() const { return span.end_s - span.onset_s; }
};

/// An unusable recording.
struct LeftOut {
	const TrainingRecording *recording = nullptr;
	std::string reason;
};

struct RecordedMovements {
	std::vector<Movement> movements;
	std::vector<Eigen::VectorXd> curves; ///< normalised_curve() of each movement
	std::vector<LeftOut> left_out;
};

/// The motion element, m, in a track of the recording. Stamps increase strictly.
[[nodiscard]] RecordedCurve recorded_motion(
		const Feature &feature, const TrainingRecording &recording, const Track &track);

/// The movements of all usable recordings (recording_oddity.h). The recordings must outlive the result.
/// Error: there is none.
Result<RecordedMovements> recorded_movements(
		const Feature &feature, std::span<const TrainingRecording> recordings);

/// Normalised observations at the instants of the symbol clock during the movement; nullopt at instants
/// without a new frame.
std::vector<std::optional<Observation>> observe(
		const Feature &feature, const Movement &movement, double duration_mean_s);

} // namespace steadyhand
