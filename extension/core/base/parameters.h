#pragma once

// Every tuning number of the motion core: motion/, strokes/, recognition/ and TrackerMonitor. Lengths without
// a unit are in amplitudes: 1 is the distance from a task's start to its end. A value without a source was
// fitted on simulated people of the tuning population. `./steadyhand bench ablation` measures what mechanisms
// are worth.

/// A constant, except in that bench.
#ifdef STEADYHAND_VARIABLE_PARAMETERS
#define STEADYHAND_PARAMETER inline double
#else
#define STEADYHAND_PARAMETER inline constexpr double
#endif

namespace steadyhand::parameters {

// Shared by several parts.

/// A dropout of this length is bridged (SPEC: up to 0.3 s). After a longer one the hand must be found again.
STEADYHAND_PARAMETER SHORT_DROPOUT_S = 0.3;
/// After a dropout of this length nothing is known of the hand: sessions are idle.
STEADYHAND_PARAMETER LONG_DROPOUT_S = 1.0;
/// A hand that pauses for this long begins another movement. People hesitate for less within one.
STEADYHAND_PARAMETER PAUSE_S = 1.0;
/// From an event to its detection at most, and as long again until it counts as one that did not come.
STEADYHAND_PARAMETER DETECTION_S = 0.3;
/// A frame that comes sooner after the last one is not used: a tracker's errors last longer.
STEADYHAND_PARAMETER LEAST_FRAME_S = 0.0035;
/// Rates of the blends that hide a step: at a frame or a state, at the start of a gesture, to another
/// gesture.
STEADYHAND_PARAMETER FRAME_BLEND_PER_S = 125.0, START_BLEND_PER_S = 100.0, CHANGE_BLEND_PER_S = 50.0;

// motion/: the hand.

/// Standard deviation of the log duration of a gesture about the model's mean: scenes ask for any pace.
STEADYHAND_PARAMETER LOG_DURATION_SPREAD = 0.6;
/// Random walk of the log duration, per square root of a second: hands change their pace during a movement.
STEADYHAND_PARAMETER PACE_WALK = 0.1;
/// Onsets per second of a hand that rests at the start.
STEADYHAND_PARAMETER ONSETS_PER_S = 4.0;
/// Standard deviation of the onset's place about the task's start.
STEADYHAND_PARAMETER START_SPREAD = 0.07;
/// Share of the minimum-jerk curve (Flash & Hogan 1985) in a movement; the rest is the model's curve.
STEADYHAND_PARAMETER SHAPE_MEAN = 0.36, SHAPE_SPREAD = 0.33;
/// Standard deviation of the relative error of the endpoint, with a task and without.
STEADYHAND_PARAMETER GAIN_SPREAD = 0.041, NO_TASK_GAIN_SPREAD = 0.12;
/// Deviation of a hand from the curve: critically damped noise, standard deviation and rate.
STEADYHAND_PARAMETER DEVIATION = 0.07, DEVIATION_RATE_PER_S = 4.6;
/// HOLD: standard deviation of the velocity, 1/s, and its rate. Tremor, sway, and the tracker's slow error.
STEADYHAND_PARAMETER HOLD_SPEED = 0.12, HOLD_RATE_PER_S = 9.0;
/// FREE: the same in m/s, because this motion has nothing to do with the task.
STEADYHAND_PARAMETER FREE_SPEED_M_S = 0.44, FREE_RATE_PER_S = 6.0;
/// Rates of switches between modes.
STEADYHAND_PARAMETER GESTURE_TO_FREE_PER_S = 0.02, GESTURE_TO_HOLD_PER_S = 0.3;
STEADYHAND_PARAMETER FREE_TO_HOLD_PER_S = 2.0, HOLD_TO_FREE_PER_S = 0.3;

// motion/: the tracker.

/// Prior probability that the tracker lags, the rate at which evidence of it is forgotten, and its least
/// probability during a gesture: trackers begin to lag at any time.
STEADYHAND_PARAMETER LAGGING_SHARE = 0.35, LAGGING_SWITCH_PER_S = 0.2, LAGGING_AT_LEAST = 0.03;
/// Lag at the end of a long movement: mean and standard deviation. It builds up over LAG_SETTLING_S.
STEADYHAND_PARAMETER LAG_S = 0.09, LAG_SPREAD_S = 0.035, LAG_SETTLING_S = 0.4;
/// Further latency of a LAGGING tracker after a fault.
STEADYHAND_PARAMETER FAULTY_LATENCY_S = 0.03;
/// Error of a LAGGING tracker: critically damped noise. Standard deviation at the start, its growth until the
/// end, and rate.
STEADYHAND_PARAMETER LAGGING_ERROR = 0.02, LAGGING_ERROR_ON_WAY = 0.06, LAGGING_ERROR_RATE_PER_S = 8.0;
/// Log of the ratio of the fault rates, LAGGING to SOUND: dropouts and freezes; jumps.
STEADYHAND_PARAMETER LOG_FAULTS = 1.8, LOG_JUMPS = 0.4;
/// Growth of that log ratio while a fault lasts, per s, and its limit. Faults of a sound tracker have a mean
/// length of 0.025 s, those of a lagging one 0.13 s.
STEADYHAND_PARAMETER LOG_FAULTS_PER_S = 32.0, MOST_LOG_FAULTS = 4.0;
/// Difference of the fault rates, LAGGING minus SOUND, 1/s: what time without faults is evidence of.
STEADYHAND_PARAMETER FAULTS_PER_S = 1.1;
/// White noise beside the one that TrackerMonitor measures: no hand follows the model's curve exactly.
STEADYHAND_PARAMETER MEASUREMENT_NOISE = 0.0035;
/// Errors of measurements closer together than this are alike: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
STEADYHAND_PARAMETER ALIKE_S = 0.015;
/// Share of outliers that TrackerMonitor misses, and their density.
STEADYHAND_PARAMETER OUTLIERS = 0.01, OUTLIER_DENSITY = 0.4;

// motion/: the hypotheses.

/// Between two births of hypotheses, and the range of their durations, standard deviations about the mean.
STEADYHAND_PARAMETER BIRTH_PERIOD_S = 0.03, WIDEST_DURATION = 1.9;
/// Hypotheses of less weight, relative to the best one, are dropped.
STEADYHAND_PARAMETER LEAST_WEIGHT = 1e-3;
/// In so short a time a hand does not turn.
STEADYHAND_PARAMETER SAME_MOVEMENT_S = 0.1;
/// A gesture that began so shortly before the last measurement is not put out: nothing has shown it yet.
STEADYHAND_PARAMETER UNSEEN_S = 0.02;
/// A gesture is not put out before this phase, at 3 % of the amplitude.
STEADYHAND_PARAMETER VISIBLE_PHASE = 0.15;

} // namespace steadyhand::parameters

