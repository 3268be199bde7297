#include "gesture/trainer.h"
#include "minimum_jerk_drag.h"

#include <doctest/doctest.h>

#include <vector>

using namespace steadyhand;

TEST_CASE("training stops on request at any point") {
	const std::vector<TrainingRecording> drags = test::drag_recordings();
	TrainingOptions options;
	int told = 0;
	options.progress = [&](double) { return ++told > 0; };
	REQUIRE(train("drag", "index_along_axis", drags, options).ok());
	const int all = told;
	for (int last = 1; last <= all; ++last) {
		CAPTURE(last);
		told = 0;
		options.progress = [&](double) { return ++told < last; };
		CHECK(train("drag", "index_along_axis", drags, options).error() == "drag: training was stopped");
		CHECK(told == last);
	}
	CHECK(all > 10);
}
