#pragma once

// Tuning parameters of the motion core: motion/, recognition/ and TrackerMonitor. Those of the HMMs are
// in ClassifierOptions. Lengths without a unit are in amplitudes: 1 is the distance from a task's start
// to its end. A value without a source was fitted on simulated people of the tuning population. Those of
// hand and tracker were fitted with tools/tuning/fit_parameters.py, and then moved until the unit tests
// passed. `./steadyhand bench ablation` measures the effect of mechanisms.

/// A constant, except in the benchmarks that vary parameters.
#ifdef STEADYHAND_VARIABLE_PARAMETERS
#define STEADYHAND_PARAMETER inline double
#else
#define STEADYHAND_PARAMETER inline constexpr double
#endif

namespace steadyhand::parameters {

// Shared by several parts.

/// A dropout of this length is bridged (SPEC: up to 0.3 s). After a longer one the hand must be found again.
STEADYHAND_PARAMETER SHORT_DROPOUT_S = 0.3;
/// After a dropout of this length the hand's position is unknown: sessions are idle.
STEADYHAND_PARAMETER LONG_DROPOUT_S = 1.0;
/// A hand that pauses for this long begins another movement. People hesitate for less within one.
STEADYHAND_PARAMETER PAUSE_S = 1.0;
/// Longest time from an event to its detection. After the same time again the event is regarded as missing.
STEADYHAND_PARAMETER DETECTION_S = 0.3;
/// A frame sooner after the last one is not used: errors of trackers last longer.
STEADYHAND_PARAMETER LEAST_FRAME_S = 0.0035;
/// Rates of the blends over a step: at a frame or a state, at the start of a gesture, to another gesture.
STEADYHAND_PARAMETER FRAME_BLEND_PER_S = 125.0, START_BLEND_PER_S = 100.0, CHANGE_BLEND_PER_S = 50.0;

// motion/: the hand.

/// Standard deviation of the log duration of a gesture about the model's mean. Scenes have any pace.
STEADYHAND_PARAMETER LOG_DURATION_SPREAD = 0.6;
/// Random walk of the log duration, per square root of a second: hands change their pace during a movement.
STEADYHAND_PARAMETER PACE_WALK = 0.1;
/// Onsets per second of a hand that rests at the start.
STEADYHAND_PARAMETER ONSETS_PER_S = 4.0;
/// Standard deviation of the onset's place about the task's start.
STEADYHAND_PARAMETER START_SPREAD = 0.07;
/// Share of the minimum-jerk curve (Flash & Hogan 1985) in a movement; the rest is the model's curve.
STEADYHAND_PARAMETER SHAPE_MEAN = 0.6, SHAPE_SPREAD = 0.33;
/// Standard deviation of the relative error of the endpoint, with a task and without.
STEADYHAND_PARAMETER GAIN_SPREAD = 0.035, NO_TASK_GAIN_SPREAD = 0.12;
/// Deviation of a hand from the curve: critically damped noise, standard deviation and rate.
STEADYHAND_PARAMETER DEVIATION = 0.073, DEVIATION_RATE_PER_S = 4.6;
/// HOLD: standard deviation of the velocity, 1/s, and its rate. Tremor, sway, and the tracker's slow error.
STEADYHAND_PARAMETER HOLD_SPEED = 0.13, HOLD_RATE_PER_S = 8.5;
/// FREE: the same, in m/s because this motion does not depend on the task.
STEADYHAND_PARAMETER FREE_SPEED_M_S = 0.44, FREE_RATE_PER_S = 6.0;
/// Rates of switches between modes.
STEADYHAND_PARAMETER GESTURE_TO_FREE_PER_S = 0.03, GESTURE_TO_HOLD_PER_S = 0.12;
STEADYHAND_PARAMETER FREE_TO_HOLD_PER_S = 3.0, HOLD_TO_FREE_PER_S = 0.3;

// motion/: the tracker.

/// LAGGING: prior probability.
STEADYHAND_PARAMETER LAGGING_SHARE = 0.37;
/// Lag at the end of a long movement: mean and standard deviation. It builds up over LAG_SETTLING_S.
STEADYHAND_PARAMETER LAG_S = 0.085, LAG_SPREAD_S = 0.045, LAG_SETTLING_S = 0.7;
/// Further latency of a LAGGING tracker after a fault.
STEADYHAND_PARAMETER FAULTY_LATENCY_S = 0.033;
/// Error of a LAGGING tracker: critically damped noise, standard deviation and rate.
STEADYHAND_PARAMETER LAGGING_ERROR = 0.05, LAGGING_ERROR_RATE_PER_S = 8.0;
/// Log of the ratio of the fault rates, LAGGING to SOUND: dropouts and freezes; jumps.
STEADYHAND_PARAMETER LOG_FAULTS = 1.8, LOG_JUMPS = 0.4;
/// Growth of that log ratio while a fault lasts, per s, and its limit. Faults of a sound tracker have a mean
/// length of 0.025 s, those of a lagging one 0.13 s.
STEADYHAND_PARAMETER LOG_FAULTS_PER_S = 25.0, MOST_LOG_FAULTS = 3.0;
/// Difference of the fault rates, LAGGING minus SOUND, 1/s: log likelihood ratio of a second without faults.
STEADYHAND_PARAMETER FAULTS_PER_S = 0.5;
/// Rate at which the tracker's mode is drawn anew while the hand makes no gesture: it moves to other places.
STEADYHAND_PARAMETER TRACKER_CHANGES_PER_S = 0.1;
/// White noise in addition to the noise that TrackerMonitor measures: no hand follows the curve exactly.
STEADYHAND_PARAMETER MEASUREMENT_NOISE = 0.0025;
/// Errors of measurements closer in time are correlated: their likelihood has a power below 1, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
STEADYHAND_PARAMETER ALIKE_S = 0.0075;
/// Share of outliers that TrackerMonitor misses, and their density.
STEADYHAND_PARAMETER OUTLIERS = 0.01, OUTLIER_DENSITY = 0.4;

// motion/: the hypotheses.

/// Time between two births of hypotheses, and the range of their durations, in standard deviations.
STEADYHAND_PARAMETER BIRTH_PERIOD_S = 0.05, WIDEST_DURATION = 1.7;
/// Hypotheses of less weight, relative to the greatest one, are deleted.
STEADYHAND_PARAMETER LEAST_WEIGHT = 1e-3;
/// A hand does not turn within this time.
STEADYHAND_PARAMETER SAME_MOVEMENT_S = 0.1;
/// A gesture is not put out before this phase, at 3 % of the amplitude.
STEADYHAND_PARAMETER VISIBLE_PHASE = 0.15;

} // namespace steadyhand::parameters

