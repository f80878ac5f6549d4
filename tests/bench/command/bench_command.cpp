#include "tests/bench/command/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/geometry/secret_hash.h"
#include "clip/surfaces.h"
#include "displayfile/text/output_file.h"
#include "programs/inputs/output_paths.h"
#include "programs/process/progress.h"
#include "tests/bench/command/beside.h"
#include "tests/bench/command/environment.h"
#include "tests/bench/command/feature_costs.h"
#include "tests/bench/command/line_measure.h"
#include "tests/bench/command/measure.h"
#include "tests/bench/command/page_template.h"
#include "tests/bench/command/partial_file.h"
#include "tests/bench/command/viewing.h"
#include "tests/bench/command/walk.h"

namespace displayfile {

using namespace bench;

namespace {

/// To be changed with the report's fields: report-figures reads no other.
constexpr int kReportFormat = 3;

std::vector<double> roundoffs(const BenchCommand& command) {
  if (command.roundoffs.empty()) {
    if (command.scenes.full) return {1e-15, 1e-12, 1e-9, 1e-6, 1e-3};
    return {1e-12, 1e-9, 1e-6};
  }
  std::vector<double> values;
  for (const std::string& text : command.roundoffs) {
    if (text != "none") values.push_back(precision("roundoff=" + text).roundoff);
  }
  return values;
}

/// The elements whose names the command selects, or all of them.
template <class C, class NameOf>
std::vector<C> chosen(std::vector<C> all, const BenchCommand& command, const NameOf& name_of) {
  if (command.methods.empty()) return all;
  std::vector<C> in_order;
  for (const std::string& name : command.methods) {
    std::ranges::copy_if(all, std::back_inserter(in_order),
                         [&](const C& contender) { return name_of(contender) == name; });
  }
  return in_order;
}

std::vector<Contender> chosen_contenders(const BenchCommand& command) {
  return chosen(contenders(roundoffs(command)), command,
                [](const Contender& contender) { return contender.method; });
}

std::vector<LineContender> chosen_line_contenders(const BenchCommand& command) {
  return chosen(line_contenders(roundoffs(command)), command,
                [](const LineContender& contender) { return contender.method_name(); });
}

/// The reason why a name is not measured.
std::string_view why_not_measured(const std::string& name) {
  constexpr std::array<std::string_view, 3> kPeers{"osmesa", "embree", "gl2ps"};
  if (std::ranges::find(kPeers, name) != kPeers.end()) return "not in this build";
  try {
    hidden_method(name);
    return "a method that is not measured";
  } catch (const Error&) {
    return "no method or peer";
  }
}

void require_methods(const BenchCommand& command) {
  const std::vector<std::string> known = method_names();
  for (const std::string& name : command.methods) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw Error(fmt::format("--methods {}: {}: expected some of {}", name, why_not_measured(name),
                            fmt::join(known, " ")));
  }
}

std::vector<int> thread_counts(const BenchCommand& command) {
  if (!command.threads.empty()) return command.threads;
  const int all = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<int> counts{1};
  for (int n = 2; n < all && command.scenes.full; n *= 2) counts.push_back(n);
  if (all > 1) counts.push_back(all);
  return counts;
}

/// True for the scene of its name that is measured whole; the others show how times grow.
bool is_largest(const BenchScene& scene, const std::vector<BenchScene>& scenes) {
  return std::ranges::none_of(scenes, [&](const BenchScene& other) {
    return other.name == scene.name &&
           std::pair(other.n, other.size) > std::pair(scene.n, scene.size);
  });
}

/// True of the exact methods, and of one precision of each other method, whose times are to be
/// compared as they grow.
bool is_in_series(const Contender& contender) {
  constexpr std::array<std::string_view, 7> kOthers{
      "", "float", "double", "24 bits", "single", "bsp, best root", "bsp, best root, culled"};
  return contender.exact || std::ranges::find(kOthers, contender.precision) != kOthers.end();
}

bool is_measured(const BenchScene& scene, bool largest, const Contender& contender, int threads) {
  if (scene.kind == BenchScene::Kind::hard_case) return threads == 1;
  if (threads > 1) return largest && contender.threaded && contender.exact;
  return largest || is_in_series(contender);
}

Effort effort_of(const BenchCommand& command, const BenchScene& scene) {
  Effort effort;
  // A turn of eight views of a large mesh takes a second.
  if (command.moving_camera) effort.most_seconds = 20.0;
  if (command.scenes.full) effort = {9, 0.005, 20.0};
  // Microseconds, for which each cell is visited several times.
  if (scene.kind == BenchScene::Kind::hard_case) effort = {4, 0.0002, 0.02};
  if (command.rounds > 0) effort.rounds = command.rounds;
  if (command.most_seconds > 0.0 && scene.kind != BenchScene::Kind::hard_case) {
    effort.most_seconds = command.most_seconds;
  }
  return effort;
}

/// Identifies the scene, including the content of a file.
std::string scene_key(const BenchScene& scene) {
  return scene.kind == BenchScene::Kind::input ? scene.id() + ' ' + file_hash(scene.name)
                                               : scene.id();
}

/// Identifies the runs whose figures can be taken over after an interruption.
std::string identity_of(const BenchCommand& command) {
  return fmt::format("{}, full {}, rounds {}, seconds {}, pieces {}", build_identity(),
                     command.scenes.full, command.rounds, command.most_seconds, pieces_allowed());
}

/// All but hard cases and the walk, in pictures of one size unless the command says otherwise.
std::vector<BenchScene> scenes_of_moving_camera(SceneChoice choice) {
  constexpr int kSize = 1024;
  if (choice.sizes.empty()) choice.sizes = {kSize};
  std::vector<BenchScene> scenes = chosen_scenes(choice);
  std::erase_if(scenes, [](const BenchScene& scene) {
    return scene.kind == BenchScene::Kind::hard_case || scene.kind == BenchScene::Kind::walk;
  });
  if (scenes.empty()) {
    throw Error(
        "--moving-camera: no scene for it: expected generated scenes, drawing programs or meshes");
  }
  return scenes;
}

class Run {
 public:
  Run(const BenchCommand& command, std::vector<BenchScene> scenes)
      : command_(command),
        scenes_(std::move(scenes)),
        contenders_(chosen_contenders(command)),
        line_contenders_(chosen_line_contenders(command)),
        threads_(thread_counts(command)),
        partial_(command.page + ".partial", identity_of(command)) {}

