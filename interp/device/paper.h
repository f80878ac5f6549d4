#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/looks/style.h"

/// Pictures on paper: what an application asks for (DrawOptions). All lengths are millimetres.
namespace displayfile {

/// A sheet of paper on which a picture of vectors is drawn, as large as fits between its margins
/// and in the middle.
struct Paper {
  enum class Turned { automatic, portrait, landscape };
  double width = 210.0, height = 297.0;
  double margin = 10.0;
  /// automatic: landscape if the picture is wider than high, portrait if it is not.
  Turned turned = Turned::automatic;
  bool operator==(const Paper&) const = default;
};

/// A4, A3 and so on from A0 to A6, letter, legal, tabloid, in letters of either case, or WxH, which
/// stays as it is; after each of them -portrait or -landscape if it is to lie so. Throws Error for
/// any other word, and for sides that are not 1 to kLargestSheet.
Paper paper_of(std::string_view word);
std::vector<std::string> sheet_names();  ///< a4 and so on, without those of WxH
inline constexpr double kLargestSheet = 10'000.0;

inline constexpr double kPointsOfMillimetre = 72.0 / 25.4;  ///< of PDF

/// Where a picture of so many pixels lies on a sheet.
struct PaperFit {
  double width, height;  ///< of the sheet as it lies
  double left, top;      ///< the picture's upper left corner, from that of the sheet
  double pixel;          ///< a pixel's side
};
/// Throws Error if the margins leave nothing, or are negative, or for a sheet that paper_of
/// refuses.
PaperFit fit_on_paper(const Paper& paper, int picture_width, int picture_height);

/// Fills as parallel lines: the darker a fill, the more of them.
struct Hatching {
  double spacing = 1.0;  ///< of lines where the fill is as dark as the pen
  double angle = 45.0;   ///< degrees, counterclockwise from the horizontal
  bool cross = false;    ///< what is darker than the middle tone gets lines at right angles too
  std::optional<Colour> colour{};  ///< of the pen; black if not said, white on dark paper
  double width = 0.3;              ///< of the pen's line
  bool operator==(const Hatching&) const = default;
};
inline constexpr double kClosestHatching = 0.05;

/// A picture drawn by pens, or cut by a laser: lines in a layer for each pen, none twice, in an
/// order in which the pen travels little (interp/vector/pens/README.md).
struct Pens {
  std::optional<Hatching> hatching{};  ///< none: fills are not drawn
  bool crumbs = false;                 ///< as VectorOptions::crumbs
  bool operator==(const Pens&) const = default;
};
/// Throws Error for lengths or angles that are out of their range.
void require_pens(const Pens& pens);

}  // namespace displayfile
