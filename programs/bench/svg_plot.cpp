#include "programs/bench/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace displayfile::bench {

namespace {

// Pixels.
constexpr double kLeft = 66.0, kRight = 16.0, kTop = 30.0, kBottom = 48.0;
constexpr double kMost = 1e300;

struct Range {
  double low = kMost, high = 0.0;
  void include(double v) {
    if (!(v > 0.0) || !std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

/// One logarithmic axis: values and the pixels that they stand at.
class LogAxis {
 public:
  LogAxis(Range range, double from, double to) : from_(from), to_(to) {
    if (range.high <= 0.0) range = {1.0, 10.0};
    low_ = std::log10(range.low);
    high_ = std::log10(range.high);
    const double margin = std::max(0.06 * (high_ - low_), 0.08);
    low_ -= margin;
    high_ += margin;
  }
  double place(double value) const {
    return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_);
  }
  /// Powers of ten, no more than fit, with 2 and 5 times them where there are few; over less than
  /// a decade, round numbers.
  std::vector<double> ticks() const {
    return high_ - low_ < 0.9 ? round_numbers() : powers_of_ten();
  }

 private:
  std::vector<double> powers_of_ten() const {
    const auto within = [&](double exponent) { return exponent >= low_ && exponent <= high_; };
    std::vector<double> values;
    const double decades = high_ - low_;
    const int step = std::max(1, static_cast<int>(std::ceil(decades / 8.0)));
    for (int e = static_cast<int>(std::floor(low_)); e <= static_cast<int>(std::ceil(high_)); ++e) {
      const bool on_step = ((e % step) + step) % step == 0;
      for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor != 1.0 && decades > 2.2) continue;
        if (on_step && within(e + std::log10(factor))) values.push_back(factor * std::pow(10.0, e));
      }
    }
    return values;
  }
  std::vector<double> round_numbers() const {
    const double low = std::pow(10.0, low_), high = std::pow(10.0, high_);
    double step = std::pow(10.0, std::floor(std::log10(high - low)));
    if ((high - low) / step > 5.0) step *= 2.0;
    if ((high - low) / step < 2.5) step /= 4.0;
    std::vector<double> values;
    for (double k = std::ceil(low / step); k * step <= high; ++k) values.push_back(k * step);
    return values;
  }

  double from_, to_, low_, high_;
};

std::string tick_label(double value) {
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  if (value >= 0.00999 && value < 99999.0) return fmt::format("{:g}", value);
  const double factor = value / std::pow(10.0, exponent);
  if (std::abs(factor - 1.0) > 1e-6) return fmt::format("{:g}", value);
  return fmt::format("10<tspan dy='-5' font-size='8'>{}</tspan>", exponent);
}

std::string axes(const Plot& plot, const LogAxis& x, const LogAxis& y, double y_bottom) {
  const double bottom = plot.height - kBottom;
  const double width = plot.width - kLeft - kRight;
  std::string text = fmt::format(
      "<rect x='{}' y='{}' width='{}' height='{}' fill='#fff' stroke='#888'/>\n"
      "<text x='{}' y='18' text-anchor='middle' font-weight='bold'>{}</text>\n"
      "<text x='{}' y='{}' text-anchor='middle'>{}</text>\n"
      "<text transform='translate(14 {}) rotate(-90)' text-anchor='middle'>{}</text>\n",
      kLeft, kTop, width, bottom - kTop, kLeft + width / 2.0, escaped(plot.title),
      kLeft + width / 2.0, plot.height - 10.0, escaped(plot.x_label), (kTop + bottom) / 2.0,
      escaped(plot.y_label));
  for (const double value : x.ticks()) {
    text += fmt::format(
        "<path d='M{0:.1f} {1}V{2}' stroke='#e4e4e4'/>"
        "<text x='{0:.1f}' y='{3}' text-anchor='middle'>{4}</text>\n",
        x.place(value), kTop, bottom, bottom + 16.0, tick_label(value));
  }
  for (const double value : y.ticks()) {
    text += fmt::format(
        "<path d='M{0} {1:.1f}H{2}' stroke='#e4e4e4'/>"
        "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5}</text>\n",
        kLeft, y.place(value), kLeft + width, kLeft - 6.0, y.place(value) + 4.0, tick_label(value));
  }
  if (!plot.zero_line) return text;
  return text + fmt::format(
                    "<rect x='{0}' y='{1}' width='{2}' height='{3}' fill='#eef6ee' stroke='#888'/>"
                    "<text x='{4}' y='{5}' text-anchor='end'>0</text>\n",
                    kLeft, y_bottom + 3.0, width, bottom - y_bottom - 3.0, kLeft - 6.0,
                    bottom - plot.zero_band / 2.0 + 5.0);
}

/// From each point of the front to the right, and down to the next.
std::string staircase(const Plot& plot, const LogAxis& x, const auto& place_y) {
  const std::vector<PlotPoint>& front = plot.front;
  if (front.empty()) return "";
  std::string path = fmt::format("M{:.1f} {}", x.place(front.front().x), kTop);
  for (const PlotPoint& p : front) {
    path += fmt::format("H{:.1f}V{:.1f}", x.place(p.x), place_y(p.y));
  }
  path += fmt::format("H{}", plot.width - kRight);
  return fmt::format(
      "<path d='{}' fill='none' stroke='#aaa' stroke-width='2' "
      "stroke-dasharray='5 3'/>\n",
      path);
}

std::string with_title(const std::string& svg_text, const std::string& title) {
  if (title.empty()) return svg_text;
  return "<g><title>" + escaped(title) + "</title>" + svg_text + "</g>";
}

std::string drawn(const Curve& curve, const LogAxis& x, const auto& place_y) {
  std::string path, marks;
  for (const PlotPoint& p : curve.points) {
    const double px = x.place(p.x), py = place_y(p);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', px, py);
    if (p.x_spread) {
      marks += fmt::format("<path d='M{:.1f} {:.1f}H{:.1f}' stroke='{}' stroke-width='0.8'/>",
                           x.place(p.x_spread->first), py, x.place(p.x_spread->second),
                           curve.mark.colour);
    }
    marks += with_title(marker(curve.mark, px, py), p.title) + '\n';
  }
  if (!curve.joined) return marks;
  return fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.3'/>\n", path,
                     curve.mark.colour) +
         marks;
}

