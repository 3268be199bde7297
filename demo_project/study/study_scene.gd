extends Node3D
## A study with a person: asks for the participant, then runs the session. With `--xr-mode on` the
## participant wears a headset, and the window shows the operator's panel.
## Keys: P pauses and continues, N skips, space recentres, F2 shows the operator's window.
## Closing the window ends the run; the session can be resumed.

const DesktopPanel := preload("desktop_questionnaire_panel.gd")
const HandView := preload("res://xr/hand_view.gd")
const MouseStudyHand := preload("mouse_study_hand.gd")
const OperatorPanel := preload("operator_panel.gd")
const PointingPanel := preload("pointing_questionnaire_panel.gd")
const StudyHand := preload("study_hand.gd")
const StudyView := preload("study_view.gd")
const Tasks := preload("res://scripts/tasks.gd")
const WorldPanel := preload("world_panel.gd")
const XRRig := preload("res://xr/xr_rig.gd")

const RIG := "res://xr/xr_rig.tscn"
const SKIN := preload("res://xr/skin.tres")
## Where the eyes of the seated player are: the tasks are 0.4 m in front of them.
const SEAT := Vector3(0.0, 0.15, 0.15)
const DISPLAY_PLACE := Vector3(0.0, 0.19, -0.4)
const DISPLAY_TILT := deg_to_rad(-4.0)
const DISPLAY_TEXT_SCALE := 2.0
const OPERATOR_SIZE := Vector2i(480, 640)

## Empty: the paper's.
@export var protocol: StudyProtocol = null
## Sessions are written below it.
@export_global_dir var study_folder := "user://studies"
## The participant's hand. Empty: the headset's right hand, or the mouse without a headset.
@export var source: HandSource = null
## A sensor to compare with. Empty: none.
@export var reference_source: HandSource = null
## Sends the hand's frames and the events to the Lab Streaming Layer. Needs liblsl.
@export var use_lsl := false

var session: StudySession = null
var runner: StudyRunner = null
## Null without a headset.
var rig: XRRig = null
## Null without a headset.
var display: WorldPanel = null
var view: StudyView = null
## An LslOutlet. Null without `use_lsl`.
var lsl: Node = null
var operator_panel := OperatorPanel.new()
## The operator's window on the desktop. Null with a headset: the main window serves.
var operator_window: Window = null

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
	operator_panel.pause_pressed.connect(pause_or_continue)
	operator_panel.recentre_pressed.connect(recentre)
	operator_panel.skip_pressed.connect(skip)
	var xr := XRServer.find_interface("OpenXR")
	if xr != null and xr.is_initialized():
		_enter_headset()
	else:
		_make_operator_window()


## Resumes the participant's unfinished session, or starts a new one.
func run_session(participant_id: String) -> Error:
	var other_study := StudySession.folder_in_other_case(_folder())
	if not other_study.is_empty():
		_message.text = (
			"Study '%s': there is '%s' already. Choose another 'study_name': case is not enough."
			% [protocol.study_name, other_study]
		)
		push_error(_message.text)
		return ERR_INVALID_PARAMETER
	var hand := _make_hand()
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
	if use_lsl and ClassDB.class_exists(&"LslOutlet"):
		_send_to_lsl(hand.tracker)
	runner = StudyRunner.new()
	add_child(runner)
	runner.session = session
	view = StudyView.new()
	var panel: QuestionnairePanel = null
	if display == null:
		add_child(view)
		panel = DesktopPanel.new()
	else:
		display.viewport.add_child(view)
		view.enlarge(DISPLAY_TEXT_SCALE, WorldPanel.SIZE)
		panel = PointingPanel.new(display, hand.tracker)
		display.viewport.add_child(panel)
	if rig == null:
		_show_hand(hand.tracker)
	view.follow(runner)
	operator_panel.follow(runner)
	hand.tracker.failed.connect(view.show_notice)
	hand.tracker.source_ready.connect(func() -> void: view.show_notice(""))
	opened = runner.begin(session, hand, panel)
	if opened != OK:
		_message.text = "The hand's source cannot be opened. The log says why."
		_form.visible = true
		view.free()
		runner.free()
		runner = null
		if lsl != null:
			lsl.free()
		if is_instance_valid(panel):
			panel.free()
	return opened


