extends RefCounted
## In which order a live hand's trials are made: in blocks, at each of its positions in turn; and,
## where conditions are compared, in each of them at all positions before the next, in a random
## order that is drawn anew once all have been (paper, "Procedure").

## The paper's.
const TRIALS_PER_BLOCK := 5

## Those that are compared; empty: the one that has been chosen stays.
var conditions: Array[GestureHMM.Motion] = []

var _seed := 0
var _first_trial := 0


## From this trial on, with a first block.
func begin(trial_index: int, order_seed: int) -> void:
	_first_trial = trial_index
	_seed = order_seed


## Index of the position at which the trial is made, of so many.
func position_at(trial_index: int, positions: int) -> int:
	return (trial_index - _first_trial) / TRIALS_PER_BLOCK % positions


## The condition in which it is made; some have to be compared. `positions`: as in position_at().
func condition_at(trial_index: int, positions: int) -> GestureHMM.Motion:
	var turn := (trial_index - _first_trial) / (TRIALS_PER_BLOCK * positions)
	var random := RandomNumberGenerator.new()
	random.seed = hash([_seed, turn / conditions.size()])
	var left := conditions.duplicate()
	var drawn := conditions[0]
	for i in turn % conditions.size() + 1:
		drawn = left.pop_at(random.randi_range(0, left.size() - 1))
	return drawn


## Whether the trial is made elsewhere, or in another condition, than the one before it.
func changes_at(trial_index: int, positions: int) -> bool:
	var is_block := (trial_index - _first_trial) % TRIALS_PER_BLOCK == 0
	return is_block and (positions > 1 or conditions.size() > 1)
