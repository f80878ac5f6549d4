#include "displayfile/hidden_surface_check.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "clip/error.h"
#include "displayfile/intensity_plane.h"

namespace displayfile {

namespace {

/// What a polygon or a line is drawn in; of a line the pick identifier has no meaning.
struct ItemStyle {
  std::uint32_t fill, line;  ///< indices of styles
  std::int32_t pick;
};

/// The polygons and lines to be sorted, in order of entry.
struct SavedPolygons {
  struct FirstItem {
    int segment;
    std::size_t item;
  };

  std::span<const Point3> points;  ///< the entered instructions' own, or else own_points
  std::vector<Point3> own_points;
  std::vector<std::uint8_t> visible;
  std::vector<SortItems::Item> items;
  std::vector<ItemStyle> attributes;  ///< of the items
  std::vector<FillStyle> fill_styles;
  std::vector<LineStyle> line_styles;
  std::vector<FirstItem> segments;  ///< none where all is one segment's
  /// Of shaded polygons, a run of intensities each.
  std::vector<double> intensities;
  std::vector<std::uint32_t> first_intensity;  ///< of items up to the last shaded one, or kNone
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  SortItems to_sort() const { return {points, visible, items}; }
  std::span<const Point3> points_of(std::size_t item) const {
    return points.subspan(items[item].first, items[item].sides);
  }
  /// Empty if it is not shaded.
  std::span<const double> intensities_of(std::size_t item) const {
    if (item >= first_intensity.size() || first_intensity[item] == kNone) return {};
    return std::span(intensities).subspan(first_intensity[item], items[item].sides);
  }
};

/// Which segment's instructions to save, and its image transformation.
struct Source {
  const Instructions& entered;
  const ImageTransformation& image;
};

/// Visits the entered instructions and saves what draws something.
class Saver {
 public:
  Saver(SavedPolygons& saved, bool in_place)
      : saved_(saved), in_place_(in_place), points_(saved.visible.size()) {
    fill(FillStyle{});
    line_style(LineStyle{});
  }

  void fill(const FillStyle& style) {
    if (saved_.fill_styles.empty() || saved_.fill_styles.back() != style) {
      saved_.fill_styles.push_back(style);
    }
    solid_ = style.kind == FillStyle::Kind::solid;
  }
  void line_style(const LineStyle& style) {
    if (saved_.line_styles.empty() || saved_.line_styles.back() != style) {
      saved_.line_styles.push_back(style);
    }
    outlined_ = style.kind != LineStyle::Kind::none;
  }
  void pick(std::int32_t id) { pick_ = id; }
  void intensities(std::span<const double> values) { intensities_ = values; }
  void move(const Point3& p) { take({&p, 1}); }
  void line(const Point3& p) {
    take({&p, 1});
    saved_.visible.back() = 1;
    if (outlined_) save(points_ - 2, 2, SortItems::Kind::line);
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    save_poly_for_hsc(vertices, sides);
  }

 private:
  /// SAVE-POLY-FOR-HSC (algorithm 9.7): collects one polygon.
  void save_poly_for_hsc(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const std::size_t first = points_;
    take(vertices);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      saved_.visible[first + i] = sides[i] == op::line ? 1 : 0;
    }
    if (solid_) {
      save_intensities();
      save(first, vertices.size(), SortItems::Kind::solid);
    } else if (outlined_) {
      save(first, vertices.size(), SortItems::Kind::hollow);
    }
  }

  /// Of the item saved next.
  void save_intensities() {
    if (intensities_.empty()) return;
    saved_.first_intensity.resize(saved_.items.size(), SavedPolygons::kNone);
    saved_.first_intensity.push_back(static_cast<std::uint32_t>(saved_.intensities.size()));
    saved_.intensities.insert(saved_.intensities.end(), intensities_.begin(), intensities_.end());
    intensities_ = {};
  }

  /// Counts the points, which are in place already, or else takes copies.
  void take(std::span<const Point3> points) {
    points_ += points.size();
    saved_.visible.resize(points_, 0);
    if (in_place_) return;
    saved_.own_points.insert(saved_.own_points.end(), points.begin(), points.end());
  }

  void save(std::size_t first, std::size_t sides, SortItems::Kind kind) {
    saved_.items.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(sides), kind});
    saved_.attributes.push_back({static_cast<std::uint32_t>(saved_.fill_styles.size() - 1),
                                 static_cast<std::uint32_t>(saved_.line_styles.size() - 1), pick_});
  }

  SavedPolygons& saved_;
  bool in_place_;
  std::size_t points_;  // seen so far
  bool solid_ = true, outlined_ = true;
  std::int32_t pick_ = -1;
  std::span<const double> intensities_;  // of the polygon that follows
};

void require_countable(std::size_t points) {
  if (points >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to sort hidden surfaces: expected fewer than 2^32 - 1");
  }
}

void reserve(SavedPolygons& saved, std::size_t points, std::size_t items) {
  require_countable(points);
  saved.visible.reserve(points);
  saved.items.reserve(items);
  saved.attributes.reserve(items);
}

SavedPolygons saved(const Source& source) {
  const Instructions& entered = source.entered;
  SavedPolygons saved;
  reserve(saved, entered.points(), entered.polygons() + entered.lines());
  const bool in_place = entered.stores_z() && source.image.is_identity();
  if (!in_place) saved.own_points.reserve(entered.points());
  entered.walk_transformed(source.image, Saver(saved, in_place));
  saved.points = in_place ? entered.stored_points() : saved.own_points;
  return saved;
}

