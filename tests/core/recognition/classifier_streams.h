#pragma once

#include "gesture/classifier_file.h"
#include "recognition/gesture_spotter.h"
#include "signal/minimum_jerk.h"

#include <cmath>
#include <string>
#include <vector>

namespace steadyhand::test {

inline const std::vector<std::string> FOUR_GESTURES{ "horizontal_drag", "vertical_drag", "tap", "zoom" };

/// These gestures of a model.
inline std::vector<GestureHmms> hmms_of(
		const std::shared_ptr<const ClassifierModel> &model, const std::vector<std::string> &gestures) {
	std::vector<GestureHmms> hmms;
	for (const std::string &gesture : gestures) {
		hmms.push_back({ gesture, { model, &model->gestures } });
	}
	return hmms;
}

inline GestureClassifier four_gestures() {
	return { own_classifier(), hmms_of(own_classifier(), FOUR_GESTURES) };
}

/// An index tip that rests, makes a minimum-jerk movement, and rests.
struct Reach {
	Eigen::Vector3d from_m = Eigen::Vector3d(-0.1, 0.1, -0.3);
	Eigen::Vector3d displacement_m = Eigen::Vector3d(0.2, 0.0, 0.0);
	double start_s = 1.0; ///< onset after the first frame
	double duration_s = 0.9, length_s = 3.0, rate_hz = 97.0;
	/// Time of the first frame. With this time and rate no frame coincides with an instant of the symbol
	/// clock or the end of a window, where rounding would decide the order.
	double clock_s = 0.003;
};

inline std::vector<HandFrame> frames_of(const Reach &reach) {
	std::vector<HandFrame> frames;
	for (int i = 0; i < static_cast<int>(reach.length_s * reach.rate_hz); ++i) {
		const double t_s = i / reach.rate_hz;
		HandFrame frame;
		frame.t_s = reach.clock_s + t_s;
		const double path = minimum_jerk((t_s - reach.start_s) / reach.duration_s).value;
		frame.set(Joint::INDEX, reach.from_m + path * reach.displacement_m);
		frames.push_back(frame);
	}
	return frames;
}

struct Spotted {
	GestureSpotter::Event event;
	std::string gesture;
	double t_s;
	GestureCandidate candidate;
};

inline std::vector<Spotted> spot(GestureSpotter &r_spotter, const std::vector<HandFrame> &frames) {
	std::vector<Spotted> spotted;
	for (const HandFrame &frame : frames) {
		if (r_spotter.push(frame) != GestureSpotter::Event::NONE) {
			spotted.push_back({ r_spotter.event(), r_spotter.gesture(), frame.t_s, r_spotter.candidate() });
		}
	}
	return spotted;
}

inline std::vector<Spotted> spot(const std::vector<HandFrame> &frames) {
	GestureSpotter spotter(four_gestures());
	return spot(spotter, frames);
}

} // namespace steadyhand::test
