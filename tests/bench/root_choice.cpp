#include "tests/bench/root_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace displayfile::bench {

namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// What a row of the figure shows.
struct Quantity {
  std::string_view title;
  double RootCost::*value;
};
constexpr std::array kQuantities = {Quantity{"comparisons a polygon", &RootCost::comparisons},
                                    Quantity{"pieces a polygon", &RootCost::pieces}};

constexpr double kWidth = 200.0, kHeight = 150.0;  // of a panel
constexpr double kLeft = 62.0, kTop = 62.0;        // before the first panel
constexpr double kGap = 26.0, kGapBelow = 34.0;    // between panels
constexpr std::array kColours = {"#D55E00", "#0072B2",
                                 "#009E73"};  // told apart by the colour-blind

/// Where a value lies between the ends of a logarithmic axis, 0 to 1.
double along(const Range& range, double value) {
  return std::log(value / range.low) / std::log(range.high / range.low);
}

/// Widened to whole steps of 1, 2, 5, 10, ..., so that both ends have ticks.
Range widened(const Range& range) {
  const auto step = [](double x, bool up) {
    const double ten = std::pow(10.0, std::floor(std::log10(x)));
    double best = up ? 10.0 * ten : ten;
    for (const double s : {2.0, 5.0}) {
      if (up && s * ten >= x) best = std::min(best, s * ten);
      if (!up && s * ten <= x) best = std::max(best, s * ten);
    }
    return up && ten >= x ? ten : best;
  };
  Range wide{step(range.low, false), step(range.high, true)};
  if (wide.low == wide.high) wide.high = 2.0 * wide.low;
  return wide;
}

/// Powers of ten, and 2 and 5 times them where there are few of those.
std::vector<double> ticks(const Range& range) {
  std::vector<double> values;
  const bool fine = range.high / range.low < 200.0;
  for (double ten = std::pow(10.0, std::floor(std::log10(range.low))); ten <= range.high * 1.001;
       ten *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double value = step * ten;
      const bool inside = value >= range.low * 0.999 && value <= range.high * 1.001;
      if (inside && (step == 1.0 || fine)) values.push_back(value);
    }
  }
  return values;
}

std::string label(double value) {
  if (value >= 1e4)
    return fmt::format("10<tspan dy='-4' font-size='8'>{:.0f}</tspan>", std::log10(value));
  return fmt::format("{:g}", value);
}

std::string marker(RootChoice root, double x, double y, std::string_view colour) {
  switch (root) {
    case RootChoice::last:
      return fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='{}'/>\n", x, y, colour);
    case RootChoice::sample:
      return fmt::format("<rect x='{:.1f}' y='{:.1f}' width='5' height='5' fill='{}'/>\n", x - 2.5,
                         y - 2.5, colour);
    case RootChoice::free: break;
  }
  return fmt::format("<path d='M{:.1f} {:.1f}l4 4l-4 4l-4 -4z' fill='{}'/>\n", x, y - 4.0, colour);
}

struct Panel {
  double x, y;  ///< of its lower left corner, y down
  Range sizes, values;

  double place_x(double n) const { return x + kWidth * along(sizes, n); }
  double place_y(double value) const { return y - kHeight * along(values, value); }
};

std::string axes(const Panel& panel) {
  std::string svg =
      fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='#777'/>\n",
                  panel.x, panel.y - kHeight, kWidth, kHeight);
  for (const double n : ticks(panel.sizes)) {
    if (std::abs(std::log10(n) - std::round(std::log10(n))) > 1e-6) continue;
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n",
                       panel.place_x(n), panel.y + 14.0, label(n));
  }
  for (const double value : ticks(panel.values)) {
    svg += fmt::format(
        "<path d='M{:.1f} {:.1f}h{}' stroke='#ddd'/>\n"
        "<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{}</text>\n",
        panel.x, panel.place_y(value), kWidth, panel.x - 5.0, panel.place_y(value) + 3.5,
        label(value));
  }
  return svg;
}

std::string curve(const Panel& panel, std::span<const RootCost* const> costs,
                  const Quantity& quantity, std::string_view colour) {
  std::string path, markers;
  for (const RootCost* cost : costs) {
    const double x = panel.place_x(static_cast<double>(cost->polygons));
    const double y = panel.place_y(cost->*quantity.value);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
    markers += marker(cost->root, x, y, colour);
  }
  return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'/>\n{}", path, colour,
                     markers);
}