/// A rectangle that something is written or marked in.
struct Taken {
  double left, right, top, bottom;
  bool meets(const Taken& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

constexpr double kLetter = 6.3, kLine = 13.0;  // of a label, about
double width_of(const std::string& label) { return kLetter * static_cast<double>(label.size()); }

/// Where the labelled points of the band of zeros stand: in the first row from the top whose marks
/// and labels leave room, in order along the axis.
class ZeroRows {
 public:
  ZeroRows(std::span<const Curve> curves, const LogAxis& x, double top, double bottom) {
    std::vector<const PlotPoint*> points;
    for (const Curve& curve : curves) {
      for (const PlotPoint& p : curve.points) {
        if (!(p.y > 0.0) && !p.label.empty()) points.push_back(&p);
      }
    }
    std::ranges::stable_sort(points, {}, &PlotPoint::x);
    std::vector<double> ends(
        std::max<std::size_t>(1, static_cast<std::size_t>((bottom - top) / kLine)), -kMost);
    for (const PlotPoint* p : points) {
      const double px = x.place(p->x);
      auto row = std::ranges::find_if(ends, [&](double end) { return end < px - 8.0; });
      if (row == ends.end()) row = std::ranges::min_element(ends);
      *row = px + 10.0 + width_of(p->label);
      place_[p] = top + kLine * (static_cast<double>(row - ends.begin()) + 0.5);
    }
  }
  std::optional<double> place(const PlotPoint& p) const {
    const auto found = place_.find(&p);
    return found == place_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<const PlotPoint*, double> place_;
};

/// Beside the points, where nothing else is.
std::string labels(const Plot& plot, std::span<const Curve> curves, const LogAxis& x,
                   const auto& place_y) {
  struct Label {
    double x, y;
    const PlotPoint* point;
    const Mark* mark;
  };
  std::vector<Label> all;
  std::vector<Taken> taken;
  for (const Curve& curve : curves) {
    for (const PlotPoint& p : curve.points) {
      const double px = x.place(p.x), py = place_y(p);
      taken.push_back({px - 4.0, px + 4.0, py - 4.0, py + 4.0});
      if (!p.label.empty()) all.push_back({px, py, &p, &curve.mark});
    }
  }
  std::string text;
  for (const Label& label : all) {
    const double width = width_of(label.point->label);
    const bool zero = !(label.point->y > 0.0);
    const auto at = [&](double dx, double dy) {
      const double left = dx < 0.0 ? label.x + dx - width : label.x + dx;
      return Taken{left, left + width, label.y + dy - 6.0, label.y + dy + 6.0};
    };
    std::vector<Taken> places{at(8.0, 0.0)};
    for (double dy = 0.0; dy <= 60.0 && !zero; dy += 6.0) {
      for (const double sign : {-1.0, 1.0}) {
        places.push_back(at(8.0, sign * dy));
        places.push_back(at(-8.0, sign * dy));
      }
    }
    const auto is_free = [&](const Taken& place) {
      return place.right < plot.width - kRight && place.left > kLeft &&
             std::ranges::none_of(taken, [&](const Taken& t) { return t.meets(place); });
    };
    auto place = std::ranges::find_if(places, is_free);
    if (place == places.end()) place = places.begin();
    taken.push_back(*place);
    const double y = 0.5 * (place->top + place->bottom);
    if (std::abs(y - label.y) > 8.0) {
      text += fmt::format("<path d='M{:.1f} {:.1f}L{:.1f} {:.1f}' stroke='{}' stroke-width='0.6'/>",
                          label.x, label.y, place->left > label.x ? place->left : place->right, y,
                          label.mark->colour);
    }
    text += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}'>{}</text>\n", place->left, y + 4.0,
                        label.mark->colour, escaped(label.point->label));
  }
  return text;
}

std::string notes(const Plot& plot) {
  if (plot.notes.empty()) return "";
  std::size_t longest = 0;
  for (const auto& [mark, words] : plot.notes) longest = std::max(longest, words.size());
  const double width = kLetter * static_cast<double>(longest) + 28.0;
  const double left = plot.width - kRight - width - 6.0;
  std::string text = fmt::format(
      "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='#fff' stroke='#ccc'/>\n",
      left, kTop + 6.0, width, kLine * static_cast<double>(plot.notes.size()) + 8.0);
  double y = kTop + 6.0 + kLine;
  for (const auto& [mark, words] : plot.notes) {
    if (mark) text += marker(*mark, left + 11.0, y - 3.0);
    text += fmt::format("<text x='{:.1f}' y='{:.1f}'>{}</text>\n", left + 22.0, y + 1.0,
                        escaped(words));
    y += kLine;
  }
  return text;
}

/// Red by the logarithm of the percentage, from 0.01 to 100.
std::string heat_colour(double percent) {
  if (percent < 0.0) return "#ddd";
  if (percent == 0.0) return "#e3f4e3";
  const double t = std::clamp((std::log10(percent) + 2.0) / 4.0, 0.0, 1.0);
  const auto mix = [&](double a, double b) {
    return static_cast<int>(std::lround(a + t * (b - a)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(255, 165), mix(243, 15), mix(205, 21));
}

std::string heat_label(double percent) {
  if (percent <= 0.0) return "";
  if (percent < 0.095) return "<.1";
  return percent < 9.95 ? fmt::format("{:.1f}", percent) : fmt::format("{:.0f}", percent);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      case '\'': safe += "&#39;"; break;
      default: safe += c;
    }
  }
  return safe;
}

std::string marker(const Mark& mark, double x, double y) {
  const std::string fill = mark.filled ? mark.colour : "#fff";
  const auto path = [&](const char* shape) {
    return fmt::format("<path d='M{:.1f} {:.1f}{}' fill='{}' stroke='{}' stroke-width='1.4'/>", x,
                       y, shape, fill, mark.colour);
  };
  switch (mark.shape % 8) {
    case 0:
      return fmt::format(
          "<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}' stroke='{}' stroke-width='1.4'/>", x, y,
          fill, mark.colour);
    case 1: return path("m-3.5 -3.5h7v7h-7z");
    case 2: return path("m0 -5l5 5l-5 5l-5 -5z");
    case 3: return path("m0 -5l4.5 8h-9z");
    case 4: return path("m0 5l4.5 -8h-9z");
    case 5: return path("m-4 -4l8 8m0 -8l-8 8");
    case 6: return path("m-5 0h10m-5 -5v10");
    default: break;
  }
  return path("m-2 -5h4v10h-4z");
}

std::string marker_in_text(const Mark& mark) {
  return "<svg width='14' height='14' class='mark'>" + marker(mark, 7.0, 7.0) + "</svg>";
}

namespace {

std::string inside(const Plot& plot, std::span<const Curve> curves) {
  Range xs, ys;
  for (const Curve& curve : curves) {
    for (const PlotPoint& p : curve.points) {
      xs.include(p.x);
      ys.include(p.y);
      if (p.x_spread) {
        xs.include(p.x_spread->first);
        xs.include(p.x_spread->second);
      }
    }
  }
  if (plot.x_range) xs = {plot.x_range->first, plot.x_range->second};
  if (plot.y_range) ys = {plot.y_range->first, plot.y_range->second};
  const double bottom = plot.height - kBottom;
  const double y_bottom = plot.zero_line ? bottom - plot.zero_band : bottom;
  const LogAxis x(xs, kLeft, plot.width - kRight), y(ys, y_bottom, kTop);
  const double middle_of_zeros = bottom - plot.zero_band / 2.0 + 1.0;
  const ZeroRows rows(curves, x, y_bottom + 6.0, bottom - 3.0);
  const auto place_on_axis = [&](double value) {
    return value > 0.0 ? y.place(value) : middle_of_zeros;
  };
  std::string text = axes(plot, x, y, y_bottom) + staircase(plot, x, place_on_axis);
  for (const Curve& curve : curves) {
    // In the band of zeros, precisions beside each other: a method's times are often the same.
    const double aside = curve.joined ? 0.0 : 8.0 * (curve.mark.shape % 5 - 2);
    text += drawn(curve, x, [&](const PlotPoint& p) {
      return rows.place(p).value_or(place_on_axis(p.y) + (p.y > 0.0 ? 0.0 : aside));
    });
  }
  text += labels(plot, curves, x,
                 [&](const PlotPoint& p) { return rows.place(p).value_or(place_on_axis(p.y)); });
  return text + notes(plot);
}

}  // namespace

std::string svg(const Plot& plot, std::span<const Curve> curves) {
  return fmt::format(
      "<svg class='plot' width='{0}' height='{1}' viewBox='0 0 {0} {1}' role='img'>\n{2}</svg>\n",
      plot.width, plot.height, inside(plot, curves));
}

std::string svg_file(const Plot& plot, std::span<const Curve> curves) {
  return fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
      "font-family='sans-serif' font-size='11'>\n<rect width='{0}' height='{1}' fill='#fff'/>\n"
      "{2}</svg>\n",
      plot.width, plot.height, inside(plot, curves));
}