namespace steadyhand::parameters::sessions {

// All sessions. Values are in amplitudes, speeds in amplitudes / mean duration: a minimum-jerk movement peaks
// at 1.875.

/// Phase from which on a gesture is at its end, and its hand has almost stopped.
STEADYHAND_PARAMETER END_PHASE = 0.98;
/// Cosine of the largest angle between directions that are the same: 45 degrees.
STEADYHAND_PARAMETER PARALLEL = 0.7;
/// A hand within this value of the start has returned, and one that goes back by TURNED_BACK has turned.
STEADYHAND_PARAMETER RETURNED = 0.15, TURNED_BACK = 0.08;
/// A gesture may have ended in a dropout that begins beyond this value.
STEADYHAND_PARAMETER NEAR_END = 0.75;

// With a task: TaskEvidence.

/// Log prior odds of the gesture against none, without evidence and near the task.
STEADYHAND_PARAMETER LOG_PRIOR_NO_TASK = -5.0, LOG_PRIOR_TASK = 1.0;
/// Window of the speed: a tracker's slow error moves by a centimetre in a tenth of a second.
STEADYHAND_PARAMETER WINDOW_S = 0.1;
/// A movement begins above this share of its peak speed.
STEADYHAND_PARAMETER SPEED_SHARE = 0.25;
/// Straight pieces of a path that are shorter than this are tremor.
STEADYHAND_PARAMETER SMALLEST_PIECE = 0.06;
/// Standard deviation of the direction to a task's end, radians: aim and the tracker's error.
STEADYHAND_PARAMETER TASK_DIRECTION = 0.11;
/// Bow = mean distance of the path from its chord / length. Scale for gestures, and limit of the null model.
STEADYHAND_PARAMETER BOW = 0.18, LARGEST_BOW = 0.5;
/// Standard deviation of a gesture's start about the task's start.
STEADYHAND_PARAMETER START = 0.12;
/// The null model's movements start within this radius.
STEADYHAND_PARAMETER OTHER_STARTS = 1.5;
/// Longest part of the movement before the hand comes into view, and nats against such a movement.
STEADYHAND_PARAMETER UNSEEN_PART = 0.45, REST_UNSEEN = 1.5;

// With a task.

/// Least values of a start: value, speed (only `paper` mode), and value in standard deviations of the drift.
STEADYHAND_PARAMETER START_VALUE = 0.03, START_SPEED = 0.1, START_DRIFTS = 10.0;
/// Drift at rest until it is measured.
STEADYHAND_PARAMETER UNKNOWN_DRIFT = 0.02;
/// Probability of the gesture above which it starts, and below which it is aborted.
STEADYHAND_PARAMETER START_PROBABILITY = 0.7, ABORT_PROBABILITY = 0.1;
/// Beyond this value a gesture starts at any probability.
STEADYHAND_PARAMETER HALFWAY = 0.5;
/// `paper` mode: near the start, a gesture is aborted after this many mean durations of the first state.
STEADYHAND_PARAMETER ABORT_AFTER = 3.0;
/// The hand has stopped if P(HOLD) is greater for this time.
STEADYHAND_PARAMETER STOP_PROBABILITY = 0.7, STOP_S = 0.2;
/// Log odds for an end before the target: hands that do something else stop anywhere.
STEADYHAND_PARAMETER STOP_LOG_ODDS = 9.0;
/// A gesture does not start farther from its start. A hand that stays farther for this time is not followed.
STEADYHAND_PARAMETER ELSEWHERE = 0.7, ELSEWHERE_S = 3.0;
/// Least distance, m, to the start of a gesture that may start anywhere.
STEADYHAND_PARAMETER ANYWHERE_M = 0.1;
/// Distance from the path beyond which the hand has left the task: of a circle and of a straight path.
STEADYHAND_PARAMETER OFF_CIRCLE = 0.3, OFF_STRAIGHT = 1.0;
/// Greatest age of a measurement of the hand's position.
STEADYHAND_PARAMETER RECENT_S = 0.1;

// Without a task, by HMM.

/// Posterior of a start, an abort and an end. An early start costs little: only the end counts.
STEADYHAND_PARAMETER START_POSTERIOR = 0.1, ABORT_POSTERIOR = 0.03, END_POSTERIOR = 0.99;
/// Least reach of a movement with a direction.
STEADYHAND_PARAMETER SHORTEST = 0.12;
/// A hand has returned from its end at this fraction of its greatest distance.
STEADYHAND_PARAMETER HALF_BACK = 0.5;

// Several gestures.

/// Difference of the log odds at which another gesture is shown.
STEADYHAND_PARAMETER SWITCH_MARGIN = 2.0;
/// Ratio of the distances at which another task is shown while the hand rests.
STEADYHAND_PARAMETER NEARER = 0.8;
/// Steps between tasks below this are blended: the tasks have the same path.
STEADYHAND_PARAMETER SAME_PATH = 0.1;

} // namespace steadyhand::parameters::sessions

