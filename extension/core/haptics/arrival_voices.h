#pragma once

#include "haptics/voice.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// The voices of arrivals: as many as a set has effects, of which each sounds until it has faded. Where all
/// of them sound, one more is let pass.
class ArrivalVoices {
public:
	/// All effects of the set with this trigger, ARRIVAL or START; first, motion: as of ArrivalVoice.
	void start(const EffectSet &effects, Trigger trigger, const Arrival &arrival, std::int32_t first,
			const MotionPoint &motion, const Stretch &stretch) {
		for (std::size_t i = 0; i < effects.count; ++i) {
			if (effects.effects[i].trigger != trigger) {
				continue;
			}
			const auto free = std::find_if(voices_.begin(), voices_.end(),
					[](const ArrivalVoice &voice) { return !voice.is_active(); });
			if (free != voices_.end()) {
				free->start(effects.effects[i], effects.generation, arrival, first, motion, stretch);
				active_ += free->is_active() ? 1 : 0;
			}
		}
	}

	[[nodiscard]] bool are_active() const { return active_ > 0; }

	/// As of ArrivalVoice, of all that are active.
	[[nodiscard]] bool look_at(const Stretch &stretch) {
		bool is_smooth = true;
		for_active([&](ArrivalVoice &voice) { is_smooth = voice.look_at(stretch) && is_smooth; });
		return is_smooth;
	}
	void begin(const Stretch &stretch) {
		for_active([&](ArrivalVoice &voice) { voice.begin(stretch); });
	}
	void cut(double share) {
		for_active([&](ArrivalVoice &voice) { voice.cut(share); });
	}
	/// mix_of(channels): where a voice of these channels is added.
	template <class MixOf> void add_run(const Stretch &stretch, std::size_t run, MixOf mix_of) {
		for_active([&](ArrivalVoice &voice) {
			voice.add_run(stretch, run, mix_of(voice.channels()));
			active_ -= voice.is_active() ? 0 : 1;
		});
	}

	/// Of the effects' tables that a voice may read; newest: those in use.
	[[nodiscard]] std::uint64_t oldest_generation(std::uint64_t newest) const {
		std::uint64_t oldest = newest;
		for (const ArrivalVoice &voice : voices_) {
			if (voice.is_active()) {
				oldest = std::min(oldest, voice.generation());
			}
		}
		return oldest;
	}

private:
	std::array<ArrivalVoice, EffectSet::MOST> voices_;
	std::size_t active_ = 0;

	template <class Act> void for_active(Act act) {
		if (active_ > 0) {
			for (ArrivalVoice &voice : voices_) {
				if (voice.is_active()) {
					act(voice);
				}
			}
		}
	}
};

} // namespace steadyhand
