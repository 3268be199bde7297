#pragma once

#include "classifier_streams.h"
#include "overlapping_drags.h"
#include "recogniser_of.h"
#include "recognition/gesture_recogniser.h"
#include "shown_changes.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steadyhand::test {

inline const Eigen::Vector3d X = Eigen::Vector3d::UnitX(), Y = Eigen::Vector3d::UnitY(),
							 Z = Eigen::Vector3d::UnitZ();
inline constexpr double NEVER_S = 1e9;
inline constexpr Drag DRAG{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.2 };

/// One of FOUR_GESTURES has the HMMs of the add-on.
inline std::shared_ptr<const GestureModel> model(
		const char *gesture, const Eigen::Vector3d &axis, bool both_ways) {
	GestureModel trained = drag_model();
	trained.gesture = gesture;
	trained.typical_task.axis = axis;
	if (both_ways) {
		trained.other_axes = { -axis };
	}
	DirectedHmm hmm = std::exchange(trained.recorded_hmms, {}).front();
	if (std::ranges::count(FOUR_GESTURES, gesture) == 0) {
		hmm.gesture = gesture;
		hmm.axis = axis;
		trained.recorded_hmms = { hmm };
	}
	return std::make_shared<const GestureModel>(std::move(trained));
}

inline const std::vector<std::shared_ptr<const GestureModel>> &models() {
	static const std::vector<std::shared_ptr<const GestureModel>> all = {
		model("horizontal_drag", Eigen::Vector3d::UnitX(), true),
		model("vertical_drag", Eigen::Vector3d::UnitY(), true), model("tap", -Eigen::Vector3d::UnitZ(), false)
	};
	return all;
}

/// Peak change in a millisecond of a value that decays critically damped at 50 /s from 0.2 m: 0.2 * 50 / e
/// m/s.
inline constexpr double FASTEST_M_MS = 0.2 * 50.0 / std::numbers::e / 1000.0;

/// Stage of the shown gesture.
inline GestureSession::Stage stage(const GestureRecogniser &recogniser) {
	return recogniser.session() != nullptr ? recogniser.session()->stage() : GestureSession::Stage::IDLE;
}

using EventNames = std::vector<std::string>;
using TestPath = std::function<Eigen::Vector3d(double t_s)>;

/// Events of "horizontal_drag".
inline const EventNames NOTHING{}, STARTS{ "started horizontal_drag" },
		ABORTS{ "started horizontal_drag", "aborted horizontal_drag" },
		ENDS{ "started horizontal_drag", "ended horizontal_drag" };

struct Events {
	EventNames names;             ///< such as "started horizontal_drag"
	double largest_step = 0.0;    ///< largest change of the synthesised value in 1 ms, m
	double last_confidence = 0.0; ///< at the last end
	double last_value_m = 0.0;    ///< synthesised value at the end of the run
	double first_shown_s = 1e9;   ///< time at which a gesture first was active
	double last_ended_s = 0.0;    ///< time of the last end
};

/// A tracker with a dropout from lost_from_s to lost_to_s, and white noise on each axis.
struct TestTracker {
	double lost_from_s = NEVER_S, lost_to_s = NEVER_S;
	double rate_hz = 110.0, noise_m = 1e-4;
};

/// A row of a table: a hand, and the events that it must make.
struct HandRow {
	std::string hand;
	TestPath path;
	double length_s;
	EventNames events;
};

/// White noise on each axis.
class Tremor {
public:
	Tremor(double deviation_m, unsigned seed) : deviation_m_(deviation_m), random_(seed) {}
	Eigen::Vector3d operator()() {
		const double x = noise_(random_), y = noise_(random_), z = noise_(random_);
		return deviation_m_ * Eigen::Vector3d(x, y, z);
	}

private:
	double deviation_m_;
	std::mt19937_64 random_;
	std::normal_distribution<double> noise_;
};

/// The path with a freeze from from_s to to_s. Without an earlier pose it is at 0. During the freeze `seen`
/// is not called.
inline TestPath held(const TestPath &seen, double from_s, double to_s) {
	return [=, shown_m = Eigen::Vector3d(Eigen::Vector3d::Zero())](double t_s) mutable {
		if (t_s < from_s || t_s >= to_s) {
			shown_m = seen(t_s);
		}
		return shown_m;
	};
}

