#pragma once

#include "scenario.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace steadyhand::matrix {

/// All scenarios, group by group.
class Scenarios {
public:
	Scenarios() {
		add_moves();
		add_paces();
		add_short_tasks();
		add_stops();
		add_halts();
		add_faults();
		add_rests();
		add_other_ends();
	}

	[[nodiscard]] const std::vector<Scenario> &all() const { return all_; }

private:
	static constexpr std::array GESTURES{ Gesture::TAP, Gesture::HORIZONTAL_DRAG };
	static constexpr std::array LENGTHS_M{ 0.02, 0.05, 0.1, 0.15, 0.2, 0.4 };
	static constexpr std::array ALL_NOISES{ NO_NOISE, WHITE_100_UM, ROUNDED, WHITE_500_UM, WHITE_1_MM };

	std::vector<Scenario> all_;

	/// f(gesture, task), of each gesture and length.
	template <class F> static void for_each_task(const auto &lengths_m, F f) {
		for (const Gesture gesture : GESTURES) {
			for (const double length_m : lengths_m) {
				f(gesture, task_of(gesture, length_m));
			}
		}
	}

	/// A duration that people choose, s.
	static double usual_s(Gesture gesture) { return gesture == Gesture::TAP ? 0.4 : 0.9; }

	/// Over 1 % of the way: bounds of 2 % of the way cannot be asked for.
	static bool is_coarse(const Noise &noise, const Task &task) {
		return noise.deviation_m > 0.01 * task.amplitude_m;
	}

	static std::vector<Rate> rates(const std::vector<double> &hz) {
		std::vector<Rate> chosen;
		for (const Rate &rate : RATES) {
			for (const double one_hz : hz) {
				if (rate.hz == one_hz && !rate.in_bursts) {
					chosen.push_back(rate);
				}
			}
		}
		return chosen;
	}

	void add(Scenario scenario) {
		scenario.seed = all_.size() + 1;
		all_.push_back(std::move(scenario));
	}

	void add_moves() {
		for_each_task(LENGTHS_M, [this](Gesture gesture, const Task &task) {
			const Hand hand = reaching(task, usual_s(gesture));
			for (const Rate &rate : RATES) {
				const bool has_few = rate.hz <= 30.0 || rate.in_bursts;
				for (const Noise &noise : ALL_NOISES) {
					const bool is_noisy =
							noise.deviation_m > WHITE_100_UM.deviation_m || noise.rounding_m > 0.0;
					const char *group = is_coarse(noise, task) ? "move, coarse noise"
							: has_few                          ? "move, few frames"
							: is_noisy                         ? "move, noise"
															   : "move";
					add({ group, gesture, task, hand, rate, noise });
				}
			}
		});
	}

	void add_paces() {
		for_each_task(LENGTHS_M, [this](Gesture gesture, const Task &task) {
			for (const Rate &rate : rates({ 60.0, 100.0 })) {
				for (const Noise &noise : { NO_NOISE, WHITE_100_UM }) {
					add({ "quick hand 0.15 s", gesture, task, reaching(task, 0.15), rate, noise });
					add({ "slow hand 4 s", gesture, task, reaching(task, 4.0), rate, noise });
				}
			}
		});
	}

	void add_short_tasks() {
		for_each_task(std::array{ 0.02, 0.05, 0.1 }, [this](Gesture gesture, const Task &task) {
			for (const Approach approach : APPROACHES) {
				for (const double reach_s : { 0.5, 0.8 }) {
					for (const double dwell_s : { 0.0, 0.1, 0.3 }) {
						for (const double press_s : { 0.2, 0.35 }) {
							const Hand hand = pressing_after_reach(task, approach, reach_s, dwell_s, press_s);
							for (const Rate &rate : rates({ 60.0, 100.0, 120.0 })) {
								add({ "short task", gesture, task, hand, rate, NO_NOISE });
								add({ "short task", gesture, task, hand, rate, WHITE_100_UM });
							}
						}
					}
				}
			}
		});
	}

	void add_stops() {
		for_each_task(std::array{ 0.05, 0.2, 0.4 }, [this](Gesture gesture, const Task &task) {
			for (const double duration_s : { 0.3, 0.5 }) {
				for (const Rate &rate : rates({ 30.0, 72.0, 120.0 })) {
					for (const Noise &noise : { NO_NOISE, ROUNDED, WHITE_500_UM }) {
						for (const double share : { 0.25, 0.5, 0.7, 0.75 }) {
							add({ "dead stop", gesture, task, stopping_dead(task, duration_s, share), rate,
									noise });
						}
						for (const double share : { 0.7, 0.75 }) {
							add({ "smooth stop", gesture, task, stopping_short(task, duration_s, share), rate,
									noise });
						}
					}
				}
			}
		});
	}

	void add_halts() {
		for_each_task(std::array{ 0.05, 0.2, 0.4 }, [this](Gesture gesture, const Task &task) {
			for (const double halt_s : { 0.3, 0.6, 1.0 }) {
				for (const Rate &rate : rates({ 30.0, 60.0, 120.0 })) {
					for (const Noise &noise : { NO_NOISE, WHITE_100_UM, WHITE_500_UM }) {
						add({ "halt", gesture, task, halting(task, halt_s), rate, noise });
					}
				}
			}
		});
	}

	void add_faults() {
		for_each_task(LENGTHS_M, [this](Gesture gesture, const Task &task) {
			const Hand hand = reaching(task, usual_s(gesture));
			for (const Rate &rate : rates({ 60.0, 100.0 })) {
				for (const double share : { 0.2, 0.4, 0.7 }) {
					add({ DRIFT.name, gesture, task, hand, rate, WHITE_100_UM, DRIFT, share });
					for (const Fault &fault : PASSING_FAULTS) {
						Scenario scenario{ fault.name, gesture, task, hand, rate, WHITE_100_UM, fault,
							share };
						if (scenario.fault_s() + fault.length_s > hand.to_s) {
							scenario.group = "end hidden by the fault";
						}
						add(std::move(scenario));
					}
				}
			}
		});
	}

	void add_rests() {
		for_each_task(LENGTHS_M, [this](Gesture gesture, const Task &task) {
			for (const Rate &rate : rates({ 30.0, 100.0 })) {
				for (const Noise &noise : ALL_NOISES) {
					const char *group = is_coarse(noise, task) ? "rest, coarse noise" : "rest";
					add({ group, gesture, task, resting(task), rate, noise });
				}
				for (const Fault &fault : PASSING_FAULTS) {
					add({ "rest, fault", gesture, task, resting(task), rate, WHITE_100_UM, fault });
				}
			}
		});
	}

	void add_other_ends() {
		for_each_task(LENGTHS_M, [this](Gesture gesture, const Task &task) {
			for (const Rate &rate : rates({ 60.0, 100.0 })) {
				for (const double pause_s : { 0.0, 0.3 }) {
					add({ "there and back", gesture, task,
							going_there_and_back(task, usual_s(gesture), pause_s), rate, WHITE_100_UM });
				}
				for (const double share : { 1.2, 1.5 }) {
					add({ "past the end", gesture, task, passing_the_end(task, usual_s(gesture), share), rate,
							WHITE_100_UM });
				}
			}
		});
	}
};

} // namespace steadyhand::matrix
