// Output motion of drags with a task, in both modes.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr std::array SOURCES{ MotionSource::SYNTHESISED, MotionSource::MEASURED, MotionSource::AVERAGE,
	MotionSource::ONE_EURO, MotionSource::KALMAN };

constexpr std::array MODES{ MotionMode::PHASE, MotionMode::PAPER };

GestureRecogniser recogniser(MotionMode mode, const std::optional<Task> &task = Task{}) {
	return GestureRecogniser({ { shared_drag_model(), task } }, { mode });
}

using Row = std::array<double, SOURCES.size()>;

Row row_of(const GestureRecogniser &hmm) {
	Row row;
	for (std::size_t i = 0; i < SOURCES.size(); ++i) {
		row[i] = hmm.motion(SOURCES[i]).value_m;
	}
	return row;
}

/// A row every step_ms up to end_s.
std::vector<Row> play(MotionMode mode, const Track &track, double end_s, int step_ms = 1,
		const std::optional<Task> &task = Task{}) {
	GestureRecogniser hmm = recogniser(mode, task);
	std::vector<Row> rows;
	std::size_t next = 0;
	for (int ms = 0; ms <= static_cast<int>(end_s * 1000.0); ms += step_ms) {
		const double t_s = ms / 1000.0;
		while (next < track.frames.size() && track.frames[next].t_s <= t_s) {
			hmm.push(track.frames[next++]);
		}
		hmm.advance(t_s);
		rows.push_back(row_of(hmm));
	}
	return rows;
}

/// A drag with noise of 3 mm and a dropout.
Track shaky_drag() {
	Track track = drag_track({ .onset_s = 0.5, .duration_s = 1.1, .amplitude_m = 0.2 }, 97.0, 2.5);
	std::mt19937_64 random(3);
	std::normal_distribution<double> noise(0.0, 0.003);
	for (HandFrame &frame : track.frames) {
		frame.set(Joint::INDEX, frame.position(Joint::INDEX) + noise(random) * X);
	}
	track.frames.erase(track.frames.begin() + 80, track.frames.begin() + 95);
	return track;
}

/// The track in bursts of four frames, 0.2 ms apart.
Track in_bursts(const Track &track) {
	constexpr std::size_t AT_ONCE = 4;
	Track bursts = track;
	for (std::size_t i = 0; i < track.frames.size(); ++i) {
		const std::size_t within = i % AT_ONCE,
						  last = std::min(i - within + AT_ONCE, track.frames.size()) - 1;
		bursts.frames[i].t_s = track.frames[last].t_s + 2e-4 * static_cast<double>(within);
	}
	return bursts;
}

/// Acceleration of the drag in closed form, m/s^2.
double acceleration_m_s2(const Drag &drag, double t_s) {
	const double s = (t_s - drag.onset_s) / drag.duration_s;
	const double scale = drag.amplitude_m / (drag.duration_s * drag.duration_s);
	return s <= 0.0 || s >= 1.0 ? 0.0 : scale * s * (60.0 + s * (-180.0 + 120.0 * s));
}

double own_m_s2(const GestureRecogniser &recogniser) {
	const Motion motion = recogniser.motion(MotionSource::SYNTHESISED);
	return motion.acceleration_m_s2 - motion.correction_m_s2;
}

} // namespace

TEST_CASE("a clean drag is followed within 4 mm in phase mode") {
	const Drag drag{ .onset_s = 0.5, .duration_s = 1.0, .amplitude_m = 0.2 };
	for (const MotionMode mode : MODES) {
		CAPTURE(static_cast<int>(mode));
		const std::vector<Row> rows = play(mode, drag_track(drag, 110.0, 2.5), 2.4);
		double largest = 0.0, largest_step = 0.0;
		for (std::size_t ms = 0; ms < rows.size(); ++ms) {
			largest = std::max(largest, std::abs(rows[ms][0] - drag.x_m(static_cast<double>(ms) / 1000.0)));
			largest_step = ms > 0 ? std::max(largest_step, std::abs(rows[ms][0] - rows[ms - 1][0])) : 0.0;
		}
		// `paper` mode is fast when it detects the start, at 3 % of the amplitude.
		CHECK(largest < (mode == MotionMode::PAPER ? 0.02 : 0.004));
		CHECK(largest_step < (mode == MotionMode::PAPER ? 0.001 : 0.0006));
		CHECK(rows.back()[0] == near(0.2).epsilon(0.01));
	}
}

TEST_CASE("later frames change no bit of the output") {
	const Track whole = shaky_drag();
	std::mt19937_64 random(4);
	for (const MotionMode mode : MODES) {
		const std::vector<Row> expected = play(mode, whole, 2.4);
		for (int round = 0; round < 20; ++round) {
			const double cut_s = std::uniform_real_distribution<double>(0.0, 2.4)(random);
			Track cut = whole;
			std::erase_if(cut.frames, [&](const HandFrame &frame) { return frame.t_s > cut_s; });
			const std::vector<Row> rows = play(mode, cut, cut_s);
			for (std::size_t ms = 0; ms < rows.size(); ++ms) {
				REQUIRE(rows[ms] == expected[ms]);
			}
		}
	}
}

