#include "interp/visibility/warnock.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/visibility/close_depths.h"
#include "interp/visibility/decided_run.h"

namespace displayfile {

namespace {

/// Early finishing: at this many polygons, and at areas of this many pixels, scan conversion costs
/// less than further subdivision (measured: interp/visibility/warnock.md).
constexpr std::size_t kFewPolygons = 4;
constexpr long long kSmallArea = 32LL * 32;

}  // namespace

/// The data of one call: the stack of areas, the lists, and the visible fills of the rows.
class Warnock::Subdivision {
 public:
  Subdivision(const Warnock& warnock, int row_begin, int row_end);

  void run();
  void tell(const SeenRun& seen) const;

 private:
  /// An area still to be visited, and where its parent's list ends in lists_.
  struct Pending {
    SampleArea area;
    std::size_t list_begin, list_end;
  };
  /// A potentially visible polygon, and its category for the area: not disjoint.
  struct Listed {
    Fill fill;
    AreaCategory category;
  };

  void make_list(const Pending& pending);
  std::optional<Fill> nearest_surrounding();
  bool hides_over(Fill a, Fill b, const SampleArea& area);
  void remove_hidden();
  bool is_easy() const;
  void scan_convert();
  void subdivide();

  void paint(Fill fill, int row, int first, int end);
  Fill* row_of(int row) {
    return seen_.data() + static_cast<std::size_t>(row - screen_.first_row) *
                              static_cast<std::size_t>(screen_.columns());
  }
  std::span<Listed> list() { return std::span(lists_).subspan(list_begin_); }
  std::span<const Listed> list() const { return std::span(lists_).subspan(list_begin_); }

  const Warnock& warnock_;
  const ViewedScene& scene_;
  PictureSize size_;
  CloseDepths depths_;
  SampleArea screen_;  // all that is drawn

