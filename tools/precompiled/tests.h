// What tests have in common, their helpers as well: these take longer to read than most tests.
#include "core.h"

#include "near.h"
#include "recognition/gesture_events.h"

#include <doctest/doctest.h>

#include <random>
#include <sstream>