  Json report() {
    Json report{{"format", kReportFormat}, {"reference", kReference}};
    for (const auto& [name, value] : environment()) report["environment"][name] = value;
    report["beside"] = Json::array();
    const bool measures = has_surfaces() && !command_.moving_camera;
    for_each_scene("measuring", [&](const BenchScene& scene) {
      report["scenes"].push_back(unmeasured(scene));
      if (measures) measure(scene, report);
    });
    if (command_.moving_camera) {
      for_each_name("moving the camera",
                    [&](const Scenes& named) { compare_views(named, report); });
      return report;
    }
    if (!line_contenders_.empty()) measure_lines(report);
    if (!measures) return report;
    for_each_name("comparing", [&](const Scenes& named) { compare(named, report); });
    for_each_scene("viewing in exact arithmetic", [&](const BenchScene& scene) {
      if (scene.kind != BenchScene::Kind::hard_case && !is_largest(scene, scenes_)) return;
      if (const auto row = rounding_of_viewing(scene)) report["viewing"].push_back(*row);
    });
    return report;
  }
  void finish() { partial_.remove(); }
  std::size_t measured_now() const { return measured_now_; }
  std::size_t from_before() const { return from_before_; }

 private:
  using Scenes = std::vector<const BenchScene*>;  // of one name

  /// Methods of surfaces are chosen, not only methods of lines.
  bool has_surfaces() const { return !contenders_.empty(); }

  void for_each_scene(const char* what, const auto& work) const {
    Progress progress(what);
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      progress.update(i, scenes_.size());
      work(scenes_[i]);
    }
  }
  /// All but hard cases and the walk, by their names.
  void for_each_name(const char* what, const auto& work) const {
    std::vector<Scenes> all;
    for (const BenchScene& scene : scenes_) {
      const bool is_one_picture =
          scene.kind != BenchScene::Kind::hard_case && scene.kind != BenchScene::Kind::walk;
      if (!is_one_picture) continue;
      if (all.empty() || all.back().front()->name != scene.name) all.emplace_back();
      all.back().push_back(&scene);
    }
    Progress progress(what);
    for (std::size_t i = 0; i < all.size(); ++i) {
      progress.update(i, all.size());
      work(all[i]);
    }
  }

