#include "tests/bench/command/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/exact/predicate_counts.h"
#include "interp/truth/depth_ties.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/bench/command/walk.h"

namespace displayfile::bench {

struct Measurer::Scene {
  BenchScene scene;
  DisplayFile file;
  std::vector<displayfile::Scene> views;  // of a walk: each has a display file of its own
  Picture truth;                          // of a walk, that of all views below each other
  std::vector<DepthTies> ties;            // of each view
  std::unique_ptr<Drawing> reference;
  double reference_seconds = 0.0;

  explicit Scene(const BenchScene& s);
  std::unique_ptr<Drawing> drawing(const Contender& contender, int threads) const;
  /// True if this polygon is exactly as near at the pixel as the correct one.
  bool is_tied(std::size_t pixel, std::int32_t pick) const;
  /// The time of work on `threads` threads over that of the reference; `once` is its approximate
  /// time.
  Json over_reference(const Effort& effort, int threads, double once, const auto& work) const;
  double polygons() const { return static_cast<double>(file.polygons()); }
  double pixels() const { return static_cast<double>(scene.pixels()); }
};

namespace {

std::uint64_t exact_calls() {
  std::uint64_t sum = 0;
  for (const StageCounts& count : predicate_counts()) sum += count.exact;
  return sum;
}

std::string key_of(const Json& cell) {
  return fmt::format("{} {} {}", cell["method"].dump(), cell["precision"].dump(),
                     cell["threads"].dump());
}

Picture truth_with_ties(const DisplayFile& file, int size, std::vector<DepthTies>& ties) {
  return truth_as_entered(file, size, size, true, {}, &ties.emplace_back());
}

Picture truth_of_walk(const std::vector<displayfile::Scene>& views, int size,
                      std::vector<DepthTies>& ties) {
  Picture all;
  for (const displayfile::Scene& view : views) {
    append(truth_with_ties(entered(view).display_file(), size, ties), all);
  }
  return all;
}

}  // namespace

Measurer::Scene::Scene(const BenchScene& s) : scene(s), file(s.make()) {
  if (scene.kind == BenchScene::Kind::walk) {
    views = walk(scene.n, scene.seed);
    truth = truth_of_walk(views, scene.size, ties);
  } else {
    truth = truth_with_ties(file, scene.size, ties);
  }
  reference = drawing(reference_contender(), 1);
  reference->draw_anew();
  reference_seconds = seconds_once([&] { reference->draw_anew(); });
}

std::unique_ptr<Drawing> Measurer::Scene::drawing(const Contender& contender, int threads) const {
  const Frame frame{scene.size, scene.size, threads};
  if (scene.kind != BenchScene::Kind::walk) return contender.draw(file, frame);
  return contender.draw ? draw_walk(views, contender, frame) : draw_walk_with_tree(views, frame);
}

bool Measurer::Scene::is_tied(std::size_t pixel, std::int32_t pick) const {
  const std::size_t of_view = truth.ids.size() / ties.size();
  return ties[pixel / of_view].contains(pixel % of_view, pick);
}

Json Measurer::Scene::over_reference(const Effort& effort, int threads, double once,
                                     const auto& work) const {
  return figures(ratio(effort, clock_of(threads), once, work, reference_seconds,
                       [&] { reference->draw_anew(); }));
}

Measurer::Measurer() = default;
Measurer::~Measurer() = default;

void Measurer::take(const BenchScene& scene, const Effort& effort) {
  effort_ = effort;
  const bool same_name = scene_ != nullptr && scene_->scene.name == scene.name;
  if (!same_name) {
    first_.reset();
    longest_.clear();
  } else if (first_ == nullptr) {
    first_ = std::move(scene_);
  }
  scene_ = std::make_unique<Scene>(scene);
}

std::size_t Measurer::polygons() const { return scene_->file.polygons(); }

Json Measurer::growth() {
  if (first_ == nullptr) return figures({1.0, 1.0, 1.0});
  return figures(ratio(
      effort_, Clock::processor, scene_->reference_seconds, [&] { scene_->reference->draw_anew(); },
      first_->reference_seconds, [&] { first_->reference->draw_anew(); }));
}

/// The time by which a smaller scene of the name exceeded the least one may grow to twice as much
/// on twice the pixels, and to four times as much on twice the polygons.
bool Measurer::too_long(const Json& cell) const {
  constexpr double kTimesTheMost = 5.0;
  const auto longest = longest_.find(key_of(cell));
  const bool grows = scene_->scene.kind != BenchScene::Kind::hard_case;
  if (!grows || longest == longest_.end()) return false;
  const Longest& before = longest->second;
  const double of_polygons = std::max(1.0, scene_->polygons() / before.polygons);
  const double of_pixels = std::max(1.0, scene_->pixels() / before.pixels);
  const double grown = (before.seconds - before.least_seconds) * of_polygons * of_pixels;
  return grown * of_polygons > kTimesTheMost * effort_.most_seconds && grown > effort_.most_seconds;
}

void Measurer::compare(const Picture& picture, Json& cell) const {
  const Picture& right = scene_->truth;
  double sum = 0.0, largest = 0.0;
  std::int64_t both = 0, wrong = 0, tied = 0;
  for (std::size_t i = 0; i < right.ids.size(); ++i) {
    if (picture.ids[i] != right.ids[i]) {
      ++wrong;
      tied += scene_->is_tied(i, picture.ids[i]) ? 1 : 0;
    }
    if (!std::isfinite(picture.depth[i]) || !std::isfinite(right.depth[i])) continue;
    const double error = std::abs(picture.depth[i] - right.depth[i]);
    largest = std::max(largest, error);
    sum += error;
    ++both;
  }
  cell["wrong_pixels"] = wrong;
  cell["wrong_and_tied"] = tied;
  cell["largest_depth_error"] = figure(largest);
  cell["mean_depth_error"] = both == 0 ? 0.0 : figure(sum / static_cast<double>(both));
}

/// A second picture, since the first one makes the data that a method keeps for all pictures.
void count_memory_and_exact_calls(const std::function<void()>& work, Json& cell) {
  reset_predicate_counts();
  cell["bytes"] = most_bytes_held(work);
  cell["exact_stage_calls"] = exact_calls();
}

Json Measurer::measure(const Contender& contender, int threads) {
  Json cell =
      cell_of(scene_->scene.id(), contender.method, contender.precision, threads, contender.exact);
  if (too_long(cell)) {
    cell["skipped"] = "it would take too long, from what a smaller one took";
    return cell;
  }
  try {
    measure(contender, cell);
  } catch (const CannotDraw& reason) {
    cell["skipped"] = reason.why;
  } catch (const LimitReached& reached) {
    ask_budget();  // a limit on all work stops it
    cell["skipped"] = reached.what();
  }
  return cell;
}

/// By the median: the first picture may have waited for something that others do not.
void Measurer::remember(const Json& cell) {
  Longest& longest = longest_[key_of(cell)];
  const double seconds = cell["time"]["median"].get<double>() * scene_->reference_seconds;
  longest.least_seconds = std::min(longest.least_seconds, seconds);
  if (seconds >= longest.seconds) {
    longest = {seconds, longest.least_seconds, scene_->polygons(), scene_->pixels()};
  }
}

std::optional<Json> Measurer::time_again(const Contender& contender, const Json& cell) {
  constexpr double kLong = 0.0005;
  const double once = cell["time"]["median"].get<double>() * scene_->reference_seconds;
  if (once > kLong) return std::nullopt;
  const int threads = cell["threads"];
  const auto drawing = scene_->drawing(contender, threads);
  drawing->draw_anew();
  return scene_->over_reference(effort_, threads, once, [&] { drawing->draw_anew(); });
}

void Measurer::measure(const Contender& contender, Json& cell) {
  const int threads = cell["threads"];
  const auto drawing = scene_->drawing(contender, threads);
  const double once = seconds_once([&] { drawing->draw_anew(); });
  cell["exact_stage_calls"] = 0;
  if (contender.counted) count_memory_and_exact_calls([&] { drawing->draw_anew(); }, cell);
  compare(drawing->judged(), cell);
  if (const auto pieces = drawing->pieces()) {
    cell["fragments_per_polygon"] =
        figure(static_cast<double>(pieces->made) /
               static_cast<double>(std::max<std::uint64_t>(1, pieces->of)));
  }
  cell["time"] = scene_->over_reference(effort_, threads, once, [&] { drawing->draw_anew(); });
  remember(cell);
  if (scene_->scene.kind != BenchScene::Kind::hard_case) {
    const double again = seconds_once([&] { drawing->draw_again(); });
    cell["time_again"] =
        scene_->over_reference(effort_, threads, again, [&] { drawing->draw_again(); });
  }
}

}  // namespace displayfile::bench
