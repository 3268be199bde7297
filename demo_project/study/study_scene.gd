extends Node3D
## A study with a person in front of the screen: asks for the participant, then runs the session.
## P pauses and continues. Closing the window ends the run; the session can be resumed.

const DesktopPanel := preload("desktop_questionnaire_panel.gd")
const MouseStudyHand := preload("mouse_study_hand.gd")
const StudyHand := preload("study_hand.gd")
const StudyView := preload("study_view.gd")

## Empty: the paper's.
@export var protocol: StudyProtocol = null
## Sessions are written below it.
@export_global_dir var study_folder := "user://studies"
## The participant's hand. Empty: the mouse.
@export var source: HandSource = null
## A sensor to compare with. Empty: none.
@export var reference_source: HandSource = null

var session: StudySession = null
var runner: StudyRunner = null

@onready var _form: CanvasLayer = %Form
@onready var _participant: LineEdit = %Participant
@onready var _message: Label = %Message


func _ready() -> void:
	if protocol == null:
		protocol = StudyProtocol.paper()
	(%Start as Button).pressed.connect(func() -> void: run_session(_participant.text))
	_participant.text_submitted.connect(run_session)
	_participant.text_changed.connect(func(_text: String) -> void: _show_what_comes())
	_participant.grab_focus()
	_show_what_comes()


## Resumes the participant's unfinished session, or starts a new one.
func run_session(participant_id: String) -> Error:
	var hand: StudyHand = (
		MouseStudyHand.new() if source == null else StudyHand.new(source, reference_source)
	)
	session = StudySession.new()
	var opened := session.start_or_resume(
		_folder(), participant_id.strip_edges(), protocol, hand.origin, hand.get_settings()
	)
	if opened != OK:
		_message.text = session.error
		hand.free()
		return opened
	_form.visible = false
	_participant.release_focus()
	runner = StudyRunner.new()
	add_child(runner)
	var view := StudyView.new()
	add_child(view)
	runner.session = session
	view.follow(runner)
	hand.tracker.failed.connect(view.show_notice)
	hand.tracker.source_ready.connect(func() -> void: view.show_notice(""))
	opened = runner.begin(session, hand, DesktopPanel.new())
	if opened != OK:
		_message.text = "The hand's source cannot be opened. The log says why."
		_form.visible = true
		view.free()
		runner.free()
		runner = null
	return opened


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if runner == null or not key.pressed or key.echo or key.keycode != KEY_P:
		return
	if runner.state == StudyRunner.State.PAUSED:
		runner.continue_run()
	else:
		runner.pause()


func _folder() -> String:
	return study_folder.path_join(protocol.study_name.validate_filename())


func _show_what_comes() -> void:
	var id := _participant.text.strip_edges()
	_message.text = StudySession.id_problem(id) if not id.is_empty() else ""
