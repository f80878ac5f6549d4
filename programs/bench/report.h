#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "programs/bench/bench_scene.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/viewing.h"

namespace displayfile::bench {

/// What is measured together: a scene, a method at a precision, a number of threads.
struct CellKey {
  std::string scene;  ///< BenchScene::id
  std::string method, precision;
  int threads = 1;

  bool operator==(const CellKey&) const = default;
  std::string contender() const { return precision.empty() ? method : method + ", " + precision; }
};

/// What a method of lines found, and how wrong it is. Lengths are in units of the picture.
struct LineFigures {
  std::size_t lines = 0;   ///< of the scene; a side that polygons share is one
  std::size_t pieces = 0;  ///< that the method says are seen
  double length = 0.0;     ///< of all lines, seen or not
  double missing = 0.0, extra = 0.0;
};

/// What was measured.
struct Cell {
  CellKey key;
  bool exact = false;                ///< claims that no pixel is wrong
  std::string skipped;               ///< why nothing was measured; else empty
  std::optional<LineFigures> lines;  ///< of a method of lines, which has no pixels and no depths
  std::int64_t wrong_pixels = 0;
  /// Absolute, over the pixels where the depths of the picture and of the truth are both finite;
  /// the view volume is 1 deep.
  double largest_depth_error = 0.0, mean_depth_error = 0.0;
  std::optional<double> fragments;  ///< pieces a polygon, of a sort or the map; of gl2ps a triangle
  std::optional<std::int64_t> bytes;  ///< most held at a time
  std::uint64_t exact_calls = 0;      ///< of the predicates' exact stage, for one picture
  Spread time{};                      ///< of a picture from the display file, in reference times
  std::optional<Spread> again;        ///< of the same picture again, in reference times
};

/// A scene as it was measured.
struct SceneRow {
  BenchScene scene;
  std::size_t polygons = 0;  ///< in the display file
  /// The reference's time here, over its time on the first scene of the same name; not for hard
  /// cases.
  std::optional<Spread> growth;
  std::vector<Cell> cells;
  /// What methods of lines have, in times of kLineReference (programs/bench/line_measure.h); of the
  /// scenes that differ in the picture's size alone the first has them. Their growth is that of
  /// this reference.
  std::vector<Cell> line_cells = {};
  std::optional<Spread> line_growth = std::nullopt;
};

/// Ours beside another's, or beside the same code without its exact stages, on one scene
/// (programs/bench/beside.h).
struct Beside {
  std::string scene;  ///< BenchScene::id
  int threads = 1;    ///< of both sides
  std::string other, what;
  std::optional<Spread> times_faster = std::nullopt;  ///< ours is than the other
  std::optional<double> count = std::nullopt;
  std::string left_out = {};  ///< why there is neither; else empty
};

/// What a feature costs; "off" is a drawing without it and "on" one with it.
struct FeatureRow {
  /// What the functions cost that only the feature needs.
  struct Own {
    std::uint64_t instructions = 0, allocations = 0;
  };
  template <class T>
  struct OffAndOn {
    T off, on;
  };
  std::string name, turned_on_by;
  std::string over;            ///< the feature that is on in both; empty: none
  bool has_functions = false;  ///< otherwise it is a branch in what all drawings run through
  std::string not_counted;     ///< why nothing of "on" is counted; else empty
  std::optional<Own> own_off, own_on;
  std::optional<OffAndOn<std::uint64_t>> instructions;  ///< of the whole drawing
  std::optional<OffAndOn<std::int64_t>> allocations;    ///< likewise
  std::optional<OffAndOn<std::int64_t>> most_bytes;     ///< held at a time, likewise
  std::optional<double> display_file_on;  ///< bytes a polygon that it adds to the display file
};

/// One scene, drawn on one thread from the first routine to the picture.
struct FeatureCosts {
  std::size_t polygons = 0;
  int size = 0;  ///< of the picture, pixels a side
  // With every feature off.
  std::optional<std::uint64_t> instructions;  ///< of the drawing
  std::int64_t allocations = 0;               ///< likewise
  double bytes_a_polygon = 0.0;               ///< of the display file, beyond vertices and sides
  std::string not_counted;                    ///< why there are no instructions; else empty
  std::vector<FeatureRow> rows;
};

/// Everything that the table, the JSON and the page show.
struct Report {
  std::string reference;  ///< what all times are given in
  std::vector<std::pair<std::string, std::string>> environment;
  std::vector<SceneRow> scenes;
  std::vector<Beside> beside = {};
  std::optional<FeatureCosts> features = std::nullopt;
  std::vector<ViewingRow> viewing = {};
};

/// "on" over "off".
template <class T>
double ratio(const FeatureRow::OffAndOn<T>& count) {
  return static_cast<double>(count.on) / static_cast<double>(count.off);
}

/// To four digits: what is written is what is kept, so that all outputs show the same figures.
double figure(double value);
Spread figures(const Spread& spread);

}  // namespace displayfile::bench
