#include "minimum_jerk_drag.h"
#include "near.h"
#include "soundness/tracker_standstill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double PERIOD_S = 0.009;
constexpr double RUN_UP_S = 0.4;

/// What a tracker shows, with noise, frame by frame.
class Shown {
public:
	explicit Shown(double noise, unsigned seed = 1) : noise_(noise), random_(seed) {}

	/// Whether it stands where it was.
	bool show(double x) {
		const double t_s = now_s();
		const double seen = x + noise_ * normal_(random_);
		if (frames_++ == 0) {
			standstill_.start(t_s, seen);
			return false;
		}
		const bool stands = standstill_.stands(t_s, seen, noise_);
		if (!stands) {
			standstill_.tell(t_s, seen, noise_);
		}
		return stands;
	}
	/// A hand that has moved at that speed for RUN_UP_S.
	void run_up(double speed_per_s) {
		while (now_s() < RUN_UP_S) {
			show(speed_per_s * now_s());
		}
	}
	/// When the next frame is due.
	[[nodiscard]] double now_s() const { return PERIOD_S * frames_; }

private:
	double noise_;
	std::mt19937_64 random_;
	std::normal_distribution<double> normal_;
	TrackerStandstill standstill_;
	int frames_ = 0;
};

} // namespace

TEST_CASE("a tracker that trembles where it lost a hand on its way stands still from the first frame on") {
	for (const double tremble : { 0.0, 0.0001, 0.0005 }) { // 0.1 mm of 20 cm
		for (const double speed_per_s : { 1.2, 2.0, -2.0 }) {
			CAPTURE(tremble);
			CAPTURE(speed_per_s);
			Shown shown(tremble);
			shown.run_up(speed_per_s);
			const double lost = speed_per_s * (shown.now_s() - PERIOD_S);
			for (int i = 0; i < 20; ++i) {
				CHECK(shown.show(lost));
			}
			CHECK_FALSE(shown.show(lost + 0.2 * speed_per_s));
		}
	}
}

TEST_CASE("a hand that stops dead at the end of its way has arrived, however fast it came") {
	for (const double end : { 0.96, 1.0, 1.04 }) {
		CAPTURE(end);
		Shown shown(0.0005);
		shown.run_up(end / RUN_UP_S);
		for (int i = 0; i < 30; ++i) {
			CHECK_FALSE(shown.show(end));
		}
	}
}

TEST_CASE("a hand that stops does not stand still, not even one that brakes within 50 ms") {
	for (const double braking_s : { 0.05, 0.1, 0.2 }) {
		for (const double speed_per_s : { 0.5, 1.0, 2.0 }) {
			CAPTURE(braking_s);
			CAPTURE(speed_per_s);
			Shown shown(0.0005);
			shown.run_up(speed_per_s);
			const double from_s = shown.now_s();
			while (shown.now_s() < from_s + braking_s + 0.3) {
				const double u_s = std::min(shown.now_s() - from_s, braking_s);
				CHECK_FALSE(
						shown.show(speed_per_s * (from_s + u_s - u_s * u_s / (2.0 * braking_s)))); // steadily
			}
		}
	}
}

TEST_CASE("drags of half a second and more, before trackers of any noise, stand in less than one of a "
		  "hundred frames") {
	for (const double noise : { 0.0, 0.0005, 0.002, 0.005, 0.01, 0.025 }) {
		for (const double duration_s : { 0.5, 0.8, 1.5, 3.0 }) {
			CAPTURE(noise);
			CAPTURE(duration_s);
			const test::Drag drag{ .onset_s = 0.3, .duration_s = duration_s, .amplitude_m = 1.0 };
			int stood = 0, frames = 0;
			for (unsigned seed = 0; seed < 40; ++seed) {
				Shown shown(noise, seed);
				for (; shown.now_s() < duration_s + 0.6; ++frames) {
					stood += shown.show(drag.x_m(shown.now_s())) ? 1 : 0;
				}
			}
			CHECK(stood <= frames / 100);
		}
	}
}

TEST_CASE("what stands for half a second is a hand that was stopped, and one frame elsewhere is no "
		  "standstill") {
	Shown stopped(0.0005);
	stopped.run_up(1.5);
	const double at = 1.5 * (stopped.now_s() - PERIOD_S);
	int stood = 0;
	for (int i = 0; i < 200; ++i) {
		stood += stopped.show(at) ? 1 : 0;
	}
	CHECK(stood * PERIOD_S == test::near(0.5).epsilon(0.03));

	for (const double elsewhere : { -0.03, 0.015, 0.03, 0.3 }) {
		CAPTURE(elsewhere);
		Shown shown(0.0005);
		shown.run_up(1.0);
		shown.show(shown.now_s() + elsewhere);
		for (int i = 0; i < 20; ++i) {
			CHECK_FALSE(shown.show(shown.now_s()));
		}
	}
}

TEST_CASE("a tracker that is soon back where the hand rests, in a jump or not, does not stand still there") {
	constexpr double WANDERS_S = 0.1;
	for (const double rest : { 0.0, 1.0 }) {
		for (const double away : { -0.4, 0.2, 0.4 }) {
			for (const bool jumps_back : { false, true }) {
				CAPTURE(rest);
				CAPTURE(away);
				CAPTURE(jumps_back);
				Shown shown(0.0005);
				while (shown.now_s() < RUN_UP_S) {
					shown.show(rest);
				}
				const double from_s = shown.now_s();
				while (shown.now_s() < from_s + WANDERS_S) {
					const double part = (shown.now_s() - from_s) / WANDERS_S;
					const double bump = std::sin(std::numbers::pi * part);
					shown.show(rest + away * (jumps_back ? part : bump * bump));
				}
				for (int i = 0; i < 30; ++i) {
					CHECK_FALSE(shown.show(rest));
				}
			}
		}
	}
}

TEST_CASE("a tracker that jumps back and stays says nothing more of the velocity") {
	Shown shown(0.0005);
	shown.run_up(1.5);
	for (int i = 0; i < 30; ++i) {
		CHECK_FALSE(shown.show(0.3)); // half of the way back
	}
}
