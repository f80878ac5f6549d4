#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/surfaces.h"
#include "programs/bench/report.h"

namespace displayfile::bench {

/// How a method's time grows: the exponent of the power that fits best.
struct Fit {
  enum class Against { polygons, pixels };
  std::string scene;  ///< name
  std::string method, precision;
  Against against;
  std::size_t points;  ///< that it was fitted through
  double exponent;
};
std::string_view name_of(Fit::Against against);

/// A point of such a fit.
struct Growth {
  double size, time;  ///< time: in the reference's time on the first scene of the name
};

/// The scenes of a name at one picture size, by polygons, or with one number of polygons, by
/// pixels. Empty if there are fewer than two.
std::vector<const SceneRow*> series(const Report& report, std::string_view name,
                                    Fit::Against against);
/// On one thread; scenes that were skipped are left out.
std::vector<Growth> growth(std::span<const SceneRow* const> scenes, std::string_view method,
                           std::string_view precision);
/// On one thread, all that have two points at least.
std::vector<Fit> fits(const Report& report);

/// What was measured; null if nothing was.
const Cell* measured(const SceneRow& row, std::string_view method, std::string_view precision,
                     int threads = 1);

/// Those of the scene's cells on one thread that no other beats both in time and in wrong pixels,
/// by time.
std::vector<const Cell*> pareto_front(const SceneRow& row);

/// How `auto` compares with the fixed methods, exact, on one thread, over all scenes.
struct AutoBounds {
  std::size_t scenes;
  /// Its time over that of the fixed method that takes least in total; both are sums of reference
  /// times over the scenes.
  double total;
  std::string best_fixed;
  /// Its largest ratio to the best on a scene, there.
  double worst;
  std::string worst_scene, best_there;
  std::size_t above_twice;  ///< scenes on which it takes more than twice the best's time
};
/// Nothing if `auto` or all fixed methods were left out.
std::optional<AutoBounds> auto_bounds(const Report& report);

/// The scene of a name that is shown: that with the most polygons, and of these the largest
/// picture.
const SceneRow& shown_scene(const Report& report, std::string_view name);
/// The scene of that name with the largest picture, and of several such the one with the most
/// polygons.
const SceneRow& largest_picture(const Report& report, std::string_view name);
/// The names of the scenes that are of this kind, in order.
std::vector<std::string> names(const Report& report, BenchScene::Kind kind);
std::vector<std::string> names_but_hard_cases(const Report& report);

/// What a scene's name is in a table: for an input that of its file.
std::string short_name(const std::string& scene);

/// All but the hard cases and the walk: each picture is one by itself.
std::vector<const SceneRow*> still_scenes(const Report& report);
int most_threads(const Report& report);  ///< of any cell

/// The one value that several ratios would all have to have to give the same product.
double geometric_mean(const std::vector<double>& values);

/// A method at a precision, as a column or a curve.
struct Column {
  std::string method, precision;
  bool exact;
  bool is_automatic() const { return method == name_of(HiddenMethod::automatic); }
  std::string name() const { return precision.empty() ? method : method + ", " + precision; }
  bool operator==(const Column&) const = default;
};
std::vector<Column> columns(const Report& report);
/// Those whose growth is shown: the exact ones, and one precision of each other method.
bool is_in_series(const Column& column);

using Rows = std::vector<const SceneRow*>;

/// Those rows on which every one of the columns was measured, on one thread, that was tried on any.
/// What rests on them compares no method with another that was left out.
Rows with_nothing_left_out(const Report& report, Rows rows,
                           const std::function<bool(const Column&)>& wanted);

/// A column's mean over scenes; `place` is the column's in the tables.
struct Mean {
  Column column;
  double time;
  std::size_t place;
};
/// The geometric means of a cell's value, by size, of the columns that have one on all of the rows.
std::vector<Mean> means(const Report& report, const Rows& rows,
                        const std::function<bool(const Column&)>& wanted,
                        const std::function<std::optional<double>(const Cell&)>& value);
inline std::optional<double> time_of(const Cell& cell) { return cell.time.median; }

/// A method's place between speed and error.
struct SpeedAndError {
  Column column;
  double time;           ///< mean of a picture, in reference times
  double percent;        ///< of pixels that are wrong: of the hard cases, if there are any
  double percent_timed;  ///< the same of the scenes that were timed
};
/// All methods and peers but `auto`, which is one of them, over the scenes on which none was left
/// out.
struct FrontOfAll {
  std::vector<SpeedAndError> all;  ///< by time
  /// Those that none is both faster and more accurate than, by time; by either error.
  std::vector<SpeedAndError> front, front_timed;
  std::size_t scenes = 0, scenes_left_out = 0, hard_cases = 0;
};
/// Nothing if there is no such scene.
std::optional<FrontOfAll> front_of_all(const Report& report);

/// What was compared with that name on that scene; null if nothing was.
const Beside* find_beside(const Report& report, const std::string& scene, int threads,
                          std::string_view other, std::string_view what);

/// Sums over hard cases.
struct Wrong {
  std::int64_t wrong = 0, pixels = 0;
  double percent() const {
    return pixels == 0 ? 0.0 : 100.0 * static_cast<double>(wrong) / static_cast<double>(pixels);
  }
};
/// Those of a column on one thread, on the rows on which it was measured.
Wrong wrong_pixels(const Rows& rows, const Column& column);
/// The sides of the pictures of the hard cases: "32 x 32", or "16 x 16 to 24 x 24"; empty if there
/// are none.
std::string picture_sizes_of_hard_cases(const Report& report);
/// The wrong pixels of one family, or of all if the name is empty; on one thread. `gap` limits them
/// to that severity of the families with a gap, unless it is negative.
Wrong wrong_pixels(const Report& report, std::string_view family, const Column& column,
                   double gap = -1.0);

}  // namespace displayfile::bench
