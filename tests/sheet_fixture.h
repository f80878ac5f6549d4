#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/command_fixture.h"

/// `displayfile sheet`, and the contents of its SVG files.
class SheetCommandTest : public Command {
 protected:
  void SetUp() override {
    write("box.obj",
          "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 0 0 30\nv 60 0 30\nv 60 40 30\nv 0 40 30\n"
          "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  }
  /// The path of a layer.
  std::string path_of(const std::string& file, const std::string& layer) {
    const std::string text = read(folder_ / file);
    const std::size_t at = text.find("id=\"" + layer + "-");
    if (at == std::string::npos) return {};
    const std::size_t begin = text.find(" d=\"", at) + 4;
    return text.substr(begin, text.find('"', begin) - begin);
  }
  /// Its coordinates.
  std::vector<double> numbers(const std::string& file, const std::string& layer) {
    std::string path = path_of(file, layer);
    for (char& c : path) c = std::isalpha(static_cast<unsigned char>(c)) && c != 'e' ? ' ' : c;
    std::istringstream in(path);
    std::vector<double> all;
    for (double x = 0.0; in >> x;) all.push_back(x);
    return all;
  }

  struct Text {
    double x, y, size;
    bool centred;
    std::string characters;
    /// As letters of usual faces, on an average, at the least.
    double width() const { return 0.45 * size * static_cast<double>(characters.size()); }
    double left() const { return centred ? x - width() / 2.0 : x; }
    double top() const { return y - 0.72 * size; }
  };
  std::vector<Text> texts(const std::string& file) {
    const std::string text = read(folder_ / file);
    const std::regex element(
        "<text x=\"([^\"]+)\" y=\"([^\"]+)\" font-size=\"([^\"]+)\"( [^>]+)?>([^<]*)<");
    std::vector<Text> all;
    for (std::sregex_iterator it(text.begin(), text.end(), element), end; it != end; ++it) {
      const auto number = [&](std::size_t k) { return std::stod((*it)[k]); };
      all.push_back({number(1), number(2), number(3), (*it)[4].matched, (*it)[5]});
    }
    return all;
  }
  /// True if something of a layer is drawn within the text's rectangle, tested by points along its
  /// lines. Paths of several lines have as many points each.
  bool is_drawn_over(const std::string& file, const std::string& layer, std::size_t points_of_line,
                     const Text& text) {
    const auto all = numbers(file, layer);
    for (std::size_t i = 0; i + 2 < all.size(); i += 2) {
      if ((i / 2 + 1) % points_of_line == 0) continue;
      for (double t = 0.0; t <= 1.0; t += 0.002) {
        const double x = all[i] + t * (all[i + 2] - all[i]);
        const double y = all[i + 1] + t * (all[i + 3] - all[i + 1]);
        if (x > text.left() && x < text.left() + text.width() && y > text.top() && y < text.y) {
          return true;
        }
      }
    }
    return false;
  }
  /// Letters of sections lie apart from each other, from cutting lines and arrows, and from views.
  void expect_marks_apart(const std::string& file) {
    std::vector<Text> marks = texts(file);
    std::erase_if(marks, [](const Text& text) { return !text.centred; });
    ASSERT_FALSE(marks.empty());
    for (const Text& a : marks) {
      EXPECT_FALSE(is_drawn_over(file, "CUTTING", 2, a)) << a.characters;
      EXPECT_FALSE(is_drawn_over(file, "CUTTING_ENDS", 3, a)) << a.characters;
      EXPECT_FALSE(is_drawn_over(file, "HATCH", 2, a)) << a.characters;
      for (const Text& b : marks) {
        const bool meet = a.left() < b.left() + b.width() && b.left() < a.left() + a.width() &&
                          a.top() < b.y && b.top() < a.y;
        EXPECT_TRUE(&a == &b || !meet) << a.characters << " and " << b.characters;
      }
    }
  }
};

/// A side of a path, its ends in order.
using Stroke = std::array<double, 4>;

/// The strokes of an SVG path of M, L and Z.
inline std::vector<Stroke> strokes_of(const std::string& path) {
  std::vector<Stroke> all;
  std::istringstream in(path);
  double x = 0.0, y = 0.0, x0 = 0.0, y0 = 0.0;
  const auto to = [&](double x1, double y1) {
    const bool rises = std::pair(x, y) < std::pair(x1, y1);
    all.push_back(rises ? Stroke{x, y, x1, y1} : Stroke{x1, y1, x, y});
    x = x1;
    y = y1;
  };
  for (char command = 'M'; in >> std::ws && in.peek() != EOF;) {
    if (std::isalpha(in.peek()) != 0) in >> command;
    if (command == 'Z') {
      to(x0, y0);
      continue;
    }
    double x1 = 0.0, y1 = 0.0;
    in >> x1 >> y1;
    if (command == 'L') {
      to(x1, y1);
    } else {
      x = x0 = x1;
      y = y0 = y1;
    }
    command = 'L';
  }
  return all;
}

/// The length along which two strokes overlap.
inline double overlap(const Stroke& a, const Stroke& b) {
  const double length = std::hypot(a[2] - a[0], a[3] - a[1]);
  const double u = (a[2] - a[0]) / length, v = (a[3] - a[1]) / length;
  const auto along = [&](double x, double y) { return (x - a[0]) * u + (y - a[1]) * v; };
  const auto across = [&](double x, double y) { return (x - a[0]) * v - (y - a[1]) * u; };
  if (std::abs(across(b[0], b[1])) > 1e-3 || std::abs(across(b[2], b[3])) > 1e-3) return 0.0;
  const auto [low, high] = std::minmax({along(b[0], b[1]), along(b[2], b[3])});
  return std::min(high, length) - std::max(low, 0.0);
}

/// A plate with a boss on it. The plate's upper face is a polygon with a bridge, or two without.
inline std::string plate_with_boss(bool bridged) {
  std::string text =
      "v -30 -15 0\nv 30 -15 0\nv 30 15 0\nv -30 15 0\nv -30 -15 5\nv 30 -15 5\nv 30 15 5\n"
      "v -30 15 5\nv -10 -10 5\nv 10 -10 5\nv 10 10 5\nv -10 10 5\nv -10 -10 20\n"
      "v 10 -10 20\nv 10 10 20\nv -10 10 20\n"
      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
      "f 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\nf 13 14 15 16\n";
  return text + (bridged ? "f 5 6 7 8 5 9 12 11 10 9\n" : "f 5 6 7 11 10 9\nf 5 9 12 11 7 8\n");
}
