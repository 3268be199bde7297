extends QuestionnairePanel
## Answers in place of a simulated person, by a rule; answers.csv says `origin` synthetic. They say
## nothing about real people. They exist so that an analysis has data of a known structure.
##
## Of the trials of the questionnaire's block, for the curve of the condition that drove vibration
## and scene, against the hand's own motion:
##   delay = mean |t_diff| (s), roughness = mean of -1.4 - sparc (at least 0; -1.4 is a
##   minimum-jerk motion), fault = 0.5 * delay / DELAY_S + 0.5 * roughness / ROUGHNESS.
## Agreement (0..1) with the statement of the item
##   "synchronisation": 1 - delay / DELAY_S,
##   "smoothness":      1 - roughness / ROUGHNESS,
##   any other:         1 - fault.
## A bias of the person (+-0.1) and of the answer (+-0.15) are added, both drawn with
## StudyPlan.draw(). The result is clamped to 0..1 and rounded to the scale. Task load is the
## opposite: 1 - agreement.

const StudyPlan := preload("study_plan.gd")

## Agreement is 0 from this delay and this roughness on.
const DELAY_S := 0.4
const ROUGHNESS := 4.0
const MINIMUM_JERK_SPARC := -1.4
const PERSON_BIAS := 0.1
const ANSWER_BIAS := 0.15

var participant := ""
var seed := 0

## MotionMetrics.compare() of the driving condition, since the last questionnaire.
var _figures: Array[Dictionary] = []
var _last: Dictionary = {}


## After each trial.
func remember(figures: Dictionary) -> void:
	_figures.append(figures)


func ask(asked: Questionnaire, items: PackedStringArray, trial: Dictionary) -> void:
	if not _figures.is_empty():
		_last = _faults()
		_figures.clear()
	for item in items:
		answered.emit(item, _answer(asked, item, trial["trial"]), 0)


func _faults() -> Dictionary:
	var delay := 0.0
	var roughness := 0.0
	for figures in _figures:
		delay += absf(figures["t_diff"]) / _figures.size()
		roughness += maxf(MINIMUM_JERK_SPARC - figures["sparc"], 0.0) / _figures.size()
	return {delay = delay / DELAY_S, roughness = roughness / ROUGHNESS}


func _answer(asked: Questionnaire, item: String, trial: int) -> int:
	var delay: float = _last.get("delay", 0.0)
	var roughness: float = _last.get("roughness", 0.0)
	var fault := 0.5 * (delay + roughness)
	if item == "synchronisation":
		fault = delay
	elif item == "smoothness":
		fault = roughness
	var agreement := 1.0 - fault + PERSON_BIAS * _draw(-2)
	agreement += ANSWER_BIAS * _draw(-1000 * trial - 10 - asked.items.find(item))
	agreement = clampf(agreement, 0.0, 1.0)
	var share := 1.0 - agreement if asked.kind == Questionnaire.Kind.TASK_LOAD else agreement
	var steps := (asked.maximum - asked.minimum) / asked.step
	return asked.minimum + asked.step * roundi(share * steps)


## -1..1.
func _draw(index: int) -> float:
	return StudyPlan.draw(seed, participant, index) % 1000001 / 500000.0 - 1.0