// Hysteresis: the limit at which a condition ends is looser than the one at which it is met.
namespace steadyhand::parameters::start {

/// DWELL: a hand dwells within 20 mm and has left beyond 30 mm, where Ultraleap TouchFree starts a drag. The
/// 10 mm of the Meta Interaction SDK are less than the errors of bad trackers.
STEADYHAND_PARAMETER STILL_M = 0.020, LEFT_M = 0.030;
/// PINCH: Ultraleap's detector closes at 25 mm and opens at 30 mm.
STEADYHAND_PARAMETER OPENS_AT = 30.0 / 25.0;
/// POINTING_POSE: ratio of the distances index tip to palm and next tip to palm. Open hands and fists have
/// 0.9 to 1.1 (leapjs-playback, Leap-QTM), a pointing hand of average size has 2.1.
STEADYHAND_PARAMETER POINTS_FROM = 1.5, POINTS_TO = 1.3;
/// Least distance index tip to palm, m: in a fist the ratio is noise.
STEADYHAND_PARAMETER EXTENDED_M = 0.07;
/// A shorter slip of a finger does not end the condition (MRTK #10391).
STEADYHAND_PARAMETER SLIP_S = 0.1;
/// Time that a tracker needs to fit a new hand. A pinch within this time before a dropout is an open hand
/// that leaves the view (wolvic #1467).
STEADYHAND_PARAMETER SETTLES_S = 0.2;
/// Confidence, 0 to 1. In leapjs-playback a false pinch of an open hand that leaves the view has a median of
/// 0.6 and a minimum of 0.3; a true pinch has at least 0.97.
STEADYHAND_PARAMETER LEAST_CONFIDENCE = 0.5;

} // namespace steadyhand::parameters::start

