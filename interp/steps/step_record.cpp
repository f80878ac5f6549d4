#include "interp/steps/step_record.h"

#include <fmt/format.h>

#include "clip/base/error.h"
#include "clip/base/work_budget.h"

namespace displayfile {

StepRecord::StepRecord(const StepItems& scene, Steps& steps, std::size_t most_steps)
    : scene_(scene),
      steps_(steps),
      most_steps_(most_steps),
      cuts_(scene.polygons()),
      picture_(static_cast<std::size_t>(scene.size().width) *
                   static_cast<std::size_t>(scene.size().height),
               kBackground) {}

Step& StepRecord::step(int line, std::string sentence) {
  if (steps_.steps.size() >= most_steps_) {
    throw LimitReached(
        fmt::format("{} takes more than {} steps for this scene: expected fewer polygons, a "
                    "smaller picture (--size), or a higher limit (--limit-steps)",
                    name_of(steps_.method), most_steps_));
  }
  return steps_.steps.emplace_back(Step{line, std::move(sentence)});
}

std::string StepRecord::names(std::span<const std::uint32_t> pieces) const {
  if (pieces.empty()) return "nothing";
  std::string all;
  const std::size_t named = pieces.size() <= kMostNames ? pieces.size() : kMostNames - 1;
  for (std::size_t k = 0; k < named; ++k) {
    if (k > 0) all += k + 1 == pieces.size() ? " and " : ", ";
    all += name(pieces[k]);
  }
  if (named < pieces.size()) all += fmt::format(" and {} more", pieces.size() - named);
  return all;
}

std::uint32_t StepRecord::add_piece(std::uint32_t of, std::vector<Point3> points) {
  const std::uint32_t polygon = steps_.pieces[of].polygon;
  steps_.pieces.push_back({fmt::format("{}{}", name_of_polygon(polygon), ++cuts_[polygon]), polygon,
                           std::move(points)});
  return static_cast<std::uint32_t>(steps_.pieces.size() - 1);
}

void StepRecord::mark(StepMark mark) {
  if (last().marks.size() < kMostMarks) last().marks.push_back(std::move(mark));
}
void StepRecord::mark(StepRole role, std::uint32_t piece) {
  mark({StepMark::Kind::piece, role, piece});
}
void StepRecord::mark(StepRole role, std::vector<Point2> points, StepMark::Kind kind, bool stays) {
  mark({kind, role, 0, std::move(points), {}, stays});
}
void StepRecord::mark(StepRole role, const PixelBox& box, bool stays) {
  mark({StepMark::Kind::box, role, 0, {}, box, stays});
}

void StepRecord::show(int panel, std::vector<StepRow> rows) {
  last().panels.push_back({panel, std::move(rows)});
}
void StepRecord::show_segments(int panel, std::vector<StepSegment> segments) {
  if (segments.size() > kMostSegments) segments.resize(kMostSegments);
  last().panels.push_back({panel, {}, {}, std::move(segments)});
}
void StepRecord::show_node(int panel, StepNode node) {
  for (PanelChange& change : last().panels) {
    if (change.panel == panel) return change.nodes.push_back(std::move(node));
  }
  last().panels.push_back({panel, {}, {std::move(node)}});
}

template <class Keeps>
int StepRecord::paint(const StepRun& run, Keeps&& keeps) {
  int gained = 0;
  auto* row =
      &picture_[static_cast<std::size_t>(run.row) * static_cast<std::size_t>(scene_.size().width)];
  auto& runs = last().gained;
  for (int i = run.first; i < run.end; ++i) {
    if (row[i] == run.polygon || (row[i] != kBackground && keeps(row[i], i))) continue;
    row[i] = run.polygon;
    ++gained;
    const bool goes_on = !runs.empty() && runs.back().row == run.row && runs.back().end == i &&
                         runs.back().polygon == run.polygon;
    if (goes_on) {
      ++runs.back().end;
    } else {
      runs.push_back({run.row, i, i + 1, run.polygon});
    }
  }
  return gained;
}

int StepRecord::paint_over(const StepRun& run) {
  return paint(run, [&](Polygon there, int column) {
    return there > run.polygon && scene_.depth_order(run.polygon, there, column, run.row) == 0;
  });
}
int StepRecord::paint_nearer(const StepRun& run) {
  return paint(run, [&](Polygon there, int column) {
    return !scene_.hides(run.polygon, there, column, run.row);
  });
}

std::string counted(std::size_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

Point2 flat(const Point3& p) { return {p.x, p.y}; }

}  // namespace displayfile