  static Json unmeasured(const BenchScene& scene) {
    const DisplayFile file = scene.make();
    Json row{{"scene", scene.id()},         {"name", scene.name}, {"kind", name_of(scene.kind)},
             {"polygons", file.polygons()}, {"size", scene.size}, {"pixels", scene.pixels()}};
    row.update(cover(scene, file));
    if (scene.kind != BenchScene::Kind::hard_case) return row;
    row["severity"] = scene.severity;
    row["gap"] = scene.gap;
    return row;
  }

  /// The figures of that key: taken over, or measured now and kept.
  Json figures_of(const std::string& key, const auto& measure) {
    if (const Json* before = partial_.find(key)) {
      ++from_before_;
      return *before;
    }
    ++measured_now_;
    Json figures = measure();
    partial_.add(key, figures);
    return figures;
  }

  /// Scenes that differ only in the picture's size are the same to methods of lines.
  void measure_lines(Json& report) {
    std::set<std::string> done;
    report["line_reference"] = kLineReference;
    report["line_cells"] = Json::array();
    std::size_t place = 0;
    for_each_scene("measuring lines", [&](const BenchScene& scene) {
      Json& row = report["scenes"][place++];
      const bool is_still = scene.kind != BenchScene::Kind::walk;
      if (is_still && done.insert(scene.id_but_size()).second) measure_lines(scene, row, report);
    });
  }

  void measure_lines(const BenchScene& scene, Json& row, Json& report) {
    const bool hard_case = scene.kind == BenchScene::Kind::hard_case;
    const bool most_polygons = std::ranges::none_of(scenes_, [&](const BenchScene& other) {
      return other.name == scene.name && other.n > scene.n;
    });
    bool taken = false;  // a scene's truth is found only if a measurement of it is missing
    const auto take = [&] {
      if (std::exchange(taken, true)) return;
      line_measurer_.take(scene, effort_of(command_, scene), *std::ranges::max_element(threads_));
    };
    if (scene.kind == BenchScene::Kind::generated || scene.kind == BenchScene::Kind::surface) {
      take();
      row["line_reference_growth"] = line_measurer_.growth();
    }
    for (const LineContender& contender : line_contenders_) {
      if (!draws(contender, scene)) continue;
      for (const int threads : threads_) {
        const bool exact = contender.precision.exact;
        if (threads > 1 && (hard_case || !most_polygons || !exact)) continue;
        if (!most_polygons && !exact && !command_.scenes.full) continue;
        const std::string key =
            fmt::format("{} lines {} {} {}", scene_key(scene), contender.method_name(),
                        contender.precision_name(), threads);
        report["line_cells"].push_back(figures_of(key, [&] {
          take();
          return line_measurer_.measure(contender, threads);
        }));
      }
    }
  }

  void measure(const BenchScene& scene, Json& report) {
    measurer_.take(scene, effort_of(command_, scene));
    const std::string key = scene_key(scene);
    const bool is_short = scene.kind == BenchScene::Kind::hard_case;
    if (!is_short) report["scenes"].back()["reference_growth"] = measurer_.growth();
    std::vector<Contender> all = contenders_;
    if (scene.kind == BenchScene::Kind::walk && is_chosen("bsp")) all.push_back(retained_tree());
    const bool whole = command_.scenes.full || is_largest(scene, scenes_);
    std::vector<Visited> visited;
    for (const Contender& contender : all) {
      for (const int threads : threads_) {
        if (!is_measured(scene, whole, contender, threads)) continue;
        const std::string cell_key =
            fmt::format("{} {} {} {}", key, contender.method, contender.precision, threads);
        const auto measured = [&] { return measurer_.measure(contender, threads); };
        Json& cells = report["cells"];
        if (!is_short || partial_.find(cell_key) != nullptr) {
          cells.push_back(figures_of(cell_key, measured));
        } else {
          cells.push_back(measured());
          visited.push_back({&contender, cell_key, cells.size() - 1, {}});
        }
      }
    }
    visit_again(visited, report["cells"]);
  }

  /// A cell of a scene so short that a pause of the machine's may fall on all rounds of it.
  struct Visited {
    const Contender* contender;
    std::string key;
    std::size_t cell;
    std::vector<Json> times;
  };
  /// Visits all cells in turn, and gives each the median of its visits.
  void visit_again(std::vector<Visited>& visited, Json& cells) {
    constexpr int kVisits = 3;
    for (int visit = 1; visit < kVisits; ++visit) {
      for (Visited& v : visited) {
        const Json& cell = cells[v.cell];
        if (cell.contains("skipped")) continue;
        if (const auto time = measurer_.time_again(*v.contender, cell)) v.times.push_back(*time);
      }
    }
    for (Visited& v : visited) {
      Json& cell = cells[v.cell];
      if (!v.times.empty()) {
        v.times.push_back(cell["time"]);
        std::vector<double> least, median, greatest;
        for (const Json& time : v.times) {
          least.push_back(time["least"]);
          median.push_back(time["median"]);
          greatest.push_back(time["greatest"]);
        }
        cell["time"] =
            figures({spread(least).least, spread(median).median, spread(greatest).greatest});
      }
      ++measured_now_;
      partial_.add(v.key, cell);
    }
  }