namespace steadyhand::parameters::tracker {

/// Frame period until it is measured: the slowest camera in use.
STEADYHAND_PARAMETER UNKNOWN_PERIOD_S = 1.0 / 30.0;
/// Least frame period of hand trackers. Frames closer together were delayed and arrive in a burst.
STEADYHAND_PARAMETER BURST_S = 1e-3;
/// Least dropout. Loaded trackers often skip one or two frames, and time stamps jitter.
STEADYHAND_PARAMETER DROPOUT_PERIODS = 3.5, LEAST_DROPOUT_S = 0.03;
/// Least freeze: the third repeated reading.
STEADYHAND_PARAMETER FREEZE_PERIODS = 2.5;
/// Prior rate of jumps and of freezes. Recordings of Leap Motion have 0.05 to 0.5 jumps a second.
STEADYHAND_PARAMETER FAULTS_PER_S = 0.3;
/// Standard deviation of a jump per axis: 10 to 60 mm of a lost hand model, 0.3 m to the other hand.
STEADYHAND_PARAMETER JUMP_M = 0.1;
/// Longest jump: wrong poses of one to ten frames last up to 90 ms. After a longer one the origin has moved.
STEADYHAND_PARAMETER LONGEST_JUMP_S = 0.09;
/// A jump that is undone within this time is a tracker fault. Later the hand may be anywhere.
STEADYHAND_PARAMETER MEMORY_S = 0.4;
/// Fraction of a jump by which it is undone, and of the speed before it at which the hand stands.
STEADYHAND_PARAMETER UNDONE = 0.5, STOOD = 0.5;
/// Standard deviation of a hand's acceleration within a frame. A 15 cm tap in 0.2 s peaks at 22 m/s^2 (5.77 A
/// / T^2, Flash & Hogan 1985).
STEADYHAND_PARAMETER ACCELERATION_M_S2 = 15.0;
/// Standard deviation of a hand's velocity. The fastest gestures peak at 3 m/s.
STEADYHAND_PARAMETER SPEED_M_S = 1.0;
/// Longest delay of a frame on a busy computer, which then delivers all delayed frames.
STEADYHAND_PARAMETER MOST_BEHIND_S = 0.06;

} // namespace steadyhand::parameters::tracker
