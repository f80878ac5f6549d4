#include "interp/truth/exact_parts.h"

#include <algorithm>
#include <utility>

namespace displayfile {

Fraction quotient(Integer dividend, Integer divisor) {
  if (divisor < 0) {
    dividend = -dividend;
    divisor = -divisor;
  }
  return {std::move(dividend), std::move(divisor)};
}

bool operator<(const Fraction& a, const Fraction& b) { return a.over * b.under < b.over * a.under; }

ExactPart whole_line() { return {{0, 1}, {1, 1}}; }

void add_common(const ExactPart& a, const ExactPart& b, std::vector<ExactPart>& to) {
  const Fraction& from = std::max(a.from, b.from);
  const Fraction& until = std::min(a.to, b.to);
  if (from < until) to.push_back({from, until});
}

ExactParts united(std::vector<ExactPart> parts) {
  std::ranges::sort(parts, [](const ExactPart& a, const ExactPart& b) { return a.from < b.from; });
  ExactParts all;
  for (ExactPart& part : parts) {
    if (all.empty() || all.back().to < part.from) {
      all.push_back(std::move(part));
    } else if (all.back().to < part.to) {
      all.back().to = std::move(part.to);
    }
  }
  return all;
}

ExactParts common(const ExactParts& a, const ExactParts& b) {
  ExactParts both;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    add_common(a[i], b[j], both);
    ++(a[i].to < b[j].to ? i : j);
  }
  return both;
}

ExactParts rest(const ExactParts& parts) {
  ExactParts between;
  ExactPart gap = whole_line();
  for (const ExactPart& part : parts) {
    add_common({gap.from, part.from}, whole_line(), between);
    gap.from = part.to;
  }
  add_common(gap, whole_line(), between);
  return between;
}

}  // namespace displayfile
