extends RefCounted
## The order of a live hand's trials: in blocks, at each position in turn. If conditions are
## compared, each condition is used at all positions before the next one. Their random order is
## drawn again after all were used (paper, "Procedure").

## As in the paper.
const TRIALS_PER_BLOCK := 5

## The compared conditions. Empty: the chosen condition stays.
var conditions: Array[GestureHMM.Motion] = []

var _seed := 0
var _first_trial := 0


## Starts a first block at this trial.
func begin(trial_index: int, order_seed: int) -> void:
	_first_trial = trial_index
	_seed = order_seed


## Index of the trial's position. `positions`: their number.
func position_at(trial_index: int, positions: int) -> int:
	return (trial_index - _first_trial) / TRIALS_PER_BLOCK % positions


## The trial's condition. `conditions` must not be empty. `positions`: as in position_at().
func condition_at(trial_index: int, positions: int) -> GestureHMM.Motion:
	var turn := (trial_index - _first_trial) / (TRIALS_PER_BLOCK * positions)
	var random := RandomNumberGenerator.new()
	random.seed = hash([_seed, turn / conditions.size()])
	var left := conditions.duplicate()
	var drawn := conditions[0]
	for i in turn % conditions.size() + 1:
		drawn = left.pop_at(random.randi_range(0, left.size() - 1))
	return drawn


## Whether position or condition differ from those of the trial before.
func changes_at(trial_index: int, positions: int) -> bool:
	var is_block := (trial_index - _first_trial) % TRIALS_PER_BLOCK == 0
	return is_block and (positions > 1 or conditions.size() > 1)