  bool is_chosen(const std::string& method) const {
    return std::ranges::find(contenders_, method, &Contender::method) != contenders_.end();
  }

  /// With the chosen peers, on the largest picture of each scene; sorts on the most polygons; and
  /// exact methods with themselves.
  void compare(const Scenes& named, Json& report) {
    const auto large = **std::ranges::max_element(
        named, {}, [](const BenchScene* scene) { return std::pair(scene->size, scene->n); });
    const auto most = **std::ranges::max_element(
        named, {}, [](const BenchScene* scene) { return std::pair(scene->n, scene->size); });
    for (const int threads : threads_) {
      for (const char* peer : {"osmesa", "embree"}) {
        if (is_chosen(peer)) compare(large, threads, peer, report);
      }
    }
    if (is_chosen("osmesa")) compare_views(named, report);
    if (is_chosen("gl2ps")) compare(most, 1, "gl2ps", report);
    compare(large, 1, "rounded", report);
  }

  /// The scene at every number of polygons that it has with its largest picture.
  void compare_views(const Scenes& named, Json& report) {
    const int size = (*std::ranges::max_element(named, {}, &BenchScene::size))->size;
    std::vector<BenchScene> scenes;
    for (const BenchScene* scene : named) {
      if (scene->size == size) scenes.push_back(*scene);
    }
    const std::size_t first = std::ranges::min_element(scenes, {}, &BenchScene::n)->n;
    for (const BenchScene& scene : scenes) {
      for (const int threads : threads_) {
        compare({scene,
                 threads,
                 "views",
                 {},
                 {},
                 effort_of(command_, scene),
                 scene.n > first ? first : 0},
                report);
      }
    }
  }

  void compare(const BenchScene& scene, int threads, const std::string& other, Json& report) {
    BesideTask task{scene, threads, other, {}, {}, effort_of(command_, scene), 0};
    for (const Contender& contender : contenders_) {
      const bool is_beside_ours = other == "rounded" || other == "gl2ps";
      if (is_beside_ours && contender.exact) task.methods.push_back(contender.method);
    }
    for (const Json& cell : report["cells"]) {
      const bool is_left_out = cell["scene"] == scene.id() && cell["exact"] == true &&
                               cell["threads"] == 1 && cell.contains("skipped");
      if (is_left_out) task.left_out[cell["method"]] = cell["skipped"];
    }
    compare(task, report);
  }

  void compare(const BesideTask& task, Json& report) {
    const Json found = figures_of(scene_key(task.scene) + ' ' + text_of(task),
                                  [&] { return compare_in_own_process(task); });
    for (const Json& row : found) report["beside"].push_back(row);
  }

  const BenchCommand& command_;
  std::vector<BenchScene> scenes_;
  std::vector<Contender> contenders_;
  std::vector<LineContender> line_contenders_;
  std::vector<int> threads_;
  PartialFile partial_;
  Measurer measurer_;
  LineMeasurer line_measurer_;
  std::size_t measured_now_ = 0, from_before_ = 0;
};

void write_text(const std::string& path, const std::string& text) {
  OutputFile out(path);
  out.stream() << text;
  out.commit();
}

/// The page's template with its scripts and the figures, which no tag ends.
std::string page_of(const Json& report) {
  std::string text = report.dump(), page = kPageTemplate;
  for (std::size_t at = 0; (at = text.find("</", at)) != text.npos;) text.insert(at + 1, 1, '\\');
  const auto put = [&](std::string_view place, const std::string& what) {
    page.replace(page.find(place), place.size(), what);
  };
  std::string scripts;
  for (const char* script : kPageScripts) scripts += script;
  put("SCRIPTS", scripts);
  put("REPORT", text);
  return page;
}