func pause_or_continue() -> void:
	if runner == null:
		return
	if runner.state == StudyRunner.State.PAUSED:
		runner.continue_run()
	else:
		runner.pause()


## Ends the trial, the rest or the questionnaire's item.
func skip() -> void:
	if runner != null:
		runner.skip()


func recentre() -> void:
	if rig != null:
		rig.recentre()


## Shows title, instruction and questionnaires in the scene. Call it before run_session().
func make_display() -> void:
	display = WorldPanel.new()
	display.position = DISPLAY_PLACE
	display.rotation.x = DISPLAY_TILT
	add_child(display)


func _unhandled_key_input(event: InputEvent) -> void:
	var key := event as InputEventKey
	if not key.pressed or key.echo:
		return
	if key.keycode == KEY_P:
		pause_or_continue()
	elif key.keycode == KEY_N:
		skip()
	elif key.keycode == KEY_SPACE:
		recentre()
	elif key.keycode == KEY_F2 and operator_window != null:
		operator_window.visible = not operator_window.visible
	elif key.keycode == KEY_ESCAPE and runner == null and get_tree().current_scene == self:
		get_tree().change_scene_to_file(Tasks.MENU)


## The headset has a viewport of its own, so that the window is free for the operator.
func _enter_headset() -> void:
	var headset := SubViewport.new()
	headset.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	headset.msaa_3d = get_viewport().msaa_3d
	rig = (load(RIG) as PackedScene).instantiate() as XRRig
	rig.seat = SEAT
	rig.recentred.connect(_on_recentred)
	headset.add_child(rig)
	add_child(headset)
	get_viewport().disable_3d = true
	make_display()
	var layer := CanvasLayer.new()
	layer.layer = -1
	operator_panel.set_anchors_preset(Control.PRESET_FULL_RECT)
	layer.add_child(operator_panel)
	add_child(layer)


func _make_operator_window() -> void:
	if DisplayServer.has_feature(DisplayServer.FEATURE_SUBWINDOWS):
		get_viewport().gui_embed_subwindows = false
	operator_window = Window.new()
	operator_window.title = "Operator"
	operator_window.size = OPERATOR_SIZE
	operator_window.visible = false
	operator_window.close_requested.connect(operator_window.hide)
	operator_window.window_input.connect(
		func(event: InputEvent) -> void:
			if event is InputEventKey:
				_unhandled_key_input(event)
	)
	operator_panel.set_anchors_preset(Control.PRESET_FULL_RECT)
	operator_window.add_child(operator_panel)
	add_child(operator_window)


func _make_hand() -> StudyHand:
	if source != null:
		return StudyHand.new(source, reference_source)
	if rig != null:
		return StudyHand.new(rig.right.source.duplicate() as HandSource, reference_source)
	return MouseStudyHand.new()


## The outlet leaves the tree after the runner, whose last event it sends.
func _send_to_lsl(tracker: HandTracker) -> void:
	lsl = ClassDB.instantiate(&"LslOutlet")
	lsl.name = "Outlet"
	lsl.set("tracker", tracker)
	lsl.set("source_id", "%s_%s" % [protocol.study_name, session.participant])
	session.event_added.connect(
		func(event: String, value: String, trial: int) -> void:
			lsl.call("push_event", "%s,%s,%s" % [trial if trial > 0 else "", event, value])
	)
	add_child(lsl)


func _show_hand(tracker: HandTracker) -> void:
	var hand_view := HandView.new()
	hand_view.tracker = tracker
	hand_view.material = SKIN
	runner.add_child(hand_view)


func _exit_tree() -> void:
	if rig != null:
		get_viewport().disable_3d = false


func _on_recentred() -> void:
	if runner != null and runner.session != null:
		runner.add_event("recentred")


func _folder() -> String:
	return study_folder.path_join(protocol.study_name)


func _show_what_comes() -> void:
	var id := _participant.text.strip_edges()
	_message.text = (
		"\n".join(protocol.warnings()) if id.is_empty() else StudySession.id_problem(id)
	)
