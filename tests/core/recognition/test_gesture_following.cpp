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
	return { { shared_drag_model() }, task, mode };
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

/// Largest change of the synthesised velocity within a step, m/s, for fast drags and returns. r_off_m:
/// largest difference between the change of the value and the integral of the velocity.
double largest_velocity_step(MotionMode mode, double step_s, double &r_off_m) {
	GestureRecogniser hmm = recogniser(mode);
	const std::vector<Drag> strokes{ { 0.5, 0.35, 0.2 }, { 1.0, 0.35, -0.2 }, { 2.0, 1.6, 0.2 } };
	double largest = 0.0;
	Motion before;
	int frames = 0;
	for (int step = 1; step * step_s < 4.0; ++step) {
		const double t_s = step * step_s;
		for (; frames / 60.0 <= t_s; ++frames) {
			HandFrame frame;
			frame.t_s = frames / 60.0;
			frame.set(Joint::INDEX, x_m(strokes, frame.t_s) * X);
			hmm.push(frame);
		}
		hmm.advance(t_s);
		const Motion now = hmm.motion(MotionSource::SYNTHESISED);
		largest = std::max(largest, std::abs(now.velocity_m_s - before.velocity_m_s));
		const double goes_on_m = 0.5 * step_s * (before.velocity_m_s + now.velocity_m_s);
		r_off_m = std::max(r_off_m, std::abs(now.value_m - before.value_m - goes_on_m));
		before = now;
	}
	return largest;
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

TEST_CASE("phase mode does not depend on the HMM or the states' durations") {
	const Track track = shaky_drag();
	const auto rows_of = [&](const GestureModel &model) {
		GestureRecogniser hmm({ std::make_shared<const GestureModel>(model) }, Task{}, MotionMode::PHASE);
		std::vector<Row> rows;
		for (const HandFrame &frame : track.frames) {
			hmm.push(frame);
			rows.push_back(row_of(hmm));
		}
		return rows;
	};
	const std::vector<Row> own = rows_of(drag_model());
	GestureModel other = drag_model();
	other.hmm.log_b.rowwise().reverseInPlace();
	other.hmm.log_a.setConstant(-std::log(static_cast<double>(other.hmm.states())));
	for (PrimitiveMotionElement &element : other.elements) {
		element.duration_mean_s *= 3.0;
		element.duration_deviation_s *= 3.0;
		element.deviation *= 3.0;
	}
	CHECK(rows_of(other) == own);
	other.duration_mean_s *= 3.0;
	CHECK(rows_of(other) != own);
}

TEST_CASE("value and velocity of the motion do not step") {
	for (const MotionMode mode : MODES) {
		CAPTURE(static_cast<int>(mode));
		double off_m = 0.0, finely_off_m = 0.0;
		const double in_a_ms = largest_velocity_step(mode, 1e-3, off_m);
		CHECK(largest_velocity_step(mode, 1e-4, finely_off_m) < 0.2 * in_a_ms);
		CHECK(finely_off_m < 1e-5);
	}
}

TEST_CASE("a hand that rests or twitches by 15 mm makes no gesture") {
	for (const MotionMode mode : MODES) {
		CHECK(std::abs(play(mode, drag_track({ .onset_s = 1e9 }, 110.0, 5.0), 5.0).back()[0]) < 0.001);
		GestureRecogniser hmm = recogniser(mode);
		const Drag twitch{ .onset_s = 0.5, .duration_s = 0.2, .amplitude_m = 0.015 };
		for (const HandFrame &frame : drag_track(twitch, 110.0, 4.0).frames) {
			hmm.push(frame);
		}
		CHECK(hmm.gesture() == -1);
		CHECK(hmm.motion(MotionSource::SYNTHESISED).value_m < 0.016);
	}
}

TEST_CASE("ten drags in a row end ten times") {
	std::vector<Drag> strokes;
	for (int i = 0; i < 10; ++i) {
		strokes.push_back({ 3.0 * i + 0.3, 1.0, 0.2 });
		strokes.push_back({ 3.0 * i + 1.8, 1.0, -0.2 });
	}
	for (const MotionMode mode : MODES) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser hmm = recogniser(mode);
		CHECK(ends(watch(hmm, along(X, strokes), 30.0, 1e9, 1e9, 200.0, 0.0)) == 10);
	}
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
		hmm.advance(1e12); // and does not hang
		CHECK(std::isfinite(hmm.motion(MotionSource::SYNTHESISED).value_m));
	}
	CHECK(row_of(GestureRecogniser({}, std::nullopt, MotionMode::PHASE))[0] == 0.0);
}
