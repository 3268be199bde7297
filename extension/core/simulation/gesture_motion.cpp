#include "simulation/gesture_motion.h"

#include "simulation/hand_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace steadyhand {

namespace {

constexpr double SETTLED = 0.02;           // of the amplitude: tolerance of the end
constexpr double INITIAL_DEVIATION = 0.01; // of the amplitude: error of the start
constexpr double PLACE_DEVIATION_M = 0.02;
// Share of the variance of log durations; 7..20 % remain from trial to trial.
constexpr double BETWEEN_PEOPLE = 0.75;
constexpr double CORRECTION_MIN_S = 0.1; // Novak, Miller, Houk 2002
constexpr double CORRECTION_MAX_S = 0.25;
constexpr double SEVERITY_AT_REST = 0.2; // at the unstable position, before the movement

HandFrame carry_hand(const HandPath &path, double progress) {
	HandFrame frame = pointing_hand(path.hand_scale);
	shift_hand(frame,
			path.task.start_m + progress * path.task.amplitude_m * path.task.axis +
					(1.0 - progress) * path.start_error_m + progress * path.end_error_m +
					4.0 * progress * (1.0 - progress) * path.bow_m);
	return frame;
}

/// Unit vector to the centre of a circle in the xy plane that begins along `axis` and turns counterclockwise.
Eigen::Vector3d inward(const Eigen::Vector3d &axis) {
	return { -axis.y(), axis.x(), 0.0 };
}

HandFrame circle_hand(const HandPath &path, double progress) {
	const double angle_rad = progress * path.task.amplitude_m / path.task.radius_m;
	HandFrame frame = pointing_hand(path.hand_scale);
	shift_hand(frame,
			path.task.start_m +
					path.task.radius_m *
							(std::sin(angle_rad) * path.task.axis +
									(1.0 - std::cos(angle_rad)) * inward(path.task.axis)) +
					(1.0 - progress) * path.start_error_m + progress * path.end_error_m +
					4.0 * progress * (1.0 - progress) * path.bow_m);
	return frame;
}

HandFrame open_fingers(const HandPath &path, double progress) {
	HandFrame frame = pinching_hand(path.hand_scale, path.task.radius_m + progress * path.task.amplitude_m);
	shift_hand(
			frame, path.task.start_m + (1.0 - progress) * path.start_error_m + progress * path.end_error_m);
	return frame;
}

constexpr double CIRCLE_RADIUS_M = 0.06;

// Amplitudes: the paper's tasks. Durations: the paper's Discussion. Zoom ends at three times its first
// radius. A tap passes the surface by 1..4 cm, because nothing stops it. The circle begins at its top.
constexpr std::array<SimulatedGesture, 5> GESTURES = { {
		{ "horizontal_drag", { 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, 0.20, 0.0, 1.26, 0.25, 0.0, 0.0,
				carry_hand },
		{ "vertical_drag", { 0.0, 1.0, 0.0 }, { 0.0, -1.0, 0.0 }, 0.20, 0.0, 1.26, 0.25, 0.0, 0.0,
				carry_hand },
		{ "tap", { 0.0, 0.0, -1.0 }, { 0.0, -1.0, 0.0 }, 0.15, 0.0, 0.35, 0.15, 0.01, 0.04, carry_hand },
		{ "zoom", {}, {}, 0.03, 0.015, 0.88, 0.12, 0.0, 0.0, open_fingers },
		{ "circle", { -1.0, 0.0, 0.0 }, {}, 2.0 * std::numbers::pi *CIRCLE_RADIUS_M, CIRCLE_RADIUS_M, 1.4,
				0.25, 0.0, 0.0, circle_hand, true },
} };

Eigen::Vector3d random_vector(double deviation, Random &r_random) {
	const double x = r_random.normal(0.0, deviation);
	const double y = r_random.normal(0.0, deviation);
	const double z = r_random.normal(0.0, deviation);
	return { x, y, z };
}

/// The part of a vector across the axis.
Eigen::Vector3d sideways(const Eigen::Vector3d &vector, const Eigen::Vector3d &axis) {
	return vector - axis * axis.dot(vector);
}

/// Log-normal with the gesture's mean and standard deviation.
double draw_duration_s(const SimulatedGesture &gesture, const Subject &subject, Random &r_random) {
	const double relative = gesture.duration_deviation_s / gesture.duration_mean_s;
	const double log_variance = std::log1p(relative * relative);
	const double tempo =
			std::sqrt(BETWEEN_PEOPLE) * subject.tempo + std::sqrt(1.0 - BETWEEN_PEOPLE) * r_random.normal();
	return subject.pace * gesture.duration_mean_s *
			std::exp(std::sqrt(log_variance) * tempo - 0.5 * log_variance);
}

/// A primary movement and up to two corrections, from `initial` to the intended end.
std::vector<Submovement> aimed_submovements(
		const Subject &subject, double initial, double duration_s, double bend, Random &r_random) {
	const double length = r_random.normal(subject.amplitude_gain, subject.amplitude_deviation) - initial;
	std::vector<Submovement> parts = { { 0.0, duration_s, length, bend } };
	int corrections = 0;
	for (int i = 0; i < 2; ++i) {
		corrections += r_random.chance(0.5 * subject.corrections_mean) ? 1 : 0;
	}
	double missing = 0.0;
	if (corrections > 0) {
		parts[0].amplitude *= r_random.normal(subject.primary_gain, subject.primary_gain_deviation);
		missing = length - parts[0].amplitude;
	}
	double start_s = duration_s * r_random.uniform(0.8, 1.05);
	for (; corrections > 0; --corrections) {
		const double correction_s =
				std::min(r_random.uniform(CORRECTION_MIN_S, CORRECTION_MAX_S), 0.5 * duration_s);
		const double amplitude = corrections > 1 ? missing * r_random.uniform(0.6, 1.2) : missing;
		parts.push_back({ start_s, correction_s, amplitude, 0.0 });
		missing -= amplitude;
		start_s += correction_s * r_random.uniform(0.8, 1.2);
	}
	return parts;
}

/// A movement past the task's end, hardly slower there, and the return.
std::vector<Submovement> striking_submovements(
		const SimulatedGesture &gesture, double initial, double duration_s, double bend, Random &r_random) {
	const double through =
			r_random.uniform(gesture.through_min_m, gesture.through_max_m) / gesture.amplitude_m;
	const double length = 1.0 + through - initial;
	const double turn_s = duration_s * r_random.uniform(0.95, 1.1);
	const double back_s = duration_s * r_random.uniform(0.9, 1.4);
	return { { 0.0, duration_s, length, bend },
		{ turn_s, back_s, -length * r_random.uniform(0.6, 1.0), 0.0 } };
}

} // namespace

std::span<const SimulatedGesture> simulated_gestures() {
	return GESTURES;
}

const SimulatedGesture *find_simulated_gesture(std::string_view name) {
	const auto *const found = std::find_if(GESTURES.begin(), GESTURES.end(),
			[name](const SimulatedGesture &gesture) { return gesture.name == name; });
	return found == GESTURES.end() ? nullptr : found;
}

double possible_pace(std::string_view gesture, const Eigen::Vector3d &axis, double pace) {
	const SimulatedGesture *const found = find_simulated_gesture(gesture);
	const bool is_strike = found != nullptr && found->through_max_m > 0.0;
	return is_strike && axis.y() < -std::numbers::sqrt2 / 2.0 ? std::min(pace, 1.0) : pace;
}

Eigen::Vector3d hand_place_m(HandPosition position) {
	// A head-mounted camera tracks best at 10 to 25 cm. Farther and lower it looks along the finger.
	return position == HandPosition::STABLE ? Eigen::Vector3d(0.0, -0.08, -0.20)
											: Eigen::Vector3d(0.0, -0.15, -0.45);
}

GestureTask draw_task(const SimulatedGesture &gesture, HandPosition position, Random &r_random) {
	GestureTask task;
	const bool has_other = gesture.other_axis != std::array<double, 3>{};
	const bool is_other = has_other && r_random.chance(0.5);
	task.axis = Eigen::Vector3d((is_other ? gesture.other_axis : gesture.axis).data());
	task.amplitude_m = gesture.amplitude_m;
	task.radius_m = gesture.radius_m;
	// The middle of the path is at the hand's mean position.
	const bool is_circle = task.radius_m > 0.0 && !task.axis.isZero(0.0);
	const Eigen::Vector3d middle_m = is_circle ? Eigen::Vector3d(task.radius_m * inward(task.axis))
											   : Eigen::Vector3d(0.5 * task.amplitude_m * task.axis);
	task.start_m = hand_place_m(position) + random_vector(PLACE_DEVIATION_M, r_random) - middle_m;
	return task;
}

Progress make_progress(
		const SimulatedGesture &gesture, const Subject &subject, double duration_s, Random &r_random) {
	const double initial = r_random.normal(0.0, INITIAL_DEVIATION);
	const double bend =
			bend_for_peak(r_random.normal(subject.peak_fraction, subject.peak_fraction_deviation));
	std::vector<Submovement> parts = gesture.through_max_m > 0.0
			? striking_submovements(gesture, initial, duration_s, bend, r_random)
			: aimed_submovements(subject, initial, duration_s, bend, r_random);
	std::vector<Hesitation> hesitations;
	if (r_random.chance(subject.hesitation_chance)) {
		hesitations.push_back(
				{ duration_s * r_random.uniform(0.2, 0.6), duration_s * r_random.uniform(0.1, 0.25) });
	}
	const Progress progress(initial, std::move(parts), std::move(hesitations));
	return progress.stretched(duration_s / task_end_s(gesture, progress));
}

double task_end_s(const SimulatedGesture &gesture, const Progress &progress) {
	return gesture.through_max_m > 0.0 ? progress.crossing_s(1.0) : progress.settling_s(SETTLED);
}

TrueMotion make_gesture_motion(const SimulatedGesture &gesture, const GestureTask &task,
		HandPosition position, const Subject &subject, double duration_s, Random &r_random) {
	const double drawn_s = draw_duration_s(gesture, subject, r_random);
	const double gesture_s =
			std::clamp(duration_s > 0.0 ? duration_s : drawn_s, GESTURE_MIN_S, GESTURE_MAX_S);
	const Progress progress = make_progress(gesture, subject, gesture_s, r_random);

	HandPath path;
	path.task = task;
	path.hand_scale = subject.hand_scale;
	path.start_error_m = sideways(random_vector(subject.aim_deviation_m, r_random), task.axis);
	path.end_error_m = sideways(random_vector(subject.aim_deviation_m, r_random), task.axis);
	const double bow = r_random.normal(subject.bow, subject.bow_deviation);
	path.bow_m = sideways(random_vector(1.0, r_random), task.axis).normalized() * task.amplitude_m * bow;
	// Shared, because std::function copies its members.
	const auto involuntary = std::make_shared<const InvoluntaryMotion>(subject, r_random);

	TrueMotion motion;
	motion.start_s = subject.rest_before_s + r_random.uniform(0.0, 0.2);
	motion.end_s = motion.start_s + gesture_s;
	motion.span_s = std::max(motion.end_s, motion.start_s + progress.duration_s()) + subject.rest_after_s;
	motion.hand = [place = gesture.place, path, progress, involuntary, start_s = motion.start_s](double t_s) {
		HandFrame frame = place(path, progress.at(t_s - start_s));
		involuntary->apply(t_s, frame);
		frame.t_s = t_s;
		return frame;
	};
	motion.severity = [position, progress, start_s = motion.start_s](double t_s) {
		// Range and self-occlusion grow along the path.
		const double share = std::clamp(progress.at(t_s - start_s), 0.0, 1.0);
		return position == HandPosition::STABLE ? 0.0 : SEVERITY_AT_REST + (1.0 - SEVERITY_AT_REST) * share;
	};
	return motion;
}

} // namespace steadyhand
