#pragma once

// The headers that most tests include, compiled once for all of them. A test still includes those
// that it uses.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
