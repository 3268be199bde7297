extends RefCounted
## The trials of one participant, drawn from a protocol. Equal input gives an equal plan on every
## machine: see draw().


## The `trials` of session.json. `amplitude_m` and `width_m` are null where the protocol has none.
static func make(protocol: StudyProtocol, participant_id: String) -> Array[Dictionary]:
	var random := Draw.new(protocol.seed, participant_id)
	var number := participant_number(participant_id, protocol.seed)
	var trials: Array[Dictionary] = []
	for gesture in _gestures(protocol, number, random):
		var cells := _cells(protocol, gesture)
		_add_practice(trials, protocol, cells)
		var begun: Array[int] = []
		begun.resize(cells.size())
		begun.fill(0)
		for round_index in protocol.trials_per_cell / protocol.block_size:
			for cell in _cell_order(protocol.order, cells.size(), number, random):
				var block := _next_block(trials)
				for i in protocol.block_size:
					begun[cell] += 1
					_add(trials, cells[cell], block, false, begun[cell])
	_add_rests(trials, protocol)
	return trials


## The `questionnaires` of session.json: {after_trial, questionnaire (its name)}, in order.
static func make_questionnaires(
	protocol: StudyProtocol, trials: Array[Dictionary]
) -> Array[Dictionary]:
	var planned: Array[Dictionary] = []
	var counted := 0
	for trial in trials:
		if trial["practice"]:
			continue
		counted += 1
		for asked in protocol.questionnaires:
			if asked.after_trials > 0 and counted % asked.after_trials == 0:
				planned.append({after_trial = trial["trial"], questionnaire = asked.name})
	for asked in protocol.questionnaires:
		if asked.after_trials == 0:
			planned.append({after_trial = trials.size(), questionnaire = asked.name})
	return planned


## Which row of a Latin square the participant gets, from 0: "p01", "p02" ... get one after another,
## by the digits at the end; an id without such digits gets a drawn one.
static func participant_number(participant_id: String, seed: int) -> int:
	var digits := ""
	for i in range(participant_id.length() - 1, -1, -1):
		if not participant_id[i].is_valid_int():
			break
		digits = participant_id[i] + digits
	if digits.is_empty() or digits.length() > 9:
		return draw(seed, participant_id, -1) % 1000000
	return maxi(digits.to_int() - 1, 0)


## A number from 0 to 2^60 - 1: the first 15 hexadecimal digits of the SHA-256 of the text
## "SEED/PARTICIPANT/INDEX". Any language can draw it again.
static func draw(seed: int, participant_id: String, index: int) -> int:
	return ("%d/%s/%d" % [seed, participant_id, index]).sha256_text().left(15).hex_to_int()


## A Williams design: rows of the numbers 0 .. n - 1. Within all its rows each number is at each
## place equally often and follows each other number equally often. n rows for an even n; for an odd
## n 2n rows, the second half mirrors the first (Williams 1949, doi:10.1071/CH9490149).
static func latin_square(n: int) -> Array[PackedInt32Array]:
	var rows: Array[PackedInt32Array] = []
	for first in n:
		var row := PackedInt32Array()
		for place in n:
			var offset := (place + 1) / 2 if place % 2 == 1 else n - place / 2
			row.append((first + offset) % n)
		rows.append(row)
	if n % 2 == 1 and n > 1:
		for first in n:
			var mirrored := rows[first].duplicate()
			mirrored.reverse()
			rows.append(mirrored)
	return rows


static func _gestures(protocol: StudyProtocol, number: int, random: Draw) -> PackedStringArray:
	if not protocol.vary_gesture_order:
		return protocol.gestures
	var ordered := PackedStringArray()
	for index in _cell_order(protocol.order, protocol.gestures.size(), number, random):
		ordered.append(protocol.gestures[index])
	return ordered


static func _cells(protocol: StudyProtocol, gesture: String) -> Array[Dictionary]:
	var amplitudes := Array(protocol.amplitudes_m)
	var widths := Array(protocol.widths_m)
	var cells: Array[Dictionary] = []
	for position in protocol.positions:
		for condition in protocol.conditions:
			for amplitude: Variant in [null] if amplitudes.is_empty() else amplitudes:
				for width: Variant in [null] if widths.is_empty() else widths:
					var cell := {gesture = gesture, position = position, condition = condition}
					cell["amplitude_m"] = amplitude
					cell["width_m"] = width
					cells.append(cell)
	return cells


static func _cell_order(
	order: StudyProtocol.Order, count: int, number: int, random: Draw
) -> PackedInt32Array:
	if order == StudyProtocol.Order.LATIN_SQUARE:
		var rows := latin_square(count)
		return rows[number % rows.size()]
	var indices := PackedInt32Array(range(count))
	return random.shuffle(indices) if order == StudyProtocol.Order.RANDOM else indices


## Of all cells in turn, so that the participant meets each position and condition.
static func _add_practice(
	trials: Array[Dictionary], protocol: StudyProtocol, cells: Array[Dictionary]
) -> void:
	var block := _next_block(trials)
	for i in protocol.practice_trials:
		_add(trials, cells[i % cells.size()], block, true, i + 1)


static func _next_block(trials: Array[Dictionary]) -> int:
	return 1 if trials.is_empty() else trials[-1]["block"] + 1


static func _add(
	trials: Array[Dictionary], cell: Dictionary, block: int, practice: bool, repetition: int
) -> void:
	var trial := {trial = trials.size() + 1, block = block, practice = practice}
	trial.merge(cell)
	trial["repetition"] = repetition
	trial["rest_before_s"] = 0.0
	trials.append(trial)


static func _add_rests(trials: Array[Dictionary], protocol: StudyProtocol) -> void:
	var counted := 0
	var is_due := false
	for trial in trials:
		if is_due:
			trial["rest_before_s"] = protocol.rest_s
			is_due = false
		if not trial["practice"]:
			counted += 1
			var every := protocol.rest_after_trials
			is_due = every > 0 and protocol.rest_s > 0.0 and counted % every == 0


## A stream of draw()s.
class Draw:
	var _seed := 0
	var _participant_id := ""
	var _index := 0

	func _init(seed: int, participant_id: String) -> void:
		_seed = seed
		_participant_id = participant_id

	## 0 .. count - 1.
	func below(count: int) -> int:
		var text := "%d/%s/%d" % [_seed, _participant_id, _index]
		_index += 1
		return text.sha256_text().left(15).hex_to_int() % count

	## Fisher and Yates, from the last place to the second.
	func shuffle(numbers: PackedInt32Array) -> PackedInt32Array:
		for i in range(numbers.size() - 1, 0, -1):
			var j := below(i + 1)
			var kept := numbers[i]
			numbers[i] = numbers[j]
			numbers[j] = kept
		return numbers