std::string svg(const HeatMap& map) {
  constexpr double kCellWidth = 23.0, kCellHeight = 14.0, kNames = 178.0, kHeads = 172.0;
  const auto at = [](std::size_t i, double step) { return static_cast<double>(i) * step; };
  std::string text;
  for (std::size_t c = 0; c < map.columns.size(); ++c) {
    text += fmt::format("<text transform='translate({:.1f} {}) rotate(-90)'>{}</text>\n",
                        kNames + at(c, kCellWidth) + kCellWidth / 2.0 + 4.0, kHeads - 5.0,
                        escaped(map.columns[c]));
  }
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const double y = kHeads + at(r, kCellHeight);
    text += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>\n", kNames - 5.0,
                        y + 11.0, escaped(map.rows[r]));
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const std::size_t i = r * map.columns.size() + c;
      const double x = kNames + at(c, kCellWidth);
      std::string cell = fmt::format(
          "<rect x='{:.1f}' y='{:.1f}' width='{}' height='{}' fill='{}' stroke='#fff'/>", x, y,
          kCellWidth, kCellHeight, heat_colour(map.percent[i]));
      if (const std::string label = heat_label(map.percent[i]); !label.empty()) {
        cell += fmt::format(
            "<text x='{:.1f}' y='{:.1f}' text-anchor='middle' font-size='9' fill='{}'>{}</text>",
            x + kCellWidth / 2.0, y + 10.5, map.percent[i] > 8.0 ? "#fff" : "#222", escaped(label));
      }
      text += with_title(cell, map.titles[i]) + '\n';
    }
  }
  const double width = kNames + at(map.columns.size(), kCellWidth) + 10.0;
  const double height = kHeads + at(map.rows.size(), kCellHeight) + 6.0;
  return fmt::format(
      "<svg class='plot' width='{0:.0f}' height='{1:.0f}' viewBox='0 0 {0:.0f} {1:.0f}' "
      "role='img'>\n{2}</svg>\n",
      width, height, text);
}

}  // namespace displayfile::bench