namespace steadyhand::parameters::strokes {

// Cutting motion into strokes.

/// Window of the speed: a tracker's slow error moves by a centimetre in a tenth of a second.
STEADYHAND_PARAMETER WINDOW_S = 0.1;
/// A stroke is the part of a movement above this share of its peak speed.
STEADYHAND_PARAMETER SPEED_SHARE = 0.25;
STEADYHAND_PARAMETER SLOWEST_M_S = 1e-3;
/// White noise that needs no mean, in smallest strokes. Longer means would bend the hand's path.
STEADYHAND_PARAMETER STILL = 0.15, LONGEST_MEAN_S = 0.2;
/// Without a measurement for longer, the hand may have moved and stopped unseen.
STEADYHAND_PARAMETER LOST_S = 0.1;
/// Time before a stroke in which a hand at rest is looked for: REST_S; before a slow stroke this share of the
/// stroke's own duration, at most LONGEST_REST_S, because a hand that wanders slowly hardly moves where it
/// turns.
STEADYHAND_PARAMETER REST_S = 0.5, REST_SHARE = 0.8, LONGEST_REST_S = 1.5;
/// Strokes shorter than this, of the smallest amplitude, are tremor.
STEADYHAND_PARAMETER SMALLEST_STROKE = 0.06;

// Evidence of a stroke: log likelihood ratio of the gesture against the null model, a hand that goes
// anywhere.

/// Log prior odds of the gesture against none, without a task and with one.
STEADYHAND_PARAMETER LOG_PRIOR_NO_TASK = -5.0, LOG_PRIOR_TASK = 1.0;
/// Width of the directions of a gesture without a task, radians, and the turn that a stroke may still make.
STEADYHAND_PARAMETER DIRECTION = 0.35, LATER_TURN = 0.35;
/// Standard deviation of the direction to a task's end, radians: aim and the tracker's error.
STEADYHAND_PARAMETER TASK_DIRECTION = 0.11;
/// Mean distance from the chord, in its lengths: scale for gestures, and the limit of the null model.
STEADYHAND_PARAMETER BOW = 0.18, LARGEST_BOW = 0.5;
/// Detour = length of the path / distance - 1. Mean for gestures: a share, a tracker's error, m, and its
/// growth, m/s.
STEADYHAND_PARAMETER DETOUR = 0.03, DETOUR_M = 0.01, DETOUR_M_S = 0.003;
/// Share of gestures with a larger detour, because of the tracker, and the ratio of the means.
STEADYHAND_PARAMETER LARGE_DETOUR_SHARE = 0.1, LARGE_DETOUR = 3.0;
/// Scale of the null model's detours, (1 + detour / scale)^-3: the distance may come to nothing.
STEADYHAND_PARAMETER OTHER_DETOUR = 1.7;
/// Motion before the onset: of a hand at rest, that of the tracker's error, m, and of any hand, 1/s.
STEADYHAND_PARAMETER REST_MOTION = 0.07, REST_MOTION_M = 0.002, OTHER_MOTION_PER_S = 1.5;
/// Share of gestures without a rest before them; nats against a gesture whose rest was not tracked.
STEADYHAND_PARAMETER NO_REST_SHARE = 0.001, REST_UNSEEN = 1.5;
/// Standard deviations of the log of length / amplitude, below and above 0: people often reach too far.
STEADYHAND_PARAMETER LOG_SHORTER = 0.15, LOG_LONGER = 0.5;
/// Standard deviation of the log of duration / mean duration, and the share of gestures at any pace.
STEADYHAND_PARAMETER LOG_DURATION = 0.55, ANY_PACE_SHARE = 0.25;
/// Probability that a hand comes back at once after a strike, and that it stays after another gesture.
STEADYHAND_PARAMETER USUAL_ENDING = 0.95;
/// A hand stays that has not come back by TURNED (fractions of the stroke's length) within TURNED_WITHIN (of
/// its duration), or by COMES_BACK within COMES_BACK_WITHIN.
STEADYHAND_PARAMETER TURNED = 0.03, TURNED_WITHIN = 0.5, COMES_BACK = 0.12, COMES_BACK_WITHIN = 0.8;
/// Log of the duration of a strike over its mean, beyond which it is a drag.
STEADYHAND_PARAMETER SLOWER_STRIKE = 0.53;
/// Ranges of the null model: log of 0.05 to 2 amplitudes, and of 0.1 to 5 s.
STEADYHAND_PARAMETER LOG_LENGTHS = 3.7, LOG_DURATIONS = 3.9;
/// Nats against a gesture of several strokes.
STEADYHAND_PARAMETER SEVERAL_STROKES = 0.5;
/// A stroke below this share of its peak speed slows down. It then covers at most FURTHER times as much as a
/// minimum jerk would, except for a share of all.
STEADYHAND_PARAMETER SLOWING_SHARE = 0.85, FURTHER = 2.0, GOES_ON_SHARE = 0.003;
/// Standard deviation of a gesture's start about the task's start.
STEADYHAND_PARAMETER START = 0.12;
/// Log of that normal density at its peak over the null model's: a ball of 1.5 amplitudes.
STEADYHAND_PARAMETER LOG_STARTS = 6.25;
/// Part of the movement that a hand may make before it comes into view, and the log density ratio for it.
STEADYHAND_PARAMETER UNSEEN_PART = 0.45, LOG_UNSEEN_STARTS = 5.85;

} // namespace steadyhand::parameters::strokes