/// Rows of figures except hard cases', a line each: nested values are separated by slashes.
void print(const char* title, const Json& rows, const std::set<std::string>& hard_cases) {
  std::vector<std::string> heads;
  std::vector<Json> all;
  for (const Json& row : rows) {
    if (row.contains("scene") && hard_cases.contains(row["scene"])) continue;
    all.push_back(row.flatten());
    for (const auto& [name, value] : all.back().items()) {
      if (std::ranges::find(heads, name) == heads.end()) heads.push_back(name);
    }
  }
  if (all.empty()) return;
  std::vector<std::vector<std::string>> cells(all.size() + 1);
  for (const std::string& head : heads) {
    cells[0].push_back(head.substr(1));
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto value = all[k].find(head);
      cells[k + 1].push_back(value == all[k].end() ? ""
                             : value->is_string()  ? value->get<std::string>()
                                                   : value->dump());
    }
  }
  std::cout << title << '\n';
  for (const auto& row : cells) {
    for (std::size_t k = 0; k < heads.size(); ++k) {
      std::size_t width = 0;
      for (const auto& other : cells) width = std::max(width, other[k].size());
      std::cout << fmt::format("  {:<{}}", row[k], width);
    }
    std::cout << '\n';
  }
  std::cout << '\n';
}

void print(const Json& report) {
  std::set<std::string> hard_cases;
  for (const Json& scene : report["scenes"]) {
    if (!scene.contains("severity")) continue;
    const std::string id = scene["scene"];
    hard_cases.insert({id, id.substr(0, id.rfind(' '))});
  }
  std::cout << "Times are ratios to " << kReference << ", of lines to " << kLineReference
            << ". Hard cases are on the page, and what follows from these figures.\n\n";
  for (const char* rows : {"scenes", "cells", "line_cells", "beside"}) {
    if (report.contains(rows)) print(rows, report[rows], hard_cases);
  }
  if (!report.contains("feature_costs")) return;
  const Json& costs = report["feature_costs"];
  print("feature_costs", costs["features"], {});
  if (!costs.contains("instructions_not_counted")) return;
  std::cout << "Instructions were not counted: "
            << costs["instructions_not_counted"].get<std::string>() << '\n';
}

/// Prints which exact methods were wrong where, in pixels or lengths; false if any was.
bool exact_methods_are_right(const Json& report) {
  bool right = true;
  const auto judge = [&](const Json& row, const char* part) {
    if (row.value(part, 0.0) == 0.0) return;
    std::cout << fmt::format("wrong: {} in {}\n", part, row.dump());
    right = false;
  };
  for (const char* cells : {"cells", "line_cells"}) {
    for (const Json& cell : report.value(cells, Json::array())) {
      if (cell["exact"] == false) continue;
      for (const char* part : {"wrong_pixels", "missing_length", "extra_length"}) judge(cell, part);
    }
  }
  for (const Json& row : report["beside"]) {
    if (row["other"] == "truth" && row["what"] == "wrong pixels") judge(row, "count");
  }
  return right;
}

}  // namespace

int BenchCommand::run() const {
  if (features_under_callgrind) {
    SecretHash::use_known_numbers();
    draw_features_to_be_counted();
    return 0;
  }
  if (!beside.empty()) {
    std::cout << compared(beside);
    return 0;
  }
  if (extension_of(page) != ".html") throw Error(page + ": expected a file that ends in .html");
  // Every output must be writable before the long work.
  require_files_of_their_own({page, json}, scenes.names);
  OutputFile{page};
  if (!json.empty()) OutputFile{json};
  // llvmpipe draws on the calling thread alone, as all methods do that have no threads of their
  // own.
  setenv("LP_NUM_THREADS", "0", 0);
  require_methods(*this);
  Run measuring(*this, moving_camera ? scenes_of_moving_camera(scenes) : chosen_scenes(scenes));
  Json report = measuring.report();
  if (features.value_or(has_default(scenes) && !moving_camera)) {
    Progress progress("counting what features cost");
    progress.update(0, 1);
    report["feature_costs"] = feature_costs();
  }
  if (!json.empty()) write_text(json, report.dump(1) + '\n');
  write_text(page, page_of(report));
  measuring.finish();
  print(report);
  std::cout << fmt::format(
      "{} figures and comparisons measured, {} taken over from an interrupted run\n{}\n",
      measuring.measured_now(), measuring.from_before(), page);
  return exact_methods_are_right(report) ? 0 : 1;
}

std::vector<std::string> bench::method_names() {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Contender& contender : contenders({})) add(contender.method);
  for (const LineContender& contender : line_contenders({})) add(contender.method_name());
  return names;
}

}  // namespace displayfile
