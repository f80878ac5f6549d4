#pragma once

#include <initializer_list>
#include <string_view>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// A limit of magnitudes, and its text in messages.
struct Limit {
  double most;
  const char* text;
};

/// Throws Error, naming the value, if it is not finite or is larger.
void require_within(const Limit& limit, std::initializer_list<double> values, const char* what);
/// The same with kCoordinateLimit.
void require_finite(std::initializer_list<double> values, const char* what);

/// Throws Error for characters that cannot be drawn, or more than kLongestText bytes of them.
void require_characters(std::string_view text);

/// Throws Error for a component outside of [0,1].
void require_colour(const Colour& colour);

}  // namespace displayfile