TEST_CASE("the rate of advance() does not change the motion") {
	const Track shaky = shaky_drag(), lost_half_way = drag_track({}, 97.0, 1.0),
				lost_near_end = drag_track({}, 97.0, 1.26);
	for (const MotionMode mode : MODES) {
		for (const std::optional<Task> &task : { std::optional(Task{}), std::optional<Task>() }) {
			for (const Track &track : { shaky, in_bursts(shaky), lost_half_way, lost_near_end }) {
				const std::vector<Row> fine = play(mode, track, 2.8, 1, task);
				const std::vector<Row> coarse = play(mode, track, 2.8, 8, task);
				for (std::size_t i = 0; i < coarse.size(); ++i) {
					REQUIRE(coarse[i] == fine[8 * i]);
				}
			}
		}
	}
}

TEST_CASE("a repeated or late frame changes no output") {
	for (const std::optional<Task> &task : { std::optional(Task{}), std::optional<Task>() }) {
		GestureRecogniser once = recogniser(MotionMode::PHASE, task),
						  twice = recogniser(MotionMode::PHASE, task);
		for (int i = 0; i < 220; ++i) {
			HandFrame frame;
			frame.t_s = i / 90.0;
			frame.set(Joint::INDEX, (DRAG.x_m(frame.t_s) + 1e-4 * std::sin(777.0 * i)) * X);
			once.push(frame);
			twice.push(frame);
			twice.push(frame);
			HandFrame late = frame;
			late.t_s -= 0.005;
			late.set(Joint::INDEX, 0.3 * Y);
			twice.push(late);
			REQUIRE(row_of(once) == row_of(twice));
			REQUIRE(once.gesture() == twice.gesture());
		}
	}
}

TEST_CASE("the synthesised velocity and acceleration are the value's derivatives") {
	const Track track = drag_track({}, 110.0, 2.0);
	const double h = 1e-5;
	for (const MotionMode mode : MODES) {
		GestureRecogniser hmm = recogniser(mode);
		std::size_t next = 0;
		int compared = 0;
		for (int tick = 0; tick < 200; ++tick) {
			// The derivative exists between two symbols and two frames.
			const double t_s = 0.0041 + 0.01 * tick;
			while (next < track.frames.size() && track.frames[next].t_s <= t_s) {
				hmm.push(track.frames[next++]);
			}
			if (next < track.frames.size() && track.frames[next].t_s < t_s + h) {
				continue;
			}
			hmm.advance(t_s);
			const Motion before = hmm.motion(MotionSource::SYNTHESISED);
			hmm.advance(t_s + h);
			const Motion after = hmm.motion(MotionSource::SYNTHESISED);
			if (before.progress > 0.05 && after.progress < 0.99 && after.velocity_m_s > 0.0) {
				const double mean_m_s = 0.5 * (before.velocity_m_s + after.velocity_m_s);
				CHECK((after.value_m - before.value_m) / h == near(mean_m_s).epsilon(1e-3));
				const double mean_m_s2 = 0.5 * (before.acceleration_m_s2 + after.acceleration_m_s2);
				CHECK(std::abs((after.velocity_m_s - before.velocity_m_s) / h - mean_m_s2) < 0.02);
				++compared;
			}
		}
		CHECK(compared > 50);
	}
}

TEST_CASE("the acceleration without frame corrections follows the hand at 0.5 mm noise") {
	Tremor tremor(0.0005, 5);
	double truth_square = 0.0, off_square = 0.0;
	for (const double duration_s : { 0.6, 0.9, 1.2 }) {
		const Drag drag{ .onset_s = 0.5, .duration_s = duration_s, .amplitude_m = 0.2 };
		Track track = drag_track(drag, 110.0, 2.2);
		GestureRecogniser recogniser({ { shared_drag_model(), Task{} } });
		int ms = 0;
		for (HandFrame &frame : track.frames) {
			frame.set(Joint::INDEX, frame.position(Joint::INDEX) + tremor().x() * X);
			for (; 0.001 * ms < frame.t_s; ++ms) {
				recogniser.advance(0.001 * ms);
				const double truth = acceleration_m_s2(drag, 0.001 * ms);
				truth_square += truth * truth;
				off_square += std::pow(own_m_s2(recogniser) - truth, 2);
			}
			recogniser.advance(frame.t_s);
			const double before = own_m_s2(recogniser);
			recogniser.push(frame);
			CAPTURE(frame.t_s);
			REQUIRE((frame.t_s == 0.0 || std::abs(own_m_s2(recogniser) - before) < 1e-9));
		}
	}
	CHECK(std::sqrt(off_square / truth_square) < 0.7);
}

TEST_CASE("NaN, infinite and huge input leaves every output finite") {
	const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
	for (const MotionMode mode : MODES) {
		GestureRecogniser hmm = recogniser(mode);
		double t_s = 0.0;
		for (const double x_m : { 0.0, nan, 1e9, -1e9, infinity, 1e-9, 0.1, nan, 0.2 }) {
			for (const double t : { t_s, t_s - 1.0, nan, infinity }) {
				HandFrame frame;
				frame.t_s = t;
				frame.set(Joint::INDEX, { x_m, 0.0, 0.0 });
				hmm.push(frame);
				for (const double value_m : row_of(hmm)) {
					CHECK(std::isfinite(value_m));
				}
			}
			t_s += 0.01;
		}
		hmm.advance(t_s + 3600.0);
		hmm.advance(1e300); // is ignored
		CHECK(hmm.time_s() < 1e4);
		hmm.advance(1e12); // does not hang
		CHECK(std::isfinite(hmm.motion(MotionSource::SYNTHESISED).value_m));
	}
	CHECK(row_of(GestureRecogniser({}))[0] == 0.0);
}
