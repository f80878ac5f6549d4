#include "tests/bench/command/feature_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "clip/base/error.h"
#include "tests/bench/command/callgrind.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/bench/command/features.h"

namespace displayfile::bench {

/// The function that callgrind counts: not inlined, with a plain name.
extern "C" [[gnu::noinline]] void displayfile_feature_counted(const FeatureUse* use,
                                                              const Scene* scene) {
  draw_with(*use, *scene);
}

namespace {

constexpr std::string_view kNone;
constexpr const char* kCounted = "displayfile_feature_counted";

/// At the last drawing, data that are made once for all are there.
constexpr std::size_t kTimesDrawn = 2;

/// The drawings: with each feature on, by its name, and with none.
std::vector<std::pair<std::string_view, FeatureUse>> drawings() {
  std::vector<std::pair<std::string_view, FeatureUse>> all{{kNone, FeatureUse{}}};
  for (const Feature& feature : features()) {
    if (feature.not_counted.empty()) all.emplace_back(feature.name, use_of(feature));
  }
  return all;
}

/// The bytes needed by the vertices and the sides of polygons as viewed, with any features.
struct NeededBytes {
  std::size_t bytes = 0;
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void pick(int) {}
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    bytes += vertices.size_bytes() + sides.size_bytes() + sizeof(sides[0]);
  }
};

/// The bytes beyond those and beyond the data kept as entered, in the order of entry.
double spare_bytes(const DisplayFile& file) {
  NeededBytes needed;
  for (const Segment& segment : file.segments()) {
    segment.walk_entered(needed);
    if (const auto* kept = segment.entered()->as_entered()) needed.bytes += kept->bytes();
  }
  return static_cast<double>(file.bytes()) - static_cast<double>(needed.bytes);
}

struct Memory {
  std::size_t display_file_bytes;  ///< sorted orders among them
  CountedMemory counted;
};

/// The memory of a second drawing: data made once for all are there.
Memory memory_of(const FeatureUse& use, const Scene& scene) {
  Memory memory;
  draw_with(use, scene,
            [&](const DisplayFile& drawn) { memory.display_file_bytes = drawn.bytes(); });
  memory.counted = counted_memory([&] { draw_with(use, scene); });
  return memory;
}

double per_polygon(double count, std::size_t polygons) {
  return figure(count / static_cast<double>(std::max<std::size_t>(1, polygons)));
}

/// The bytes that every additional polygon adds to the display file beyond its vertices and sides,
/// with all features off.
double spare_bytes_a_polygon() {
  constexpr std::size_t kFew = kFeaturePolygons / 2;
  const auto spare = [](std::size_t polygons) {
    double bytes = 0.0;
    draw_with({}, feature_scene(polygons),
              [&](const DisplayFile& drawn) { bytes = spare_bytes(drawn); });
    return bytes;
  };
  return per_polygon(spare(kFeaturePolygons) - spare(kFew), kFeaturePolygons - kFew);
}

/// The counts of each drawing; `not_counted` is the reason if there are none.
std::map<std::string_view, WorkCount> instructions(std::string& not_counted) {
  std::map<std::string_view, WorkCount> counts;
  const auto drawn = drawings();
  try {
    auto all = counted_calls({"bench", "--features-under-callgrind"}, kCounted,
                             kTimesDrawn * drawn.size());
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      counts.emplace(drawn[k].first, std::move(all[kTimesDrawn * k + kTimesDrawn - 1]));
    }
  } catch (const Error& error) {
    not_counted = error.what();
  }
  return counts;
}

using Counts = std::map<std::string_view, WorkCount>;  // by the feature that is on

/// Counts the functions that are the feature's own.
void add_own(const WorkCount& work, const Feature& feature, Json& state) {
  if (feature.functions.empty()) return;
  state["own_instructions"] = work.instructions_of(feature.functions);
  state["own_allocations"] = work.allocations_of(feature.functions);
}

Json row_of(const Feature& feature, std::map<std::string_view, Memory>& memory,
            const Counts& counts) {
  Json off = Json::object(), on = Json::object();
  const bool counted = feature.not_counted.empty();
  if (!counts.empty()) {
    add_own(counts.at(feature.over), feature, off);
    if (counted) {
      add_own(counts.at(feature.name), feature, on);
      off["instructions"] = counts.at(feature.over).instructions();
      on["instructions"] = counts.at(feature.name).instructions();
    }
  }
  if (counted) {
    const Memory &without = memory[feature.over], &with = memory[feature.name];
    off["allocations"] = without.counted.allocations;
    on["allocations"] = with.counted.allocations;
    off["most_bytes"] = without.counted.most_bytes;
    on["most_bytes"] = with.counted.most_bytes;
    on["display_file_bytes_a_polygon"] =
        per_polygon(static_cast<double>(with.display_file_bytes) -
                        static_cast<double>(without.display_file_bytes),
                    kFeaturePolygons);
  } else {
    on["not_counted"] = feature.not_counted;
  }
  return {{"feature", feature.name},
          {"turned_on_by", feature.turned_on_by},
          {"over", feature.over},
          {"has_functions", !feature.functions.empty()},
          {"off", off},
          {"on", on}};
}

}  // namespace

Json feature_costs() {
  const Scene scene = feature_scene();
  std::map<std::string_view, Memory> memory;
  for (const auto& [name, use] : drawings()) memory[name] = memory_of(use, scene);
  std::string not_counted;
  const Counts counts = instructions(not_counted);
  Json costs{{"polygons", scene.polygons()},
             {"size", kFeaturePictureSize},
             {"off",
              {{"allocations", memory[kNone].counted.allocations},
               {"display_file_bytes_a_polygon", spare_bytes_a_polygon()}}}};
  if (!counts.empty()) costs["off"]["instructions"] = counts.at(kNone).instructions();
  if (!not_counted.empty()) costs["instructions_not_counted"] = not_counted;
  for (const Feature& feature : features()) {
    costs["features"].push_back(row_of(feature, memory, counts));
  }
  return costs;
}

void draw_features_to_be_counted() {
  const Scene scene = feature_scene();
  for (const auto& [name, use] : drawings()) {
    for (std::size_t k = 0; k < kTimesDrawn; ++k) displayfile_feature_counted(&use, &scene);
  }
}

}  // namespace displayfile::bench
