#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/feature.h"
#include "gesture/json_fields.h"
#include "gesture/recorded_movements.h"

#include <span>
#include <string>
#include <vector>

namespace steadyhand {

// HMMs of a gesture of one's own, over the codebook of own_classifier(). The model file stores their counts.

/// One for each direction of the movements (directions within 45 degrees are one). A direction is left out if
/// the measured tracks do not show the hand before the onset, during the movement and for 0.5 s after it.
/// Empty if the feature has no place.
[[nodiscard]] std::vector<DirectedCounts> recorded_counts(
		const Feature &feature, std::span<const Movement> movements);

[[nodiscard]] std::vector<DirectedHmm> recorded_hmms(
		const std::string &gesture, std::span<const DirectedCounts> counts);

[[nodiscard]] json_fields::Json counts_to_json(std::span<const DirectedCounts> counts);

/// Throws a Fault if the counts are not of this feature, or of another codebook than own_classifier()'s.
[[nodiscard]] std::vector<DirectedCounts> counts_from_json(
		const json_fields::Json &json, const Feature &feature);

} // namespace steadyhand
