"""The README of an exported BIDS dataset."""

README = """\
{name}
======

A study with SteadyHand, an add-on for the Godot engine that recognises hand gestures and drives haptics.
participants.tsv tells who made the trials: a person, a mouse, a synthetic hand or a replay.

How the study maps to BIDS
--------------------------

- A task is a gesture. The label is its name without underscores, the TaskName is its name.
- A run is a trial: run-0007 is trial 7 of the session. Frames are recorded in trials only, so each file has no break.
- A tracksys is a tracker. The reference tracker is a tracksys of its own; the label "truth" is a simulated hand's own
  motion.
- The channel "latency" has the time of each frame in s from the first one, because frames come at uneven times.
- A point that the tracker did not see in a frame is n/a.
- SamplingFrequency is the median rate of the session, SamplingFrequencyEffective the mean rate of the file.
- acq_time in scans.tsv aligns the files of a session. Files with the same number in the column program_run share a
  clock.
- motion/*_events.tsv has the events of a trial. Onset 0 is the first frame of the tracker, or of the reference if the
  tracker has none.
- motion/*_recording-curves_stim.tsv.gz has the motion that each filter made of the frames, and the vibration, at 1 kHz.
- beh/*_task-GESTURE_beh.tsv has the results of the trials, a row each. Practice trials have practice = 1: leave them
  out of any analysis.
- beh/*_task-questionnaires_beh.tsv has the answers. BIDS allows one row for each participant in phenotype/, and a study
  asks after many trials, so that the answers are here.
- beh/*_task-session_events.tsv has the events outside of trials, and of trials that have no recording. Onset 0 is the
  start of the program; run N is the column program_run.
- sourcedata/ has each session.json: the plan, the protocol, the settings and the machine.

Before you publish
------------------

Add Authors and License to dataset_description.json, and age, sex and handedness to participants.tsv if you have them.
Dates are as recorded: shift them if they can identify a person.
"""
