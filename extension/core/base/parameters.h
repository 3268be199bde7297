#pragma once

// Every tuning number of the motion core, with its unit, its source and what it stands for. Lengths without a
// unit are in amplitudes: 1 is the way from a task's start to its end.

namespace steadyhand::parameters {

// The hand.

/// Standard deviation of the log duration of a gesture about the model's mean: a scene may ask for a quick or
/// a slow one.
inline constexpr double LOG_DURATION_SPREAD = 0.6;
/// Random walk of the log duration, per square root of a second: hands change their pace on the way.
inline constexpr double PACE_WALK = 0.1;
/// Gestures that a hand at rest at a start begins, per s.
inline constexpr double ONSETS_PER_S = 4.0;
/// Standard deviation of where gestures begin, about the task's start.
inline constexpr double START_SPREAD = 0.07;
/// Share of the minimum-jerk curve (Flash & Hogan 1985) in a movement, beside the model's own curve.
inline constexpr double SHAPE_MEAN = 0.36, SHAPE_SPREAD = 0.33;
/// Standard deviation of the relative error of the endpoint.
inline constexpr double GAIN_SPREAD = 0.041;
/// The same without a task, which says how far to go.
inline constexpr double OPEN_GAIN_SPREAD = 0.12;
/// Deviation of a hand from the model's curve: critically damped noise, standard deviation and rate.
inline constexpr double DEVIATION = 0.07, DEVIATION_RATE_PER_S = 4.6;
/// A hand that holds still: standard deviation of its velocity, per s, and the rate of that. Tremor, sway,
/// and a tracker's slow error.
inline constexpr double HOLD_SPEED = 0.12, HOLD_RATE_PER_S = 9.0;
/// The same of a hand that does something else: m/s, as it has nothing to do with the task.
inline constexpr double FREE_SPEED_M_S = 0.44, FREE_RATE_PER_S = 6.0;

// Switches between modes, per s.

inline constexpr double GESTURE_TO_FREE_PER_S = 0.02;
inline constexpr double GESTURE_TO_HOLD_PER_S = 0.3;
inline constexpr double FREE_TO_HOLD_PER_S = 2.0;
inline constexpr double HOLD_TO_FREE_PER_S = 0.3;

// The tracker.

/// Share of the time in which trackers lag, how fast that is forgotten, and what is left of it in a gesture
/// whatever the frames say: trackers begin to lag at any time.
inline constexpr double LAGGING_SHARE = 0.35, LAGGING_SWITCH_PER_S = 0.2, LAGGING_AT_LEAST = 0.03;
/// Lag at the end of a long way: mean and standard deviation, s. It builds up over LAG_SETTLING_S.
inline constexpr double LAG_S = 0.09, LAG_SPREAD_S = 0.035, LAG_SETTLING_S = 0.4;
/// Latency of a lagging tracker that has had a fault, beside that lag, s.
inline constexpr double FAULTY_LATENCY_S = 0.03;
/// Error of a lagging tracker: critically damped noise; standard deviation at the start, what it has more at
/// the end of the way, and rate.
inline constexpr double LAGGING_ERROR = 0.02, LAGGING_ERROR_ON_WAY = 0.06, LAGGING_ERROR_RATE_PER_S = 8.0;
/// Dropouts and freezes, and jumps as they begin, of a lagging tracker against those of a sound one, as the
/// logarithm of their rates' ratio.
inline constexpr double LOG_FAULTS = 1.8, LOG_JUMPS = 0.4;
/// Added per s while a fault lasts, and the most that one fault counts: faults of a sound tracker last
/// 0.025 s in the mean, those of a lagging one 0.13 s.
inline constexpr double LOG_FAULTS_PER_S = 32.0, MOST_LOG_FAULTS = 4.0;
/// By how many faults per s a lagging tracker has more.
inline constexpr double FAULTS_PER_S = 1.1;
/// White noise that any measurement has beside what TrackerMonitor measures: the model's curve is no hand's.
inline constexpr double MEASUREMENT_NOISE = 0.0035;
/// Errors of measurements closer together than this are alike: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
inline constexpr double ALIKE_S = 0.015;
/// Measurements that are wrong though TrackerMonitor takes them for right, and the density of those.
inline constexpr double OUTLIERS = 0.01, OUTLIER_DENSITY = 0.4;

// The hypotheses.

/// Between one birth of hypotheses and the next, s.
inline constexpr double BIRTH_PERIOD_S = 0.03;
/// Least weight beside the best one's.
inline constexpr double LEAST_WEIGHT = 1e-3;
/// A gesture that began so shortly before the last measurement has not been seen: it is not put out, because
/// nothing moves on a mere chance. s.
inline constexpr double UNSEEN_S = 0.02;
/// One that has not come as far does not show: 3 % of the way.
inline constexpr double VISIBLE_PHASE = 0.15;

} // namespace steadyhand::parameters
