#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/geometry/rectangle.h"
#include "clip/point.h"
#include "displayfile/entered/kept_annotation.h"
#include "interp/annotation/annotation_marks.h"

namespace displayfile {

/// Annotation on a page, before its lines and texts are made. In pixels from the lower left corner,
/// y up.
struct PageAnnotation {
  /// Where the text of a leader is, from the leader's end.
  enum class Side { left, right, above, below };

  const KeptAnnotation* kept;
  double height;               ///< of capital letters
  std::vector<Point2> points;  ///< of `kept`
  /// For leaders, the end of the line beside the text; for balloons, the circle's centre.
  Point2 at{0.0};
  Side side = Side::right;
  std::optional<Point2> line_end = std::nullopt;  ///< of a balloon's line; none: toward the centre
  Point2 corner{0.0};                             ///< of a list: signs, from the page's middle
  std::optional<Point2> top_left = std::nullopt;  ///< of a list that stands in no corner
  /// How far beyond the circle the number of a radius or a diameter stands, from the second point,
  /// or, below 0, from the first point of a diameter. None: where it has room beside the circle.
  std::optional<double> number_beyond = std::nullopt;
  /// The height of a title, as an index of kTitleHeights: 0 is the usual one.
  std::size_t title_reduced = 0;
  bool has_place = true;  ///< false: placed automatically, and there was no room

  bool is_automatic() const {
    return kept->style.placement == AnnotationStyle::Placement::automatic;
  }
};

/// A row of the parts list: the balloons with that number and that name.
struct PartsListRow {
  int number;
  std::string name;
  int quantity;
};

/// The rows that balloons with names make, by number, then in order of entry.
std::vector<PartsListRow> parts_list_rows(std::span<const KeptAnnotation> all);
/// A sentence on numbers with several names, and one on names with several numbers, if there are
/// some: a part has one number (ISO 6433).
std::vector<std::string> parts_list_faults(std::span<const PartsListRow> rows);
/// Heights of a title's capitals, in parts of the annotation's size: that of ISO 3098 after the
/// next, then smaller ones.
inline constexpr std::array kTitleHeights{1.43, 1.0, 0.71};
/// The heads of the columns of every parts list. Item and quantity stand in the middle of their
/// columns.
inline constexpr std::array<std::string_view, 3> kPartsListHeads{"ITEM", "PART", "QTY"};

/// An annotation in words, as a part of a sentence: `balloon 3`.
std::string name_in_message(const KeptAnnotation& kept);

/// Makes the lines, areas and texts of annotation. Proportions are those of ISO 128-2, line group
/// 0.5: letters 3.5 mm high, narrow lines 0.25 mm wide.
class AnnotationPencil {
 public:
  AnnotationPencil(const AnnotationPage& page, std::vector<AnnotationMark>& marks)
      : page_(page), marks_(marks) {}

  /// Draws one annotation; `number` is its place in order of entry.
  void draw(const PageAnnotation& annotation, std::size_t number,
            std::span<const PartsListRow> rows);

  static double line_width(double height) { return height / 14.0; }
  /// The radius of a balloon's circle.
  static double balloon_radius(const PageAnnotation& balloon);
  /// From the end of a leader's line to the end of its text.
  static double leader_width(const PageAnnotation& leader);
  /// Between a list and the page's border.
  static double margin_of_list(double height);

 private:
  // leader_marks.cpp
  void leader(const PageAnnotation& leader);
  void balloon(const PageAnnotation& balloon);
  void leader_end(const Point2& at, const Point2& from);
  // dimension_marks.cpp
  void dimension_line(const Point2& from, const Point2& to);
  void diameter(const PageAnnotation& diameter);
  bool arrows_of_line(const Point2& start, const Point2& end, const Point2& direction);
  void number_on_line(const Point2& start, double before, const Point2& direction);
  void extension_line(const Point2& from, const Point2& to);
  void radius(const PageAnnotation& radius);
  void angle(std::span<const Point2> points);
  void outer_arrow(const Point2& tip, const Point2& direction);
  // table_marks.cpp
  void title(const PageAnnotation& title);
  void parts_list(const PageAnnotation& list, std::span<const PartsListRow> rows);
  // annotation_pencil.cpp
  double arrow_length() const { return 0.9 * height_; }
  double width_of(std::string_view characters) const;
  AnnotationMark& add(AnnotationMark::Kind kind);
  void line(std::vector<Point2> points, bool closed = false);
  void arrow(const Point2& tip, const Point2& direction);
  std::vector<Point2> circle(const Point2& centre, double radius) const;
  /// A text with the middle of its base line, or the end of the base line that the alignment
  /// names, at a point, running in a direction of length 1.
  void text(std::string_view characters, const Point2& at, TextStyle::Alignment alignment,
            const Point2& direction = {1.0, 0.0});

  const AnnotationPage& page_;
  std::vector<AnnotationMark>& marks_;
  const KeptAnnotation* kept_ = nullptr;
  std::size_t number_ = 0;
  double height_ = 0.0;
};

/// The points that marks reach, with the corners of their texts.
std::vector<Point2> points_of(std::span<const AnnotationMark> marks, const AnnotationPage& page);

/// The width of a text in parts of its capitals' height: an estimate from above for common
/// sans-serif fonts.
double width_of_text(std::string_view characters);

/// The height of capital letters, in parts of the font's size.
inline constexpr double kCapitalsOfEm = 0.72;

}  // namespace displayfile
