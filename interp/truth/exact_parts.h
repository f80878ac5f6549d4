#pragma once

#include <vector>

#include "interp/truth/whole_numbers.h"

namespace displayfile {

// Parts of a line in exact arithmetic, for the truth of lines alone.

/// over / under, under > 0.
struct Fraction {
  Integer over = 0, under = 1;
};

/// The divisor is not 0, and may be negative.
Fraction quotient(Integer dividend, Integer divisor);
bool operator<(const Fraction& a, const Fraction& b);

/// The part of a line between two parameters, from < to. Its ends do not matter, only its length.
struct ExactPart {
  Fraction from, to;
};

/// In order, and disjoint: no two have an end in common.
using ExactParts = std::vector<ExactPart>;

ExactPart whole_line();  ///< from 0 to 1
/// Appends the intersection of two parts, if it has a length, to parts in any order.
void add_common(const ExactPart& a, const ExactPart& b, std::vector<ExactPart>& to);

/// The union of parts in any order.
ExactParts united(std::vector<ExactPart> parts);
/// The intersection.
ExactParts common(const ExactParts& a, const ExactParts& b);
/// The complement in the whole line; the parts are within it.
ExactParts rest(const ExactParts& parts);

}  // namespace displayfile