namespace steadyhand::parameters::sessions {

// Both kinds. Values are in amplitudes, speeds in amplitudes / mean duration: a minimum jerk peaks at 1.875.

/// Phase from which on a gesture is at its end, and the phase that a hand has left when it hardly moves.
STEADYHAND_PARAMETER END_PHASE = 0.97, STILL_PHASE = 0.03;
/// A gesture at less than this value has returned.
STEADYHAND_PARAMETER RETURNED = 0.15;
/// A gesture that is lost beyond this value may have ended.
STEADYHAND_PARAMETER NEAR_END = 0.75;

// With a task.

/// Of a start: value, speed (`paper` mode only), and value in standard deviations of the drift at rest.
STEADYHAND_PARAMETER START_VALUE = 0.03, START_SPEED = 0.1, START_DRIFTS = 7.0;
/// Drift at rest: the time over which second differences are taken, and its value until it is measured.
STEADYHAND_PARAMETER DRIFT_S = 0.1, UNKNOWN_DRIFT = 0.02;
/// P(gesture) of a start, and of an abort near the start.
STEADYHAND_PARAMETER START_PROBABILITY = 0.7, ABORT_PROBABILITY = 0.1;
/// From this value on a gesture starts at any probability.
STEADYHAND_PARAMETER HALFWAY = 0.5;
/// From this value on the hand has left the start: the way back is a movement of its own.
STEADYHAND_PARAMETER LEFT_START = 0.25;
/// `paper` mode: near the start, a gesture is aborted after this many mean durations of the first state.
STEADYHAND_PARAMETER ABORT_AFTER = 3.0;
/// The hand has stopped at this P(hold) for this time.
STEADYHAND_PARAMETER STOP_PROBABILITY = 0.7, STOP_S = 0.2;
/// Log odds by strokes that an end before the target needs: hands that do something else stop anywhere.
STEADYHAND_PARAMETER STOP_LOG_ODDS = 9.0;
/// The hand has turned back by this value.
STEADYHAND_PARAMETER TURNED_BACK = 0.08;
/// No gesture starts so far from its start. A hand that stays there for longer is not followed.
STEADYHAND_PARAMETER ELSEWHERE = 0.7, ELSEWHERE_S = 3.0;
/// Distance to the start of a gesture that may start anywhere, m.
STEADYHAND_PARAMETER ANYWHERE_M = 0.1;
/// Distance from the path beyond which the hand has left the task: of a circle and of a straight path.
STEADYHAND_PARAMETER OFF_CIRCLE = 0.3, OFF_STRAIGHT = 1.0;
/// A measurement no older says where the hand is.
STEADYHAND_PARAMETER RECENT_S = 0.1, MISSING_S = 0.05;
/// Strokes along a task: least length of a start, cosine of the greatest angle, and length of a clear
/// direction.
STEADYHAND_PARAMETER SMALLEST_MOVE = 0.02, ALONG = 0.64, LONG_ENOUGH = 0.5;

// Without a task.

/// Lengths of strokes: with a direction; well under way.
STEADYHAND_PARAMETER SHORTEST = 0.12, UNDER_WAY = 0.3;
/// A stroke has a direction from this many standard deviations of the noise on.
STEADYHAND_PARAMETER NOISE_TIMES = 10.0;
/// A stroke whose greatest possible log odds are less is no gesture; after this time it is aborted.
STEADYHAND_PARAMETER HOPELESS = -8.0, HOPELESS_S = 0.1, BARELY_BEGUN = 0.2;
/// Log odds from which on an end is predicted.
STEADYHAND_PARAMETER END_LOG_ODDS = 1.5;
/// Margin of the speed at an end, of the peak, for people who slow down less.
STEADYHAND_PARAMETER SLOWED_LESS = 0.25;
/// Shorter strokes after an end are no gesture.
STEADYHAND_PARAMETER TAIL = 0.25;
/// A hand has returned from its end at this fraction of its greatest distance.
STEADYHAND_PARAMETER HALF_BACK = 0.5;
/// Time before an onset in which the start is looked for, and of the means that suppress noise.
STEADYHAND_PARAMETER BEFORE_ONSET_S = 0.15, MEAN_S = 0.05;

// By HMM.

/// Posterior of a start, an abort and an end, and probability of the last state at an end.
STEADYHAND_PARAMETER BEGINS = 0.9, ABORTED = 0.1, CERTAIN = 0.99, LAST_STATE = 0.5;
/// Cosine between a gesture and its return, and between two gestures of one path: 45 degrees.
STEADYHAND_PARAMETER OPPOSITE = -0.7, SAME_DIRECTION = 0.7;

// Several gestures.

/// Another gesture is shown if it is likelier by this log odds.
STEADYHAND_PARAMETER SWITCH_MARGIN = 2.0;
/// At rest another task is shown if the hand is nearer to it by this ratio.
STEADYHAND_PARAMETER NEARER = 0.8;
/// Motions closer than this, in amplitudes, are of one path.
STEADYHAND_PARAMETER SAME_PATH = 0.1;
/// Nats against a gesture of one finger for each amplitude of a gesture that needs this finger too.
STEADYHAND_PARAMETER PART = 12.0;

} // namespace steadyhand::parameters::sessions

