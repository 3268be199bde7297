#include "gesture/recorded_hmms.h"

#include "gesture/classifier_file.h"
#include "gesture/classifier_trainer.h"
#include "gesture/marked_movements.h"
#include "gesture/motion_sequences.h"
#include "gesture/reach_fields.h"

#include <array>
#include <cmath>

namespace steadyhand {

using namespace json_fields;

namespace {

/// More states than a gesture needs. A file with more is damaged.
constexpr std::size_t MOST_STATES = 256;
/// More than there are directions 45 degrees apart.
constexpr std::size_t MOST_DIRECTIONS = 32;
/// People make a gesture faster or slower than they record it. So each recording also counts with its
/// duration multiplied by these factors.
constexpr std::array PACES{ 1.5, 1.0, 0.6, 0.4 };

Eigen::MatrixXd transitions_from_json(const Json &json) {
	Eigen::MatrixXd transitions = matrix(json, "transitions", false);
	const auto states = static_cast<std::size_t>(transitions.rows());
	if (states < END_STATES + 2 || states > MOST_STATES) {
		throw Fault(json["transitions"],
				"transitions: not " + std::to_string(END_STATES + 2) + " .. " + std::to_string(MOST_STATES) +
						" states, are " + std::to_string(states));
	}
	if (transitions.cols() != 2 || !(transitions.minCoeff() >= 0.0)) {
		throw Fault(json["transitions"], "transitions: must be two counts of at least 0 for each state");
	}
	return transitions;
}

/// Row of a count for each symbol, from pairs of symbol and count.
Eigen::RowVectorXd symbols_from_json(const Json &pairs, Eigen::Index symbols) {
	const Eigen::VectorXd values = vector(pairs, "symbols", false);
	Eigen::RowVectorXd counts = Eigen::RowVectorXd::Zero(symbols);
	double last = -1.0;
	for (Eigen::Index i = 0; i + 1 < values.size(); i += 2) {
		const double symbol = values(i);
		const bool is_symbol =
				symbol > last && symbol < static_cast<double>(symbols) && symbol == std::floor(symbol);
		if (!is_symbol) {
			throw Fault(pairs,
					"symbols: a symbol is no integer of 0 .. " + std::to_string(symbols - 1) +
							", or not greater than the one before");
		}
		if (!(values(i + 1) > 0.0)) {
			throw Fault(pairs, "symbols: a count is not greater than 0");
		}
		counts(static_cast<Eigen::Index>(symbol)) = values(i + 1);
		last = symbol;
	}
	if (values.size() % 2 != 0) {
		throw Fault(pairs, "symbols: the last symbol has no count");
	}
	return counts;
}

DirectedCounts direction_from_json(const Json &json, const Feature &feature, Eigen::Index symbols) {
	DirectedCounts counts{ reach_from_json(json), {}, {} };
	if (counts.is_radius != feature.is_radius) {
		throw Fault(json["is_radius"], "is_radius: does not fit the feature");
	}
	counts.transitions = transitions_from_json(json);
	const Json &rows = array(json, "symbols");
	if (static_cast<Eigen::Index>(rows.size()) != counts.transitions.rows()) {
		throw Fault(rows, "symbols: must have a row for each state");
	}
	counts.symbols.resize(counts.transitions.rows(), symbols);
	for (std::size_t i = 0; i < rows.size(); ++i) {
		counts.symbols.row(static_cast<Eigen::Index>(i)) = symbols_from_json(rows[i], symbols);
	}
	return counts;
}

Json direction_to_json(const DirectedCounts &counts) {
	Json symbols = Json::array();
	for (const auto &row : counts.symbols.rowwise()) {
		Json &pairs = symbols.emplace_back(Json::array());
		for (Eigen::Index symbol = 0; symbol < row.size(); ++symbol) {
			if (row(symbol) > 0.0) {
				pairs.push_back(symbol);
				pairs.push_back(row(symbol));
			}
		}
	}
	Json json = reach_to_json(counts);
	json["transitions"] = matrix_to_json(counts.transitions);
	json["symbols"] = std::move(symbols);
	return json;
}

/// A state without an observation has no distribution.
bool has_all_states(const DirectedCounts &counts) {
	return counts.symbols.rowwise().sum().minCoeff() > 0.0;
}

} // namespace

std::vector<DirectedCounts> recorded_counts(const Feature &feature, std::span<const Movement> movements) {
	const ClassifierTrainingOptions options;
	std::vector<MarkedDirection> directions;
	for (const double pace : PACES) {
		for (const Movement &movement : movements) {
			Track track = movement.recording->measured;
			if (feature.place == nullptr || track.frames.empty()) {
				continue;
			}
			for (HandFrame &frame : track.frames) {
				frame.t_s *= pace;
			}
			const MovementSpan span{ pace * movement.span.onset_s, pace * movement.span.end_s };
			add_movement(directions, {}, feature.is_radius, movement.recording->task.axis,
					MotionInstants(track), span, options.states);
		}
	}
	std::vector<DirectedCounts> all;
	std::erase_if(directions, [](const MarkedDirection &direction) { return direction.movements.empty(); });
	for (const MarkedDirection &direction : directions) {
		DirectedCounts counts = counts_of(direction, own_classifier()->codebook, options.states,
				feature.is_radius ? options.reach_deviation_radius : options.reach_deviation);
		if (has_all_states(counts)) {
			all.push_back(std::move(counts));
		}
	}
	return all;
}

std::vector<DirectedHmm> recorded_hmms(const std::string &gesture, std::span<const DirectedCounts> counts) {
	std::vector<DirectedHmm> hmms;
	const Eigen::RowVectorXd other = symbols_of_other(own_classifier()->other);
	for (const DirectedCounts &one : counts) {
		hmms.push_back(directed_hmm(gesture, one, other, ClassifierTrainingOptions().odd_symbols));
	}
	return hmms;
}

Json counts_to_json(std::span<const DirectedCounts> counts) {
	Json directions = Json::array();
	for (const DirectedCounts &one : counts) {
		directions.push_back(direction_to_json(one));
	}
	return { { "codebook", checksum(own_classifier()->codebook) }, { "directions", std::move(directions) } };
}

std::vector<DirectedCounts> counts_from_json(const Json &json, const Feature &feature) {
	const MotionCodebook &codebook = own_classifier()->codebook;
	if (text(json, "codebook") != checksum(codebook)) {
		throw Fault(json["codebook"], "codebook: not the one of this version. Train the gesture again");
	}
	if (feature.place == nullptr) {
		throw Fault(json, "recorded_hmms: the feature '" + std::string(feature.name) + "' has none");
	}
	const Json &directions = array(json, "directions");
	if (directions.size() > MOST_DIRECTIONS) {
		throw Fault(directions, "directions: more than " + std::to_string(MOST_DIRECTIONS));
	}
	std::vector<DirectedCounts> counts;
	for (const Json &direction : directions) {
		counts.push_back(direction_from_json(direction, feature, codebook.symbols()));
	}
	return counts;
}

} // namespace steadyhand
