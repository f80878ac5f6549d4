#include "tests/bench/command/line_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/visible_lines.h"
#include "interp/truth/judged_lines.h"
#include "tests/bench/command/contenders.h"
#include "tests/bench/command/counted_memory.h"
#include "tests/bench/command/measure.h"

namespace displayfile::bench {

std::string LineContender::precision_name() const { return name_of_precision(precision); }

std::vector<LineContender> line_contenders(std::span<const double> roundoffs) {
  std::vector<LineContender> all;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    const bool is_plain = entry.method == HiddenMethod::plain_appel;  // not to be fast
    if (!finds_lines(entry.method) || is_plain) continue;
    all.push_back({entry.method, {}});
    for (const double roundoff : roundoffs) all.push_back({entry.method, {false, roundoff}});
  }
  return all;
}

bool draws(const LineContender& contender, const BenchScene& scene) {
  return !needs_surface(contender.method) || scene.kind == BenchScene::Kind::surface;
}

struct LineMeasurer::Scene {
  std::string name, id;
  DisplayFile file;
  ViewedScene viewed;
  LineItems items;
  std::vector<TrueLine> truth;
  std::vector<LineName> names;  // of the same lines
  double reference_seconds = 0.0;

  Scene(const BenchScene& scene, int threads)
      : name(scene.name),
        id(scene.id_but_size()),
        file(scene.make()),
        viewed(file),
        items(file),
        truth(true_lines(items, items.all_lines(), threads)) {
    names.reserve(truth.size());
    for (const TrueLine& line : truth) {
      names.push_back({line.sharers.front().item, line.sharers.front().corner});
    }
    reference();
    reference_seconds = seconds_once([this] { reference(); });
  }

  SeenLines find(const LineContender& contender, int threads) const {
    return visible_lines(
        viewed.primitives(), names,
        {.method = contender.method, .precision = contender.precision, .threads = threads});
  }
  void reference() const { find({HiddenMethod::franklin, {}}, 1); }
};

LineMeasurer::LineMeasurer() = default;
LineMeasurer::~LineMeasurer() = default;

void LineMeasurer::take(const BenchScene& scene, const Effort& effort, int threads) {
  effort_ = effort;
  const bool same_name = scene_ != nullptr && scene_->name == scene.name;
  if (!same_name) {
    first_.reset();
    longest_.clear();
  } else if (first_ == nullptr) {
    first_ = std::move(scene_);
  }
  scene_ = std::make_unique<Scene>(scene, threads);
}

Json LineMeasurer::growth() {
  if (first_ == nullptr) return figures({1.0, 1.0, 1.0});
  return figures(ratio(
      effort_, Clock::processor, scene_->reference_seconds, [this] { scene_->reference(); },
      first_->reference_seconds, [this] { first_->reference(); }));
}

/// With the square of the lines at most.
bool LineMeasurer::too_long(const std::string& contender) const {
  constexpr double kTimesTheMost = 5.0;
  const auto before = std::ranges::find(longest_, contender, [](const auto& l) { return l.first; });
  if (before == longest_.end()) return false;
  const auto& [seconds, lines] = before->second;
  const double more = static_cast<double>(scene_->names.size()) / std::max(1.0, lines);
  return seconds * more * more > kTimesTheMost * effort_.most_seconds;
}

Json LineMeasurer::measure(const LineContender& contender, int threads) {
  Json cell = cell_of(scene_->id, contender.method_name(), contender.precision_name(), threads,
                      contender.precision.exact);
  const std::string name =
      fmt::format("{}, {}, {}", contender.method_name(), contender.precision_name(), threads);
  if (too_long(name)) {
    cell["skipped"] = "it would take too long, from what a smaller one took";
    return cell;
  }
  try {
    measure(contender, name, cell);
  } catch (const LimitReached& reached) {
    ask_budget();  // a limit on all work stops it
    cell["skipped"] = reached.what();
  }
  return cell;
}

void LineMeasurer::measure(const LineContender& contender, const std::string& name, Json& cell) {
  const int threads = cell["threads"];
  const Scene& scene = *scene_;
  SeenLines seen;
  const double once = seconds_once([&] { seen = scene.find(contender, threads); });
  std::erase_if(longest_, [&](const auto& l) { return l.first == name; });
  longest_.push_back({name, {once, static_cast<double>(scene.names.size())}});
  count_memory_and_exact_calls([&] { scene.find(contender, threads); }, cell);
  const LineErrors errors = compare_lines(scene.items, scene.truth, claimed_pieces(seen));
  cell["lines"] = scene.names.size();
  cell["pieces"] = seen.pieces.size();
  cell["length"] = figure(errors.length);
  cell["missing_length"] = figure(errors.missing);
  cell["extra_length"] = figure(errors.extra);
  cell["time"] = figures(ratio(
      effort_, clock_of(threads), once, [&] { scene.find(contender, threads); },
      scene.reference_seconds, [&] { scene.reference(); }));
}

}  // namespace displayfile::bench