// Two-sided hysteresis: the limit that opens a condition is looser than the one that meets it.
namespace steadyhand::parameters::start {

/// DWELL: a hand has left beyond 30 mm (Ultraleap TouchFree starts a drag there). It dwells within 20 mm: at
/// the 10 mm of the Meta Interaction SDK, a bad tracker shows a hand at rest as moving.
STEADYHAND_PARAMETER STILL_M = 0.020, LEFT_M = 0.030;
/// PINCH: Ultraleap's detector closes at 25 mm and opens at 30 mm.
STEADYHAND_PARAMETER OPENS_AT = 30.0 / 25.0;
/// POINTING_POSE: ratio of the distances index tip to palm and next tip to palm. Open hands and fists have
/// 0.9 to 1.1 (leapjs-playback, Leap-QTM), a pointing hand of average size has 2.1.
STEADYHAND_PARAMETER POINTS_FROM = 1.5, POINTS_TO = 1.3;
/// Least distance index tip to palm, m: in a fist the ratio is noise.
STEADYHAND_PARAMETER EXTENDED_M = 0.07;
/// A slip of a finger this short drops nothing (MRTK #10391).
STEADYHAND_PARAMETER SLIP_S = 0.1;
/// A tracker needs this time to fit a hand that it finds. A pinch this shortly before a dropout is an open
/// hand that leaves the view (wolvic #1467).
STEADYHAND_PARAMETER SETTLES_S = 0.2;
/// Confidence, 0 to 1. In leapjs-playback an open hand that leaves the view reads as a pinch with a median of
/// 0.6 and a least of 0.3; the pinch has 0.97 or more.
STEADYHAND_PARAMETER LEAST_CONFIDENCE = 0.5;

} // namespace steadyhand::parameters::start