std::vector<std::string> scenes_of(const std::vector<RootCost>& costs) {
  std::vector<std::string> scenes;
  for (const RootCost& cost : costs) {
    if (std::ranges::find(scenes, cost.scene) == scenes.end()) scenes.push_back(cost.scene);
  }
  return scenes;
}

}  // namespace

std::string_view name_of(RootChoice root) {
  switch (root) {
    case RootChoice::last: return "last";
    case RootChoice::sample: return "sample";
    case RootChoice::free: break;
  }
  return "free";
}

RootCost root_cost(const DeviceScene& scene, RootChoice root, int threads) {
  SortOptions options;
  options.root = root;
  options.threads = threads;
  const SortedPieces sorted = sort_hidden_surfaces(scene.items(), HiddenMethod::bsp, options);
  const auto n = static_cast<double>(scene.size());
  return {scene.name,
          root,
          scene.size(),
          static_cast<double>(sorted.pieces.size()) / n,
          static_cast<double>(sorted.comparisons) / n,
          sorted.depth};
}

std::string csv(const std::vector<RootCost>& costs) {
  std::string text = "scene,root,polygons,pieces_per_polygon,comparisons_per_polygon,depth\n";
  for (const RootCost& c : costs) {
    text += fmt::format("{},{},{},{:.4f},{:.2f},{}\n", c.scene, name_of(c.root), c.polygons,
                        c.pieces, c.comparisons, c.depth);
  }
  return text;
}

std::string figure(const std::vector<RootCost>& costs) {
  const std::vector<std::string> scenes = scenes_of(costs);
  Range sizes;
  for (const RootCost& cost : costs) sizes.include(static_cast<double>(cost.polygons));
  sizes = widened(sizes);
  std::string svg;
  for (std::size_t row = 0; row < kQuantities.size(); ++row) {
    Range values;
    for (const RootCost& cost : costs) values.include(cost.*kQuantities[row].value);
    const double y = kTop + kHeight + static_cast<double>(row) * (kHeight + kGapBelow);
    svg += fmt::format(
        "<text transform='translate(14 {:.1f}) rotate(-90)' text-anchor='middle'>"
        "{}</text>\n",
        y - kHeight / 2.0, kQuantities[row].title);
    for (std::size_t column = 0; column < scenes.size(); ++column) {
      const double x = kLeft + static_cast<double>(column) * (kWidth + kGap + kLeft / 3.0);
      const Panel panel{x, y, sizes, widened(values)};
      svg += axes(panel);
      if (row == 0) {
        svg += fmt::format(
            "<text x='{:.1f}' y='{:.1f}' text-anchor='middle' font-weight='bold'>"
            "{}</text>\n",
            x + kWidth / 2.0, kTop - 8.0, scenes[column]);
      }
      for (std::size_t r = 0; r < kRootChoices.size(); ++r) {
        std::vector<const RootCost*> line;
        for (const RootCost& cost : costs) {
          if (cost.scene == scenes[column] && cost.root == kRootChoices[r]) line.push_back(&cost);
        }
        svg += curve(panel, line, kQuantities[row], kColours[r]);
      }
    }
  }
  for (std::size_t r = 0; r < kRootChoices.size(); ++r) {
    const double x = kLeft + 8.0 + 110.0 * static_cast<double>(r);
    svg += marker(kRootChoices[r], x, 20.0, kColours[r]);
    svg += fmt::format("<text x='{:.1f}' y='24'>{}</text>\n", x + 10.0, name_of(kRootChoices[r]));
  }
  const double width = kLeft + static_cast<double>(scenes.size()) * (kWidth + kGap + kLeft / 3.0);
  const double height =
      kTop + static_cast<double>(kQuantities.size()) * (kHeight + kGapBelow) + 10.0;
  svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>polygons</text>\n",
                     width / 2.0, height - 6.0);
  return fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0:.0f}' height='{1:.0f}' "
      "viewBox='0 0 {0:.0f} {1:.0f}' font-family='sans-serif' font-size='11'>\n"
      "<rect width='100%' height='100%' fill='white'/>\n{2}</svg>\n",
      width, height, svg);
}

}  // namespace displayfile::bench