SavedPolygons saved(std::span<const Segment* const> segments) {
  std::size_t points = 0, items = 0;
  for (const Segment* segment : segments) {
    points += segment->entered()->points();
    items += segment->polygons() + segment->lines();
  }
  SavedPolygons saved;
  reserve(saved, points, items);
  saved.own_points.reserve(points);
  for (const Segment* segment : segments) {
    saved.segments.push_back({segment->name(), saved.items.size()});
    segment->walk_entered_drawn(Saver(saved, false));
  }
  saved.points = saved.own_points;
  return saved;
}

/// Enters pieces into the display file in the order in which the sort put them.
class OrderedOutput {
 public:
  OrderedOutput(const SavedPolygons& saved, const SortedPieces& sorted, Instructions& out)
      : saved_(saved), sorted_(sorted), out_(out) {}

  /// SAVE-POLYGONS-IN-ORDER (algorithm 9.16).
  void save_polygons_in_order() {
    reserve_output();
    for (const SortedPiece& piece : sorted_.pieces) {
      check_segment(piece.item);
      send_to_df(piece);
    }
  }

 private:
  /// SEND-TO-DF (algorithm 9.17).
  void send_to_df(const SortedPiece& piece) {
    const SortItems::Item& item = saved_.items[piece.item];
    const ItemStyle& attributes = saved_.attributes[piece.item];
    const auto [points, visible] = sides_of(piece, item);
    if (item.kind == SortItems::Kind::line) {
      out_.set_style(saved_.line_styles[attributes.line]);
      out_.enter_line(points[0], points[1]);
    } else {
      check_style(attributes);
      enter_polygon(points, visible, intensities_of(piece, points));
    }
  }

  /// CHECK-STYLE (algorithm 9.18): the instructions enter a style only where it changes.
  void check_style(const ItemStyle& attributes) {
    out_.set_style(saved_.fill_styles[attributes.fill]);
    out_.set_style(saved_.line_styles[attributes.line]);
    out_.set_pick(attributes.pick);
  }

  /// Growing as they are filled, the arrays would for a moment be there twice.
  void reserve_output() {
    std::size_t points = 0;
    for (const SortedPiece& piece : sorted_.pieces) points += piece.sides;
    constexpr std::size_t kOtherCodes = 3;  // the polygon's own, and a pick identifier
    out_.reserve(points + kOtherCodes * sorted_.pieces.size(), points);
  }

  void check_segment(std::uint32_t item) {
    if (saved_.segments.empty()) return;
    const auto after =
        std::ranges::upper_bound(saved_.segments, item, {}, &SavedPolygons::FirstItem::item);
    const int segment = std::prev(after)->segment;
    if (segment != segment_) out_.enter_segment(segment);
    segment_ = segment;
  }

  struct Sides {
    std::span<const Point3> points;
    std::span<const std::uint8_t> visible;
  };
  Sides sides_of(const SortedPiece& piece, const SortItems::Item& item) const {
    if (piece.first == SortedPiece::kWhole) {
      return {saved_.points_of(piece.item),
              std::span(saved_.visible).subspan(item.first, item.sides)};
    }
    return {std::span(sorted_.points).subspan(piece.first, piece.sides),
            std::span(sorted_.visible).subspan(piece.first, piece.sides)};
  }

  /// A piece of a shaded polygon lies in the picture of the whole one.
  std::span<const double> intensities_of(const SortedPiece& piece, std::span<const Point3> points) {
    const auto of_whole = saved_.intensities_of(piece.item);
    if (of_whole.empty() || piece.first == SortedPiece::kWhole) return of_whole;
    const IntensityPlane plane(saved_.points_of(piece.item), of_whole);
    intensities_.clear();
    for (const Point3& p : points) intensities_.push_back(plane.at(p));
    return intensities_;
  }

  /// A piece of an edge-on polygon may be a single side; a polygon instruction has three or more.
  void enter_polygon(std::span<const Point3> points, std::span<const std::uint8_t> visible,
                     std::span<const double> intensities) {
    if (points.size() >= 3) return out_.enter_polygon(points, visible, intensities);
    std::vector<Point3> padded(points.begin(), points.end());
    std::vector<std::uint8_t> sides(visible.begin(), visible.end());
    padded.resize(3, points.back());
    sides.resize(3, 0);
    std::vector<double> of_padded(intensities.begin(), intensities.end());
    if (!intensities.empty()) of_padded.resize(3, intensities.back());
    out_.enter_polygon(padded, sides, of_padded);
  }

  const SavedPolygons& saved_;
  const SortedPieces& sorted_;
  Instructions& out_;
  int segment_ = 0;                  // names are 1 or more
  std::vector<double> intensities_;  // of one piece
};

SortedInstructions sorted_from(const SavedPolygons& saved, const ImageTransformation& image,
                               HiddenMethod method, const SortOptions& options) {
  const SortedPieces pieces = sort_hidden_surfaces(saved.to_sort(), method, options);
  SortedInstructions sorted{{}, image, method, options.precision, {}};
  sorted.counts = {pieces.pieces.size(), pieces.cuts, pieces.comparisons, pieces.depth};
  OrderedOutput(saved, pieces, sorted.instructions).save_polygons_in_order();
  return sorted;
}

}  // namespace

bool sorts(HiddenMethod method) {
  return method == HiddenMethod::bsp || method == HiddenMethod::depth_sort;
}

SortedInstructions hidden_surface_check(const Instructions& entered,
                                        const ImageTransformation& image, HiddenMethod method,
                                        const SortOptions& options) {
  return sorted_from(saved({entered, image}), image, method, options);
}

SortedInstructions hidden_surface_check(std::span<const Segment* const> segments,
                                        HiddenMethod method, const SortOptions& options) {
  return sorted_from(saved(segments), {}, method, options);
}

}  // namespace displayfile
