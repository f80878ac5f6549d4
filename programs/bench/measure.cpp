#include "programs/bench/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hidden/predicate_counts.h"
#include "interp/truth.h"
#include "programs/bench/counted_memory.h"

namespace displayfile::bench {

struct Measurer::Scene {
  BenchScene scene;
  DisplayFile file;
  Picture truth;
  std::unique_ptr<Drawing> reference;
  double reference_seconds;

  explicit Scene(const BenchScene& s)
      : scene(s), file(s.make()), reference(reference_drawing(file, {s.size, s.size})) {
    reference->draw_anew();
    reference_seconds = seconds([&] { reference->draw_anew(); });
  }
  /// Polygons and pixels: what a method's time may be expected to grow with.
  double work() const { return static_cast<double>(file.polygons()) * scene.size * scene.size; }
};

namespace {

Spread figures(const Spread& s) { return {figure(s.least), figure(s.median), figure(s.greatest)}; }

/// As often as fills the time that is the least of a round's side.
int repetitions(double once, double least_seconds) {
  return static_cast<int>(std::clamp(std::ceil(least_seconds / std::max(once, 1e-9)), 1.0, 1e5));
}

double seconds_each(int times, const auto& work) {
  return seconds([&] {
           for (int i = 0; i < times; ++i) work();
         }) /
         times;
}

/// The work's time over the reference's, in turn; `once` is about what each takes.
Spread ratio(const Effort& effort, double once, const auto& work, double reference_once,
             const auto& reference) {
  const int times = repetitions(once, effort.least_seconds);
  const int reference_times = repetitions(reference_once, effort.least_seconds);
  const double round = once * times + reference_once * reference_times;
  const int rounds = std::clamp(static_cast<int>(effort.most_seconds / round), 1, effort.rounds);
  std::vector<double> ratios;
  for (int i = 0; i < rounds; ++i) {
    const double reference_seconds = seconds_each(reference_times, reference);
    ratios.push_back(seconds_each(times, work) / reference_seconds);
  }
  return figures(spread(std::move(ratios)));
}

std::uint64_t exact_calls() {
  std::uint64_t sum = 0;
  for (const StageCounts& count : predicate_counts()) sum += count.exact;
  return sum;
}

std::string key_text(const CellKey& key) {
  return fmt::format("{} {} {}", key.method, key.precision, key.threads);
}

}  // namespace

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
  scene_->truth = truth(scene_->file, scene.size, scene.size, true);
}

std::size_t Measurer::polygons() const { return scene_->file.polygons(); }

Spread Measurer::growth() {
  if (first_ == nullptr) return {1.0, 1.0, 1.0};
  return ratio(
      effort_, scene_->reference_seconds, [&] { scene_->reference->draw_anew(); },
      first_->reference_seconds, [&] { first_->reference->draw_anew(); });
}

/// What took long on a smaller scene of the name, and may take four times as long on twice the
/// work.
bool Measurer::too_long(const CellKey& key) const {
  constexpr double kTimesTheMost = 5.0;
  const auto longest = longest_.find(key_text(key));
  if (longest == longest_.end()) return false;
  const double growth = std::max(1.0, scene_->work() / longest->second.work);
  return longest->second.seconds * growth * growth > kTimesTheMost * effort_.most_seconds &&
         longest->second.seconds * growth > effort_.most_seconds;
}

void Measurer::compare(const Picture& picture, Cell& cell) const {
  const Picture& right = scene_->truth;
  double sum = 0.0;
  std::int64_t both = 0;
  for (std::size_t i = 0; i < right.ids.size(); ++i) {
    cell.wrong_pixels += picture.ids[i] != right.ids[i];
    if (!std::isfinite(picture.depth[i]) || !std::isfinite(right.depth[i])) continue;
    const double error = std::abs(picture.depth[i] - right.depth[i]);
    cell.largest_depth_error = std::max(cell.largest_depth_error, error);
    sum += error;
    ++both;
  }
  cell.largest_depth_error = figure(cell.largest_depth_error);
  cell.mean_depth_error = both == 0 ? 0.0 : figure(sum / static_cast<double>(both));
}

Cell Measurer::measure(const Contender& contender, int threads) {
  Cell cell;
  cell.key = {scene_->scene.id(), contender.method, contender.precision, threads};
  cell.exact = contender.exact;
  if (too_long(cell.key)) {
    cell.skipped = "it would take too long, from what a smaller one took";
    return cell;
  }
  const int size = scene_->scene.size;
  const auto drawing = contender.draw(scene_->file, {size, size, threads});
  double once = 0.0;
  const std::int64_t bytes =
      most_bytes_held([&] { once = seconds([&] { drawing->draw_anew(); }); });
  if (contender.counts_memory) cell.bytes = bytes;
  Longest& longest = longest_[key_text(cell.key)];
  if (once >= longest.seconds) longest = {once, scene_->work()};
  reset_predicate_counts();
  if (once <= effort_.most_seconds) once = seconds([&] { drawing->draw_anew(); });
  cell.exact_calls = exact_calls();
  compare(drawing->judged(), cell);
  if (const auto pieces = drawing->pieces()) {
    cell.fragments = figure(static_cast<double>(*pieces) /
                            static_cast<double>(std::max<std::size_t>(1, polygons())));
  }
  const auto reference = [&] { scene_->reference->draw_anew(); };
  cell.time = ratio(
      effort_, once, [&] { drawing->draw_anew(); }, scene_->reference_seconds, reference);
  if (scene_->scene.kind != BenchScene::Kind::hard_case) {
    const double again = seconds([&] { drawing->draw_again(); });
    cell.again = ratio(
        effort_, again, [&] { drawing->draw_again(); }, scene_->reference_seconds, reference);
  }
  return cell;
}

}  // namespace displayfile::bench