  SampleArea area_;         // the area being processed
  std::size_t list_begin_;  // of the area's list, the last in lists_
  std::vector<Listed> lists_;
  std::vector<Pending> pending_;
  std::vector<Fill> seen_;  // of the screen's pixels, row by row
  ScanConverter converter_;
};

Warnock::Subdivision::Subdivision(const Warnock& warnock, int row_begin, int row_end)
    : warnock_(warnock),
      scene_(warnock.request_->scene),
      size_(warnock.request_->size),
      depths_(scene_, warnock.depths_, size_),
      screen_{0, size_.width, row_begin, row_end},
      area_(screen_),
      list_begin_(0),
      seen_(static_cast<std::size_t>(screen_.columns()) * static_cast<std::size_t>(screen_.rows()),
            ViewedScene::kBackground) {}

/// The stack holds the areas still to come; their parents' lists lie in lists_ in the same order,
/// so entries after the list of the top area's parent belong to finished areas.
void Warnock::Subdivision::run() {
  for (Fill fill = 1; fill < scene_.end(); ++fill) {
    lists_.push_back({fill, AreaCategory::intersecting});
  }
  pending_.push_back({screen_, 0, lists_.size()});
  while (!pending_.empty()) {
    const Pending next = pending_.back();
    pending_.pop_back();
    make_list(next);
    remove_hidden();
    is_easy() ? scan_convert() : subdivide();
  }
}

/// Lists the polygons of the parent's list that are not disjoint. A polygon that surrounds the
/// parent's area surrounds this one too; the others are classified again.
void Warnock::Subdivision::make_list(const Pending& pending) {
  area_ = pending.area;
  lists_.resize(pending.list_end);
  list_begin_ = pending.list_end;
  for (std::size_t i = pending.list_begin; i < pending.list_end; ++i) {
    Listed listed = lists_[i];
    if (listed.category != AreaCategory::surrounding) {
      listed.category =
          category_of(scene_.vertices(listed.fill), warnock_.extents_[listed.fill], area_, size_);
    }
    if (listed.category != AreaCategory::disjoint) lists_.push_back(listed);
  }
}

/// The polygon visible in the middle of the area, among those that surround it.
std::optional<Warnock::Fill> Warnock::Subdivision::nearest_surrounding() {
  const int column = area_.first_column + area_.columns() / 2;
  const int row = area_.first_row + area_.rows() / 2;
  std::optional<Fill> nearest;
  for (const auto& [fill, category] : list()) {
    if (category != AreaCategory::surrounding) continue;
    if (!nearest || depths_.hides(fill, *nearest, column, row)) nearest = fill;
  }
  return nearest;
}

/// The difference of two planes' depths is linear: a sign at all corners holds between them.
bool Warnock::Subdivision::hides_over(Fill a, Fill b, const SampleArea& area) {
  const int left = area.first_column, right = area.end_column - 1;
  const int bottom = area.first_row, top = area.end_row - 1;
  return depths_.hides(a, b, left, bottom) && depths_.hides(a, b, right, top) &&
         depths_.hides(a, b, right, bottom) && depths_.hides(a, b, left, top);
}

void Warnock::Subdivision::remove_hidden() {
  const std::optional<Fill> nearest = nearest_surrounding();
  if (!nearest) return;
  const auto is_hidden = [&](const Listed& listed) {
    return listed.fill != *nearest &&
           hides_over(*nearest, listed.fill, intersection(area_, warnock_.extents_[listed.fill]));
  };
  const auto begin = lists_.begin() + static_cast<std::ptrdiff_t>(list_begin_);
  lists_.erase(std::remove_if(begin, lists_.end(), is_hidden), lists_.end());
}

/// The problem book's tests (a) to (d), and whether to finish early.
bool Warnock::Subdivision::is_easy() const {
  const bool small = static_cast<long long>(area_.columns()) * area_.rows() <= kSmallArea;
  return small || list().size() <= kFewPolygons;
}

void Warnock::Subdivision::scan_convert() {
  for (const Listed& listed : list()) {
    const Fill fill = listed.fill;
    if (listed.category == AreaCategory::surrounding) {
      for (int row = area_.first_row; row < area_.end_row; ++row) {
        paint(fill, row, area_.first_column, area_.end_column);
      }
      continue;
    }
    const ScanConverter::Region rows{size_, area_.first_row, area_.end_row};
    converter_.scan_convert(scene_.vertices(fill), rows, [&](int row, int first, int end) {
      paint(fill, row, std::max(first, area_.first_column), std::min(end, area_.end_column));
    });
  }
}

/// Divides the area into quarters, or into halves if it is more than twice as long as wide, so that
/// areas approach squares.
void Warnock::Subdivision::subdivide() {
  const auto [left, right, bottom, top] = area_;
  const int columns = area_.columns(), rows = area_.rows();
  const int middle_column =
      columns > 1 && 2 * static_cast<long long>(columns) >= rows ? left + columns / 2 : right;
  const int middle_row =
      rows > 1 && 2 * static_cast<long long>(rows) >= columns ? bottom + rows / 2 : top;
  for (const SampleArea& part : {SampleArea{middle_column, right, middle_row, top},
                                 SampleArea{left, middle_column, middle_row, top},
                                 SampleArea{middle_column, right, bottom, middle_row},
                                 SampleArea{left, middle_column, bottom, middle_row}}) {
    if (!part.empty()) pending_.push_back({part, list_begin_, lists_.size()});
  }
}

/// Paints the fill where it hides the present one, comparing in runs of pixels that show the same
/// fill.
void Warnock::Subdivision::paint(Fill fill, int row, int first, int end) {
  Fill* seen = row_of(row);
  while (first < end) {
    const Fill before = seen[first];
    int same = first + 1;
    while (same < end && seen[same] == before) ++same;
    DecidedRun run{same, same, true};
    if (before != ViewedScene::kBackground) {
      run = run_of(first, same, [&](int i) { return depths_.hides(fill, before, i, row); });
    }
    const auto shown = run.seen_from(first);
    std::fill(seen + shown.first, seen + shown.end, fill);
    first = run.end;
  }
}

void Warnock::Subdivision::tell(const SeenRun& seen) const {
  const auto width = static_cast<std::size_t>(screen_.columns());
  for (int row = screen_.first_row; row < screen_.end_row; ++row) {
    const auto start = static_cast<std::size_t>(row - screen_.first_row) * width;
    seen(row, 0, std::span(seen_).subspan(start, width));
  }
}

void Warnock::prepare(const Request& request, int /*threads*/) {
  request_.emplace(request);
  const ViewedScene& scene = request.scene;
  depths_ = FillDepths(scene, request.size, request.roundoff);
  extents_.assign(scene.end(), {});
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    extents_[fill] = extents_of(scene.vertices(fill), request.size);
  }
}

void Warnock::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  Subdivision subdivision(*this, row_begin, row_end);
  subdivision.run();
  subdivision.tell(seen);
}

}  // namespace displayfile
