#include "programs/bench/bench_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include "clip/error.h"
#include "clip/secret_hash.h"
#include "clip/surfaces.h"
#include "displayfile/file_extension.h"
#include "displayfile/output_file.h"
#include "programs/bench/analysis.h"
#include "programs/bench/beside.h"
#include "programs/bench/environment.h"
#include "programs/bench/feature_costs.h"
#include "programs/bench/json_report.h"
#include "programs/bench/line_measure.h"
#include "programs/bench/measure.h"
#include "programs/bench/page.h"
#include "programs/bench/partial_file.h"
#include "programs/bench/readme_figures.h"
#include "programs/bench/summary.h"
#include "programs/bench/text_report.h"
#include "programs/bench/walk.h"
#include "programs/output_paths.h"
#include "programs/progress.h"

namespace displayfile {

using namespace bench;

namespace {

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

/// Those that have the names that the command asks for, or all of them.
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

void require_methods(const BenchCommand& command) {
  const std::vector<std::string> known = method_names();
  for (const std::string& name : command.methods) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw Error(fmt::format("--methods {}: not in this build: expected some of {}", name,
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

bool is_measured(const BenchScene& scene, bool largest, const Contender& contender, int threads) {
  if (scene.kind == BenchScene::Kind::hard_case) return threads == 1;
  if (threads > 1) return largest && contender.threaded && contender.exact;
  return largest || is_in_series({contender.method, contender.precision, contender.exact});
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

/// What distinguishes the scene from others, the content of a file included.
std::string scene_key(const BenchScene& scene) {
  return scene.kind == BenchScene::Kind::input ? scene.id() + ' ' + file_hash(scene.name)
                                               : scene.id();
}

/// What figures can be taken over from an interrupted run.
std::string identity_of(const BenchCommand& command) {
  return fmt::format("{}, full {}, rounds {}, seconds {}", build_identity(), command.scenes.full,
                     command.rounds, command.most_seconds);
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

  Report report() {
    Report report{kReference, environment(), {}};
    {
      Progress progress("measuring");
      for (std::size_t i = 0; i < scenes_.size(); ++i) {
        progress.update(i, scenes_.size());
        report.scenes.push_back(has_surfaces() ? measured(scenes_[i]) : unmeasured(scenes_[i]));
      }
    }
    if (!line_contenders_.empty()) measure_lines(report);
    if (has_surfaces()) compare(report);
    return report;
  }
  /// Nothing but new views of retained scenes.
  Report report_of_moving_camera() {
    Report report{kReference, environment(), {}};
    for (const BenchScene& scene : scenes_) {
      report.scenes.push_back(unmeasured(scene));
    }
    Progress progress("moving the camera");
    const std::vector<std::string> all_names = names_but_hard_cases(report);
    for (std::size_t i = 0; i < all_names.size(); ++i) {
      progress.update(i, all_names.size());
      compare_new_views(all_names[i], report);
    }
    return report;
  }
  /// Methods of surfaces are chosen, not only methods of lines.
  bool has_surfaces() const { return !contenders_.empty(); }
  void finish() { partial_.remove(); }
  std::size_t measured_now() const { return measured_now_; }
  std::size_t from_before() const { return from_before_; }

 private:
  static SceneRow unmeasured(const BenchScene& scene) {
    return {scene, scene.make().polygons(), std::nullopt, {}};
  }

  /// Scenes that differ in the picture's size alone are one to methods of lines.
  void measure_lines(Report& report) {
    Progress progress("measuring lines");
    std::set<std::string> done;
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
      progress.update(i, report.scenes.size());
      SceneRow& row = report.scenes[i];
      const bool is_still = row.scene.kind != BenchScene::Kind::walk;
      if (is_still && done.insert(row.scene.id_but_size()).second) measure_lines(row);
    }
  }

  void measure_lines(SceneRow& row) {
    const bool hard_case = row.scene.kind == BenchScene::Kind::hard_case;
    const bool most_polygons = std::ranges::none_of(scenes_, [&](const BenchScene& other) {
      return other.name == row.scene.name && other.n > row.scene.n;
    });
    const std::string key = scene_key(row.scene) + " lines";
    const int truth_threads = *std::ranges::max_element(threads_);
    bool taken = false;  // the truth of a scene is found where something is left to measure
    const auto take = [&] {
      if (!std::exchange(taken, true)) {
        line_measurer_.take(row.scene, effort_of(command_, row.scene), truth_threads);
      }
    };
    const bool grows = row.scene.kind == BenchScene::Kind::generated ||
                       row.scene.kind == BenchScene::Kind::surface;
    if (grows) {
      take();
      row.line_growth = line_measurer_.growth();
    }
    for (const LineContender& contender : line_contenders_) {
      if (!draws(contender, row.scene)) continue;
      for (const int threads : threads_) {
        const bool exact = contender.precision.exact;
        if (threads > 1 && (hard_case || !most_polygons || !exact)) continue;
        if (!most_polygons && !exact && !command_.scenes.full) continue;
        const CellKey cell_key{row.scene.id_but_size(), contender.method_name(),
                               contender.precision_name(), threads};
        if (const Cell* before = partial_.find(key, cell_key)) {
          row.line_cells.push_back(*before);
          ++from_before_;
          continue;
        }
        take();
        row.line_cells.push_back(line_measurer_.measure(contender, threads));
        row.line_cells.back().key.scene = cell_key.scene;
        ++measured_now_;
        partial_.add(key, row.line_cells.back());
      }
    }
  }

  SceneRow measured(const BenchScene& scene) {
    measurer_.take(scene, effort_of(command_, scene));
    const std::string key = scene_key(scene);
    SceneRow row{scene, measurer_.polygons(), std::nullopt, {}};
    if (scene.kind != BenchScene::Kind::hard_case) row.growth = measurer_.growth();
    std::vector<Contender> all = contenders_;
    const bool whole = command_.scenes.full || is_largest(scene, scenes_);
    if (scene.kind == BenchScene::Kind::walk && has_bsp()) all.push_back(retained_tree());
    const bool short_scene = scene.kind == BenchScene::Kind::hard_case;
    std::vector<Visited> visited;
    for (const Contender& contender : all) {
      for (const int threads : threads_) {
        if (!is_measured(scene, whole, contender, threads)) continue;
        const CellKey cell_key{scene.id(), contender.method, contender.precision, threads};
        if (const Cell* before = partial_.find(key, cell_key)) {
          row.cells.push_back(*before);
          ++from_before_;
          continue;
        }
        row.cells.push_back(measurer_.measure(contender, threads));
        ++measured_now_;
        if (short_scene) {
          visited.push_back({&contender, row.cells.size() - 1, {}});
        } else {
          partial_.add(key, row.cells.back());
        }
      }
    }
    visit_again(visited, row);
    for (const Visited& v : visited) partial_.add(key, row.cells[v.cell]);
    return row;
  }

  bool is_chosen(const std::string& method) const {
    return std::ranges::find(contenders_, method, &Contender::method) != contenders_.end();
  }

  /// With what of the peers was chosen, on the largest picture of each scene; sorts on the most
  /// polygons; and exact methods with themselves.
  void compare(Report& report) {
    Progress progress("comparing");
    const std::vector<std::string> all_names = names_but_hard_cases(report);
    for (std::size_t i = 0; i < all_names.size(); ++i) {
      progress.update(i, all_names.size());
      const SceneRow& large = largest_picture(report, all_names[i]);
      if (large.scene.kind == BenchScene::Kind::walk) continue;
      for (const int threads : threads_) {
        for (const char* peer : {"osmesa", "embree"}) {
          if (is_chosen(peer)) compare(large, threads, peer, report);
        }
      }
      if (is_chosen("osmesa")) compare_new_views(all_names[i], report);
      if (is_chosen("gl2ps")) compare(shown_scene(report, all_names[i]), 1, "gl2ps", report);
      compare(large, 1, "rounded", report);
    }
  }

  /// The scene is measured at every number of polygons that it has with its largest picture.
  void compare_new_views(const std::string& name, Report& report) {
    const int size = largest_picture(report, name).scene.size;
    std::vector<const BenchScene*> scenes;
    for (const SceneRow& row : report.scenes) {
      if (row.scene.name == name && row.scene.size == size) scenes.push_back(&row.scene);
    }
    const std::size_t first = (*std::ranges::min_element(scenes, {}, &BenchScene::n))->n;
    for (const BenchScene* scene : scenes) {
      for (const int threads : threads_) {
        BesideTask task{*scene, threads, {"views"}, {}, {}, effort_of(command_, *scene)};
        if (scene->n > first) task.first_polygons = first;
        compare(task, report);
      }
    }
  }

  void compare(const SceneRow& row, int threads, const std::string& other, Report& report) {
    BesideTask task{row.scene, threads, {other}, {}, {}, effort_of(command_, row.scene)};
    for (const Contender& contender : contenders_) {
      const bool wanted = other == "rounded" && contender.exact;
      if (wanted) task.methods.push_back(contender.method);
    }
    for (const Cell& cell : row.cells) {
      if (cell.exact && cell.key.threads == 1 && !cell.skipped.empty()) {
        task.left_out[cell.key.method] = cell.skipped;
      }
    }
    compare(task, report);
  }

  void compare(const BesideTask& task, Report& report) {
    const std::string key = scene_key(task.scene) + ' ' + to_json(task).dump();
    const std::vector<Beside>* const before = partial_.find_beside(key);
    const std::vector<Beside> found = before ? *before : compare_in_own_process(task);
    ++(before ? from_before_ : measured_now_);
    if (before == nullptr) partial_.add(key, found);
    report.beside.insert(report.beside.end(), found.begin(), found.end());
  }

  /// A cell of a scene so short that a pause of the machine's may fall on all rounds of it.
  struct Visited {
    const Contender* contender;
    std::size_t cell;
    std::vector<Spread> times;
  };
  /// Visits all cells in turn, and gives each the median of its visits.
  void visit_again(std::vector<Visited>& visited, SceneRow& row) {
    constexpr int kVisits = 3;
    for (int visit = 1; visit < kVisits; ++visit) {
      for (Visited& v : visited) {
        const Cell& cell = row.cells[v.cell];
        if (!cell.skipped.empty()) continue;
        const auto time = measurer_.time_again(*v.contender, cell);
        if (time) v.times.push_back(*time);
      }
    }
    for (Visited& v : visited) {
      Spread& time = row.cells[v.cell].time;
      std::vector<double> medians{time.median};
      for (const Spread& later : v.times) {
        medians.push_back(later.median);
        time.least = std::min(time.least, later.least);
        time.greatest = std::max(time.greatest, later.greatest);
      }
      time.median = spread(std::move(medians)).median;
    }
  }

  bool has_bsp() const {
    return std::ranges::find(contenders_, "bsp", &Contender::method) != contenders_.end();
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

FeatureCosts counted_features() {
  Progress progress("counting what features cost");
  progress.update(0, 1);
  return feature_costs();
}

/// What the rounding of viewing decides of each scene, in its largest picture.
std::vector<ViewingRow> rounding_of_viewing(const std::vector<BenchScene>& scenes) {
  Progress progress("viewing in exact arithmetic");
  std::vector<ViewingRow> rows;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    progress.update(i, scenes.size());
    const BenchScene& scene = scenes[i];
    if (scene.kind != BenchScene::Kind::hard_case && !is_largest(scene, scenes)) continue;
    if (const auto row = bench::rounding_of_viewing(scene)) rows.push_back(*row);
  }
  return rows;
}

/// Nothing, or a file that ends so.
void require_extension(const std::string& path, std::string_view extension) {
  if (path.empty() || extension_of(path) == extension) return;
  throw Error(fmt::format("{}: expected a file that ends in {}", path, extension));
}

void write_text(const std::string& path, const std::string& text) {
  OutputFile out(path);
  out.stream() << text;
  out.commit();
}

/// Says which exact methods were wrong where, in pixels or lengths; false if any was.
bool exact_methods_are_right(const Report& report) {
  bool right = true;
  for (const SceneRow& row : report.scenes) {
    for (const Cell& cell : row.cells) {
      if (!cell.exact || cell.wrong_pixels == 0) continue;
      std::cout << fmt::format("{}: {} wrong pixels by {}\n", cell.key.scene, cell.wrong_pixels,
                               cell.key.contender());
      right = false;
    }
    for (const Cell& cell : row.line_cells) {
      if (!cell.exact || !cell.lines || cell.lines->missing + cell.lines->extra == 0.0) continue;
      std::cout << fmt::format("{}: missing length {}, extra length {} by {}\n", cell.key.scene,
                               cell.lines->missing, cell.lines->extra, cell.key.contender());
      right = false;
    }
  }
  for (const Beside& b : report.beside) {
    if (b.other != beside::kTruth || b.what != beside::kWrongPixels || *b.count == 0.0) continue;
    std::cout << fmt::format("{}: {:g} wrong pixels in new views of it, {} threads\n", b.scene,
                             *b.count, b.threads);
    right = false;
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
  require_extension(page, ".html");
  require_extension(plot, ".svg");
  // Every output must be writable before the long work.
  require_files_of_their_own({page, json, plot, readme}, scenes.names);
  OutputFile{page};
  if (!json.empty()) OutputFile{json};
  if (!plot.empty()) OutputFile{plot};
  if (!readme.empty()) {
    OutputFile{readme};
    ReadmeFigures{readme};
  }
  // llvmpipe draws on the calling thread alone, as all methods do that have no threads of their
  // own.
  setenv("LP_NUM_THREADS", "0", 0);
  require_methods(*this);
  const std::vector<BenchScene> measured =
      moving_camera ? scenes_of_moving_camera(scenes) : chosen_scenes(scenes);
  Run measuring(*this, measured);
  Report report = moving_camera ? measuring.report_of_moving_camera() : measuring.report();
  if (!moving_camera && measuring.has_surfaces()) report.viewing = rounding_of_viewing(measured);
  const bool counts_features = has_default(scenes) && !moving_camera;
  if (features.value_or(counts_features)) report.features = counted_features();
  if (!json.empty()) write_text(json, to_json(report).dump(1) + '\n');
  write_text(page, html_page(report));
  if (!plot.empty()) {
    const auto text = front_plot(report);
    if (!text) throw Error(plot + ": there is no scene that all methods were measured on");
    write_text(plot, *text);
  }
  // Read anew: a long run is time enough to edit it.
  if (!readme.empty()) write_text(readme, ReadmeFigures(readme).with(summaries(report)));
  measuring.finish();
  std::cout
      << text_report(report)
      << fmt::format(
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
