#include "displayfile/segments/sorted_display_file.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/hidden_surface_check.h"

namespace displayfile {

namespace {

bool is_of(const SortedScene& sorted, const SurfacePlan& plan) {
  return sorted.plan.finds_as(plan) &&
         (sorted.plan.shadows == plan.shadows || !sorted.has_shadows()) &&
         is_within_limit(sorted, plan);
}

/// Instructions of closed segments do not change: the same pointer, the same instructions.
bool draw_the_same(const Segment& a, const Segment& b) {
  return a.name() == b.name() && a.entered() == b.entered() && a.image == b.image;
}

/// The plan by which close-segment sorted it, or would have if the scope were not `all`.
std::optional<SurfacePlan> as_closed(const Segment& segment) {
  return segment.sorted() == nullptr ? segment.put_off : segment.sorted()->plan;
}

/// One order for all groups, which do not overlap.
std::shared_ptr<const SortedScene> joined(
    std::span<const std::shared_ptr<const SortedScene>> groups, const SurfacePlan& plan) {
  auto all = std::make_shared<SortedScene>();
  all->plan = plan.kept();
  all->plan.most_pieces = most_pieces_of_sort(plan, 0);
  for (const auto& group : groups) {
    all->parts.insert(all->parts.end(), group->parts.begin(), group->parts.end());
    all->counts += group->counts;
  }
  return all;
}

}  // namespace

void require_hidden_lines_found(HiddenLines hidden_lines, HiddenMethod method) {
  if (hidden_lines == HiddenLines::none || is_object_space(method) || !is_colour_rule(method)) {
    return;
  }
  const std::string name(name_of(method));
  throw Error(
      "hidden lines are not drawn by hidden-line method '" + name +
      "': expected colour-rule=bsp, colour-rule=depth-sort, colour-rule=map, a method that finds "
      "lines, or hidden lines none");
}

namespace {

/// The method and scope by which an update sorts.
struct SortWanted {
  HiddenMethod method;
  bool is_applications;  ///< the application set the method
  HiddenScope set;       ///< the scope before that of the options
  HiddenScope scope;     ///< in force