/// The path with a jump by off_m from from_s to to_s.
inline TestPath jumped(const TestPath &seen, double from_s, double to_s, const Eigen::Vector3d &off_m) {
	return [=](double t_s) {
		const bool is_off = t_s >= from_s && t_s < to_s;
		return Eigen::Vector3d(seen(t_s) + (is_off ? 1.0 : 0.0) * off_m);
	};
}

/// The position rounded to multiples of grid_m; 0: not rounded.
inline Eigen::Vector3d rounded(const Eigen::Vector3d &place_m, double grid_m) {
	return grid_m > 0.0 ? Eigen::Vector3d(grid_m * (place_m / grid_m).array().round()) : place_m;
}

/// strokes: each { onset s, duration s, amplitude m }; they may overlap.
inline TestPath along(const Eigen::Vector3d &axis, const std::vector<Drag> &strokes) {
	return [=](double t_s) { return Eigen::Vector3d(x_m(strokes, t_s) * axis); };
}

inline GestureRecogniser without_task() {
	return recogniser_of(models(), std::nullopt);
}

inline GestureRecogniser with_task(const Task &task = {}) {
	return GestureRecogniser({ { models()[0], task } });
}

/// Events of the recogniser for a hand and a tracker.
inline Events watch(GestureRecogniser &recogniser, const TestPath &path, double length_s,
		const TestTracker &tracker = {}) {
	Events events;
	std::mt19937_64 random(5);
	std::normal_distribution<double> noise;
	ShownChanges shown;
	std::string name;
	int frames = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * length_s); ++ms) {
		const double t_s = ms / 1000.0;
		for (; frames / tracker.rate_hz <= t_s; ++frames) {
			const double frame_s = frames / tracker.rate_hz;
			if (frame_s >= tracker.lost_from_s && frame_s < tracker.lost_to_s) {
				continue;
			}
			HandFrame frame;
			frame.t_s = frame_s;
			const double z_m = noise(random), y_m = noise(random), x_m = noise(random);
			const Eigen::Vector3d trembling(x_m, y_m, z_m);
			frame.set(Joint::INDEX, path(frame_s) + tracker.noise_m * trembling);
			recogniser.push(frame);
		}
		recogniser.advance(t_s);
		const GestureChanges changes = shown.next(recogniser);
		const std::string left =
				std::exchange(name, recogniser.gesture() < 0 ? "" : recogniser.session()->model().gesture);
		if (changes.aborted) {
			events.names.push_back("aborted " + left);
		}
		if (recogniser.gesture() >= 0) {
			events.first_shown_s = std::min(events.first_shown_s, t_s);
		}
		if (changes.started) {
			events.names.push_back("started " + name);
		}
		if (changes.ended) {
			events.names.push_back("ended " + name);
			events.last_confidence = recogniser.confidence();
			events.last_ended_s = t_s;
		}
		const double value_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
		events.largest_step = std::max(events.largest_step, std::abs(value_m - events.last_value_m));
		events.last_value_m = value_m;
	}
	return events;
}

inline Events watch(GestureRecogniser &&recogniser, const TestPath &path, double length_s,
		const TestTracker &tracker = {}) {
	return watch(recogniser, path, length_s, tracker);
}

inline Events watch_without_task(const TestPath &path, double length_s, const TestTracker &tracker = {}) {
	return watch(without_task(), path, length_s, tracker);
}

inline Events watch_with_task(const TestPath &path, double length_s, const TestTracker &tracker = {}) {
	return watch(with_task(), path, length_s, tracker);
}

inline EventNames times(int n, const std::string &gesture) {
	EventNames names;
	for (int i = 0; i < n; ++i) {
		names.push_back("started " + gesture);
		names.push_back("ended " + gesture);
	}
	return names;
}

inline std::ptrdiff_t count(const Events &events, std::string_view names) {
	return std::ranges::count_if(
			events.names, [names](const std::string &one) { return one.starts_with(names); });
}

inline std::ptrdiff_t ends(const Events &events) {
	return count(events, "ended");
}

inline bool has_no_end(const Events &events) {
	return ends(events) == 0;
}

} // namespace steadyhand::test

template <> struct doctest::StringMaker<std::vector<std::string>> {
	static String convert(const std::vector<std::string> &names) {
		std::string all;
		for (const std::string &one : names) {
			all += (all.empty() ? "" : ", ") + one;
		}
		return { ("{ " + all + " }").c_str() };
	}
};