namespace steadyhand::parameters::tracker {

/// Period before it is measured: the slowest camera in use.
STEADYHAND_PARAMETER UNKNOWN_PERIOD_S = 1.0 / 30.0;
/// No hand tracker is faster: frames closer together were delayed and arrive in a burst.
STEADYHAND_PARAMETER BURST_S = 1e-3;
/// Loaded trackers often skip one or two frames. Half a period more, because time stamps jitter.
STEADYHAND_PARAMETER DROPOUT_PERIODS = 3.5, LEAST_DROPOUT_S = 0.03;
/// So that the third repeated reading is a freeze.
STEADYHAND_PARAMETER FREEZE_PERIODS = 2.5;
/// Prior rate of jumps and of freezes: recordings of Leap Motion have 0.05 to 0.5 jumps a second.
STEADYHAND_PARAMETER FAULTS_PER_S = 0.3;
/// Standard deviation of a jump per axis: 10 to 60 mm of a lost hand model, 0.3 m to the other hand.
STEADYHAND_PARAMETER JUMP_M = 0.1;
/// Wrong poses of one to ten frames last up to 90 ms. A tracker that stays longer has moved its origin.
STEADYHAND_PARAMETER LONGEST_JUMP_S = 0.09;
/// A jump that is undone within this time was the tracker's. After a longer one the hand may be anywhere.
STEADYHAND_PARAMETER MEMORY_S = 0.4;
/// Share of a jump, and of the speed before it, by which it is undone and the hand stood.
STEADYHAND_PARAMETER UNDONE = 0.5, STOOD = 0.5;
/// Standard deviation of a hand's acceleration within a frame. A 15 cm tap in 0.2 s peaks at 22 m/s^2 (5.77 A
/// / T^2, Flash & Hogan 1985).
STEADYHAND_PARAMETER ACCELERATION_M_S2 = 15.0;
/// Standard deviation of a hand's velocity. The fastest gestures peak at 3 m/s.
STEADYHAND_PARAMETER SPEED_M_S = 1.0;
/// A busy computer delays a frame by this time at most, and then delivers all that waited.
STEADYHAND_PARAMETER MOST_BEHIND_S = 0.06;

} // namespace steadyhand::parameters::tracker