  bool together() const { return is_object_space(method) && scope == HiddenScope::all; }
  /// True if each segment is sorted by itself, in place of the order that close-segment made.
  bool each_anew() const {
    return is_object_space(method) && !together() &&
           !(is_applications && set == HiddenScope::segment);
  }
};

SortWanted sort_wanted(const GraphicsSystem& system, const HiddenSurfaceOptions& options,
                       const SurfacePlan& plan, HiddenMethod by) {
  const HiddenMethod named = surfaces_of(by), set_method = surfaces_of(plan.method);
  const HiddenMethod method = named == HiddenMethod::automatic ? HiddenMethod::map : named;
  const bool applications = !options.method && set_method == method;
  const bool finds_shadows =
      plan.shadows && method == HiddenMethod::map && system.display_file().has_shadows();
  const auto usual = applications && !finds_shadows ? HiddenScope::segment : HiddenScope::all;
  const HiddenScope set = system.hidden_surfaces().scope.value_or(usual);
  const bool picked = set_method == HiddenMethod::automatic || plan.line_order == LineOrder::depth;
  return {method, applications, set, picked ? HiddenScope::all : options.scope.value_or(set)};
}

}  // namespace

bool sorts_together(const GraphicsSystem& system, const HiddenSurfaceOptions& options,
                    const SurfacePlan& plan, HiddenMethod by) {
  return sort_wanted(system, options, plan, by).together();
}

const DisplayFile& SortedDisplayFile::update(const GraphicsSystem& system,
                                             const HiddenSurfaceOptions& options,
                                             const SurfacePlan& plan, HiddenMethod by) {
  const BudgetInForce in_force(plan.budget);
  const SortWanted wanted = sort_wanted(system, options, plan, by);
  const HiddenMethod method = wanted.method;
  const SurfacePlan sort = plan.by(method);
  return sort_anew(system.display_file(), [&] {
    if (wanted.together()) {
      sort_together(sort);
    } else if (wanted.each_anew()) {
      sort_segments(sort);
    } else if (options.method && !is_object_space(method)) {
      unsort();
    } else {
      sort_as_closed(options, sort);
    }
  });
}

const DisplayFile& SortedDisplayFile::update(const DisplayFile& entered, const SurfacePlan& plan) {
  const BudgetInForce in_force(plan.budget);
  return sort_anew(entered, [&] {
    if (plan.scope == HiddenScope::segment && plan.line_order == LineOrder::entry) {
      sort_segments(plan);
    } else {
      sort_together(plan);
    }
  });
}

template <class Sort>
const DisplayFile& SortedDisplayFile::sort_anew(const DisplayFile& entered, const Sort& sort) {
  last_ = std::exchange(file_, entered);
  try {
    sort();
  } catch (...) {
    file_ = std::exchange(last_, {});
    throw;
  }
  last_ = {};
  return file_;
}

void SortedDisplayFile::sort_as_closed(const HiddenSurfaceOptions& options,
                                       const SurfacePlan& plan) {
  for (const Segment& segment : file_.segments()) {
    const auto by = as_closed(segment);
    if (!segment.visible || !by) continue;
    SurfacePlan anew = plan.by(by->method);
    if (!options.precision) anew.precision = by->precision;
    if (!options.hidden_lines) anew.hidden_lines = by->hidden_lines;
    anew.intersections = by->intersections;
    sort_segment(segment, anew);
  }
}

void SortedDisplayFile::sort_segments(const SurfacePlan& plan) {
  for (const Segment* segment : file_.visible_segments()) sort_segment(*segment, plan);
}

/// Uses the order of the segment itself or of the last update, if one of them is still valid.
void SortedDisplayFile::sort_segment(const Segment& segment, const SurfacePlan& set) {
  SurfacePlan plan = set;
  plan.shadows = false;  // other segments hide the light too
  const auto will_do = [&](const Segment& s) {
    return s.sorted_as_drawn() && is_of(*s.sorted(), plan);
  };
  if (will_do(segment)) return;
  const int name = segment.name();
  if (last_.contains(name)) {
    const Segment& before = std::as_const(last_).segment(name);
    if (draw_the_same(before, segment) && will_do(before)) {
      return file_.segment(name).set_sorted(before.sorted());
    }
  }
  file_.segment(name).set_sorted(hidden_surface_check(segment.entered(), segment.image, plan));
}

void SortedDisplayFile::sort_together(const SurfacePlan& plan) {
  const auto segments = file_.visible_segments();
  const bool all_in_one = plan.shadows && plan.method == HiddenMethod::map && file_.has_shadows();
  const auto groups = all_in_one ? std::vector<SegmentGroup>{{segments.begin(), segments.end()}}
                                 : overlapping_groups(segments);
  std::unordered_map<int, SortedGroup> kept;
  std::vector<std::shared_ptr<const SortedScene>> orders;
  work_ = {.groups = groups.size()};
  for (const SegmentGroup& group : groups) {
    const int name = group.front()->name();
    orders.push_back(kept.emplace(name, sorted_group(group, plan)).first->second.sorted);
  }
  const auto before = last_.sorted();
  const bool unchanged = before != nullptr && is_of(*before, plan) && work_.sorted == 0 &&
                         kept.size() == groups_.size();
  groups_ = std::move(kept);
  if (unchanged) return file_.set_sorted(before);
  if (orders.size() == 1) return file_.set_sorted(orders.front());
  file_.set_sorted(joined(orders, plan));
}

/// Sorts the group, unless the last update did.
SortedDisplayFile::SortedGroup SortedDisplayFile::sorted_group(const SegmentGroup& group,
                                                               const SurfacePlan& plan) {
  const auto before = groups_.find(group.front()->name());
  if (before != groups_.end() && is_of(*before->second.sorted, plan) &&
      std::ranges::equal(before->second.segments, group,
                         [](const Segment& a, const Segment* b) { return draw_the_same(a, *b); })) {
    return before->second;
  }
  ++work_.sorted;
  SortedGroup now;
  for (const Segment* segment : group) now.segments.push_back(*segment);
  now.sorted = hidden_surface_check(group, plan);
  return now;
}

void SortedDisplayFile::unsort() {
  for (const Segment& segment : file_.segments()) file_.segment(segment.name()).set_sorted(nullptr);
}

SortCounts counts_of_sorts(const DisplayFile& display_file) {
  if (display_file.sorted() != nullptr) return display_file.sorted()->counts;
  SortCounts sum;
  for (const Segment* segment : display_file.visible_segments()) {
    if (segment->sorted() != nullptr) sum += segment->sorted()->counts;
  }
  return sum;
}

bool has_exact_order(const DisplayFile& display_file) {
  if (display_file.sorted() != nullptr) return display_file.sorted()->plan.precision.exact;
  return std::ranges::any_of(display_file.segments(), [](const Segment& segment) {
    return segment.visible && segment.sorted() != nullptr && segment.sorted()->plan.precision.exact;
  });
}

}  // namespace displayfile
