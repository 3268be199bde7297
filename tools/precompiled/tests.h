#include "core.h"

#include <doctest/doctest.h>

#include <random>
#include <sstream>
