#include "programs/bench/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "programs/bench/advice.h"
#include "programs/bench/analysis.h"
#include "programs/bench/json_report.h"
#include "programs/bench/page_of_lines.h"
#include "programs/bench/page_parts.h"
#include "programs/bench/summary.h"
#include "programs/bench/svg_plot.h"

namespace displayfile::bench {

namespace {

constexpr const char* kStyle = R"(
body { font: 15px/1.45 sans-serif; color: #222; max-width: 1160px; margin: 24px auto; padding: 0 16px }
h1 { font-size: 26px } h2 { font-size: 20px; margin-top: 40px } h3 { font-size: 16px; margin-bottom: 4px }
table { border-collapse: collapse; font-size: 12px; margin: 8px 0 }
td, th { padding: 1px 8px; border-bottom: 1px solid #e2e2e2; text-align: right; vertical-align: top }
td:first-child, th:first-child, td.l, th.l { text-align: left }
th { border-bottom: 1px solid #888 }
th { vertical-align: bottom } th.c { text-align: center; border-left: 1px solid #888 }
.plots { display: flex; flex-wrap: wrap; gap: 14px }
.plot { font: 11px sans-serif; max-width: 100% }
.wide { overflow-x: auto } .wide td:first-child { white-space: nowrap }
.legend { font-size: 12px; line-height: 1.9 } .legend span { margin-right: 14px; white-space: nowrap }
.mark { vertical-align: -2px; margin-right: 3px }
.panel { width: 470px } .panel .legend { margin-left: 60px }
details { margin: 4px 0 } summary { cursor: pointer }
)";

Column column_of(const Cell& cell) { return {cell.key.method, cell.key.precision, cell.exact}; }

struct PlotAndCurves {
  Plot plot;
  std::vector<Curve> curves;
};

std::string title_of(const SpeedAndError& one, bool has_hard_cases) {
  std::string text = fmt::format("{}: time {:.3g}, {:.3g} % wrong", one.column.name(), one.time,
                                 one.percent_timed);
  if (has_hard_cases) {
    text += fmt::format(" of the scenes timed, {:.3g} % of the stress scenes", one.percent);
  }
  return text;
}

PlotAndCurves plot_of(const FrontOfAll& found, const Report& report) {
  const std::vector<Column> all = columns(report);
  PlotAndCurves made;
  Plot& plot = made.plot;
  plot = {"All methods and peers: below and left is better",
          fmt::format("time of a picture / time of the exact z-buffer, {} scenes", found.scenes),
          found.hard_cases == 0
              ? "wrong pixels of these scenes, %"
              : fmt::format("wrong pixels of {} stress scenes, {}, %", found.hard_cases,
                            picture_sizes_of_hard_cases(report)),
          true};
  plot.width = 980.0;
  plot.height = 600.0;
  plot.zero_band = 84.0;
  // Room for the label of the slowest.
  constexpr double kRoom = 1.6;
  plot.x_range = {found.all.front().time, kRoom * found.all.back().time};
  for (const SpeedAndError& one : found.front) plot.front.push_back({one.time, one.percent});
  for (const SpeedAndError& one : found.all) {
    // One precision of a method is written out: the others have its colour.
    made.curves.push_back(
        {mark_of(all, one.column),
         false,
         {{one.time, one.percent, std::nullopt, title_of(one, found.hard_cases > 0),
           is_in_series(one.column) ? one.column.name() : ""}}});
  }
  plot.notes = {{Mark{"#444", 0, true}, "filled: claims to be exact"},
                {Mark{"#444", 1, false}, "open: other precisions of the colour's method"},
                {std::nullopt, "dashed: the front"}};
  return made;
}

class Page {
 public:
  explicit Page(const Report& report) : report_(report), columns_(columns(report)) {}

  std::string html() const {
    return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'>"
           "<title>Display File: speed against error</title><style>" +
           std::string(kStyle) + "</style></head><body>\n" + head() + in_short() +
           lines_plot(report_) + which_when() + pareto() + gaps() +
           growth_of(Fit::Against::polygons) + growth_of(Fit::Against::pixels) + fragments() +
           heat() + threads() + overview() + pay_for_what_is_used() + all_figures() +
           "</body></html>\n";
  }

 private:
  std::string legend(const std::function<bool(const Column&)>& shown, bool with_method) const {
    std::string text = "<div class='legend'>";
    for (const Column& column : columns_) {
      if (!shown(column)) continue;
      const std::string precision = column.precision.empty() ? column.method : column.precision;
      text += fmt::format("<span>{}{}</span> ", marker_in_text(mark_of(columns_, column)),
                          escaped(with_method ? column.name() : precision));
    }
    return text + "</div>\n";
  }

  /// The picture first: who is on the front.
  std::string head() const {
    std::string text = "<h1>Speed against error</h1>\n" + front_of_all_plot();
    text += fmt::format(
        "<p>Every time is a ratio to that of the reference, {}, "
        "drawing the same scene in the same run, in turn; given are the median and the least and "
        "the greatest of the rounds. A wrong pixel is one whose polygon is not the one that exact "
        "arithmetic gives. Depth errors are in units of the view volume's depth.</p>\n",
        escaped(report_.reference));
    text += "<details open><summary>Measured with</summary><table>\n";
    for (const auto& [name, value] : report_.environment) {
      text += fmt::format("<tr><td>{}<td class='l'>{}\n", escaped(name), escaped(value));
    }
    return text + "</table></details>\n";
  }

  std::string front_of_all_plot() const {
    const auto found = front_of_all(report_);
    if (!found) return "";
    const auto [plot, curves] = plot_of(*found, report_);
    return "<div class='wide'>" + svg(plot, curves) + "</div>\n";
  }

  std::string which_when() const {
    const auto all = advice(report_);
    if (all.empty()) return "";
    std::string text = "<h2>Which method when</h2>\n";
    for (const Advice& a : all) {
      text += fmt::format("<h3>{}: {}</h3>\n<p>{}.</p>\n<ul>\n", escaped(a.purpose), escaped(a.use),
                          escaped(a.reason));
      for (const std::string& why : a.why) text += "<li>" + escaped(why) + "</li>\n";
      text += "</ul>\n";
    }
    return text;
  }

  /// What a README's blocks hold.
  std::string in_short() const {
    std::string text;
    for (const Summary& summary : summaries(report_)) {
      text +=
          fmt::format("<h2>{}</h2>\n<p>{}</p>\n", escaped(summary.title), escaped(summary.text));
      if (summary.rows.empty()) continue;
      text += "<div class='wide'><table>\n";
      for (const auto& cells : summary.rows) {
        const char* const tag = &cells == &summary.rows.front() ? "th" : "td";
        text += "<tr>";
        for (std::size_t i = 0; i < cells.size(); ++i) {
          const char* const side = summary.is_of_numbers(i) ? "" : " class='l'";
          text += fmt::format("<{}{}>{}", tag, side, escaped(cells[i]));
        }
        text += '\n';
      }
      text += "</table></div>\n";
    }
    return text;
  }

  /// One panel a scene, and one of the hard cases together.
  std::string pareto() const {
    const auto scenes = names_but_hard_cases(report_);
    if (scenes.empty() || columns_.empty()) return "";
    std::string text =
        "<h2>Error against time</h2>\n<p>Below and left is better; the dashed line is the Pareto "
        "front, behind which nothing is both faster and righter. The colour is the method, the "
        "shape "
        "its precision, filled where it claims to be exact; one thread.</p>\n";
    text += legend([](const Column&) { return true; }, true) + "<div class='plots'>\n";
    for (const std::string& name : scenes) text += pareto_panel(shown_scene(report_, name));
    return text + "</div>\n";
  }

  std::string pareto_panel(const SceneRow& row_of_scene) const {
    Plot plot{fmt::format("{}, {} polygons", row_of_scene.scene.id(), row_of_scene.polygons),
              "time of a picture / time of the reference", "wrong pixels", true};
    std::vector<Curve> curves;
    for (const Cell& cell : row_of_scene.cells) {
      if (!cell.skipped.empty() || cell.key.threads != 1) continue;
      curves.push_back({mark_of(columns_, column_of(cell)),
                        false,
                        {{cell.time.median, static_cast<double>(cell.wrong_pixels),
                          std::pair(cell.time.least, cell.time.greatest),
                          fmt::format("{}: time {}, {} wrong pixels", cell.key.contender(),
                                      number(cell.time.median), cell.wrong_pixels)}}});
    }
    std::string front;
    for (const Cell* cell : pareto_front(row_of_scene)) {
      plot.front.push_back({cell->time.median, static_cast<double>(cell->wrong_pixels)});
      front +=
          fmt::format("{}{} ({}, {})", front.empty() ? "" : "; ", escaped(cell->key.contender()),
                      number(cell->time.median), cell->wrong_pixels);
    }
    return "<div class='panel'>" + svg(plot, curves) +
           "<div class='legend'>Front (time, wrong pixels): " + front + "</div></div>\n";
  }

  bool in_hard_cases(const Column& column) const {
    return wrong_pixels(report_, "", column).pixels > 0;
  }

  /// One panel a method, a curve a precision.
  std::string gaps() const {
    std::vector<double> severities;
    for (const SceneRow& r : report_.scenes) {
      if (r.scene.gap && std::ranges::find(severities, r.scene.severity) == severities.end()) {
        severities.push_back(r.scene.severity);
      }
    }
    if (severities.size() < 2) return "";
    std::ranges::sort(severities, std::greater());
    std::string text =
        "<h2>Error against gap</h2>\n<p>Wrong pixels of all families whose gap shrinks, together. "
        "At gaps that the rounding of the vertices swallows the polygons lie in one plane, the "
        "later "
        "one is rightly seen, and counts fall.</p>\n<div class='plots'>\n";
    std::vector<std::string> done;
    for (const Column& column : columns_) {
      if (std::ranges::find(done, column.method) != done.end()) continue;
      done.push_back(column.method);
      text += gap_panel(column.method, severities);
    }
    return text + "</div>\n";
  }

  std::string gap_panel(const std::string& method, const std::vector<double>& severities) const {
    const Plot plot{
        method,
        "gap (1: the view volume's depth)",
        "wrong pixels, % of all",
        true,
        {},
        std::pair(std::pow(10.0, -severities.front()), std::pow(10.0, -severities.back())),
        std::pair(0.001, 100.0)};
    std::vector<Curve> curves;
    for (const Column& column : columns_) {
      if (column.method != method) continue;
      Curve curve{mark_of(columns_, column), true, {}};
      for (const double severity : severities) {
        const Wrong sum = wrong_pixels(report_, "", column, severity);
        if (sum.pixels == 0) continue;
        const double percent = sum.percent();
        curve.points.push_back(
            {std::pow(10.0, -severity), percent, std::nullopt,
             fmt::format("{}: {:.4g} % at 1e-{:g}", column.name(), percent, severity)});
      }
      if (!curve.points.empty()) curves.push_back(std::move(curve));
    }
    return "<div class='panel'>" + svg(plot, curves) +
           legend([&](const Column& c) { return c.method == method && in_hard_cases(c); }, false) +
           "</div>\n";
  }

  std::string growth_of(Fit::Against against) const {
    std::string panels;
    for (const std::string& name : names_but_hard_cases(report_)) {
      const auto scenes = series(report_, name, against);
      if (scenes.empty()) continue;
      const std::string fixed =
          against == Fit::Against::polygons
              ? fmt::format("{0}, {1} x {1} pixels", name, scenes.front()->scene.size)
              : fmt::format("{}, {} polygons", name, scenes.front()->polygons);
      const Plot plot{fixed, against == Fit::Against::polygons ? "polygons" : "pixels",
                      "time / reference on the smallest scene"};
      std::vector<Curve> curves;
      for (const Column& column : columns_) {
        if (!is_in_series(column)) continue;
        Curve curve{mark_of(columns_, column), true, {}};
        for (const Growth& g : growth(scenes, column.method, column.precision)) {
          curve.points.push_back(
              {g.size, g.time, std::nullopt, fmt::format("{}: {:.4g}", column.name(), g.time)});
        }
        if (!curve.points.empty()) curves.push_back(std::move(curve));
      }
      panels += svg(plot, curves);
    }
    if (panels.empty()) return "";
    const std::string of(name_of(against));
    return fmt::format(
               "<h2>Time against {0}</h2>\n<p>Both axes are logarithmic, so that a power is a "
               "line; "
               "one unit is the reference's time on the first scene of the name. In the table the "
               "fitted exponents e of time = c {0}<sup>e</sup>.</p>\n",
               of) +
           legend(is_in_series, true) + "<div class='plots'>\n" + panels + "</div>\n" +
           exponents(against);
  }

  std::string exponents(Fit::Against against) const {
    const auto all = fits(report_);
    std::vector<std::string> scenes = names_but_hard_cases(report_);
    std::erase_if(scenes, [&](const std::string& name) {
      return std::ranges::none_of(
          all, [&](const Fit& f) { return f.scene == name && f.against == against; });
    });
    std::vector<std::string> heads{fmt::format("exponent of {}", name_of(against))};
    for (const std::string& name : scenes) heads.push_back(escaped(short_name(name)));
    std::string text = "<div class='wide'><table>\n" + table_row("th", heads);
    for (const Column& column : columns_) {
      const bool fitted = std::ranges::any_of(all, [&](const Fit& f) {
        return f.against == against && f.method == column.method && f.precision == column.precision;
      });
      if (!fitted) continue;
      std::vector<std::string> cells{escaped(column.name())};
      for (const std::string& name : scenes) {
        const auto fit = std::ranges::find_if(all, [&](const Fit& f) {
          return f.scene == name && f.against == against && f.method == column.method &&
                 f.precision == column.precision;
        });
        cells.push_back(fit == all.end() ? ""
                                         : fmt::format("{} <small>({} points)</small>",
                                                       number(fit->exponent), fit->points));
      }
      text += table_row("td", cells);
    }
    return text + "</table></div>\n";
  }

  std::string fragments() const {
    std::string panels;
    std::vector<Column> drawn;
    for (const std::string& name : names_but_hard_cases(report_)) {
      const auto scenes = series(report_, name, Fit::Against::polygons);
      std::vector<Curve> curves;
      for (const Column& column : columns_) {
        if (column.method == "gl2ps") continue;  // of which it is for each triangle
        Curve curve{mark_of(columns_, column), true, {}};
        for (const SceneRow* r : scenes) {
          const Cell* cell = measured(*r, column.method, column.precision);
          if (cell == nullptr || !cell->fragments) continue;
          curve.points.push_back({static_cast<double>(r->polygons), *cell->fragments, std::nullopt,
                                  fmt::format("{}: {}", column.name(), number(*cell->fragments))});
        }
        if (curve.points.empty()) continue;
        curves.push_back(std::move(curve));
        drawn.push_back(column);
      }
      if (!curves.empty()) panels += svg({name, "polygons", "fragments a polygon"}, curves);
    }
    if (panels.empty()) return "";
    return "<h2>Fragments</h2>\n<p>Pieces that the sorts make of a polygon, and those of which the "
           "map says that they are seen. gl2ps gets triangles: the pieces of those are in a table "
           "above.</p>\n" +
           legend([&](const Column& c) { return std::ranges::find(drawn, c) != drawn.end(); },
                  true) +
           "<div class='plots'>\n" + panels + "</div>\n";
  }

  std::string heat() const {
    const auto families = names(report_, BenchScene::Kind::hard_case);
    if (families.empty()) return "";
    HeatMap map;
    std::vector<Column> shown = columns_;
    std::erase_if(shown, [&](const Column& column) { return !in_hard_cases(column); });
    for (const Column& column : shown) map.columns.push_back(column.name());
    map.rows = families;
    map.rows.emplace_back("all");
    for (const std::string& family : map.rows) {
      for (const Column& column : shown) {
        const Wrong sum = wrong_pixels(report_, family == "all" ? "" : family, column);
        map.percent.push_back(sum.pixels == 0 ? -1.0 : sum.percent());
        map.titles.push_back(fmt::format("{}, {}: {} wrong of {} pixels", family, column.name(),
                                         sum.wrong, sum.pixels));
      }
    }
    return "<h2>Wrong pixels of the hard cases</h2>\n<p>In a hundred, over all severities of a "
           "family; green: none.</p>\n<div class='wide'>\n" +
           svg(map) + "</div>\n";
  }

  /// A table of the shown scenes: a row a contender, a column a scene.
  std::string matrix(const std::string& head, const std::function<bool(const Column&)>& shown,
                     const std::function<std::string(const SceneRow&, const Cell&)>& value) const {
    std::vector<std::string> heads{head};
    const auto scenes = names_but_hard_cases(report_);
    for (const std::string& name : scenes) heads.push_back(escaped(short_name(name)));
    std::string text = "<div class='wide'><table>\n" + table_row("th", heads);
    for (const Column& column : columns_) {
      if (!shown(column)) continue;
      std::vector<std::string> cells{escaped(column.name())};
      for (const std::string& name : scenes) {
        const SceneRow& r = shown_scene(report_, name);
        const Cell* cell = measured(r, column.method, column.precision);
        cells.push_back(cell == nullptr ? "" : value(r, *cell));
      }
      text += table_row("td", cells);
    }
    return text + "</table></div>\n";
  }

  std::string threads() const {
    const int most = most_threads(report_);
    if (most == 1) return "";
    return fmt::format("<h2>Threads</h2>\n<p>Time on 1 thread over time on {}.</p>\n", most) +
           matrix(
               "method", [](const Column& c) { return c.exact; },
               [&](const SceneRow& r, const Cell& one) {
                 const Cell* all = measured(r, one.key.method, one.key.precision, most);
                 return all == nullptr ? std::string()
                                       : fmt::format("{:.2f}", one.time.median / all->time.median);
               });
  }

  std::string overview() const {
    if (names_but_hard_cases(report_).empty() || columns_.empty()) return "";
    const auto all = [](const Column&) { return true; };
    return "<h2>Memory and exact arithmetic</h2>\n<p>Most bytes that the program's own arrays and "
           "the picture held at a time, for each polygon (OSMesa, Embree and gl2ps take theirs "
           "elsewhere); and "
           "how often a predicate's exact stage was asked for one picture.</p>\n" +
           matrix("bytes a polygon", all,
                  [](const SceneRow& r, const Cell& cell) {
                    const auto n = static_cast<double>(std::max<std::size_t>(1, r.polygons));
                    return cell.bytes ? fmt::format("{:.0f}", static_cast<double>(*cell.bytes) / n)
                                      : std::string();
                  }) +
           matrix("exact-stage calls", all, [](const SceneRow&, const Cell& cell) {
             return fmt::format("{}", cell.exact_calls);
           });
  }

  static std::string of_feature(const FeatureRow& row, double bytes_off) {
    const auto own = [&](const std::optional<FeatureRow::Own>& count) {
      if (!row.has_functions) return std::string("<td>none<td>");
      return count ? fmt::format("<td>{}<td>{}", count->instructions, count->allocations)
                   : std::string("<td><td>");
    };
    const std::string over = row.over.empty() ? "" : ", over " + row.over;
    std::string text =
        fmt::format("<tr><td>{}<br><small>{}{}</small>{}<td>{:g}", escaped(row.name),
                    escaped(row.turned_on_by), escaped(over), own(row.own_off), bytes_off);
    if (!row.not_counted.empty()) {
      return text + "<td class='l' colspan='7'>not counted: " + escaped(row.not_counted) + '\n';
    }
    text += row.instructions
                ? fmt::format("<td>{}<td>{:.3f}", row.instructions->on, ratio(*row.instructions))
                : "<td><td>";
    return text + own(row.own_on) +
           fmt::format("<td>{:+}<td>{:g}<td>{:.3f}\n", row.allocations->on - row.allocations->off,
                       *row.display_file_on, ratio(*row.most_bytes));
  }

  std::string pay_for_what_is_used() const {
    if (!report_.features) return "";
    const FeatureCosts& costs = *report_.features;
    std::string text = fmt::format(
        "<h2>Pay for what is used</h2>\n<p>{0} polygons drawn at {1}x{1} on one thread, from the "
        "first routine to the picture, without each feature and with it; one that is over another "
        "is measured with that one on in both. A feature's own functions are those that nothing "
        "else needs. Asking whether it is on is a branch in functions that all drawings run "
        "through; a feature that has no functions of its own is only such a branch. Bytes are of "
        "the display file, for each polygon; off, beyond its vertices and sides. Memory is the "
        "most that was held at a time.</p>\n",
        costs.polygons, costs.size);
    if (costs.instructions) {
      text += fmt::format(
          "<p>With everything off the drawing is {} instructions and {} allocations. Instructions "
          "are callgrind's, on the processor that it imitates, which need not have this one's "
          "vector instructions.</p>\n",
          *costs.instructions, costs.allocations);
    } else {
      text += fmt::format("<p><b>Instructions were not counted: {}.</b></p>\n",
                          escaped(costs.not_counted));
    }
    text +=
        "<div class='wide'><table>\n"
        "<tr><th><th colspan='3' class='c'>off<th colspan='7' class='c'>on\n" +
        table_row("th", {"feature, what turns it on", "own instructions", "own allocations",
                         "bytes", "instructions", "/ off", "own instructions", "own allocations",
                         "allocations more", "bytes more", "memory / off"});
    for (const FeatureRow& r : costs.rows) text += of_feature(r, costs.bytes_a_polygon);
    return text + "</table></div>\n";
  }

  static std::string figures(const Cell& cell) {
    if (!cell.skipped.empty()) return row_skipped(cell, 12);
    std::string text = row_begun(cell);
    text += fmt::format("<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}<td>{}", cell.wrong_pixels,
                        number(cell.largest_depth_error), number(cell.mean_depth_error),
                        cell.fragments ? number(*cell.fragments) : "",
                        cell.bytes ? fmt::format("{}", *cell.bytes) : "", cell.exact_calls,
                        spread_cells(cell.time));
    return text + (cell.again ? "<td>" + spread_cells(*cell.again) : "<td><td><td>") + '\n';
  }

  /// One row a comparison.
  std::string comparisons() const {
    if (report_.beside.empty()) return "";
    std::string text =
        "<details><summary>Beside others, and without exact stages</summary><table>\n" +
        table_row("th", {"scene", "threads", "other", "what", "times as fast", "least", "greatest",
                         "count"});
    for (const Beside& b : report_.beside) {
      text += fmt::format("<tr><td>{}<td>{}<td class='l'>{}<td class='l'>{}", escaped(b.scene),
                          b.threads, escaped(b.other), escaped(b.what));
      if (!b.left_out.empty()) {
        text += "<td class='l' colspan='4'>skipped: " + escaped(b.left_out) + '\n';
        continue;
      }
      text += b.times_faster ? "<td>" + spread_cells(*b.times_faster) : "<td><td><td>";
      text += b.count ? "<td>" + number(*b.count) + '\n' : "<td>\n";
    }
    return text + "</table></details>\n";
  }

  std::string all_figures() const {
    std::string text = "<h2>All figures</h2>\n<p>The same as in the JSON.</p>\n" + comparisons() +
                       figures_of_lines(report_);
    for (const SceneRow& r : report_.scenes) {
      if (r.cells.empty()) continue;
      text += fmt::format("<details><summary>{}: {} polygons, {} pixels", escaped(r.scene.id()),
                          r.polygons, r.scene.pixels());
      if (r.scene.kind == BenchScene::Kind::hard_case) {
        text += fmt::format(", severity {}", number(r.scene.severity));
      }
      if (r.growth) {
        text += fmt::format("; the reference takes {} ({} to {}) times what it takes on the first",
                            number(r.growth->median), number(r.growth->least),
                            number(r.growth->greatest));
      }
      text += "</summary><table>\n" +
              table_row("th", {"method", "precision", "threads", "claims", "wrong pixels",
                               "largest depth error", "mean", "fragments a polygon", "bytes",
                               "exact-stage calls", "time", "least", "greatest", "again", "least",
                               "greatest"});
      for (const Cell& cell : r.cells) text += figures(cell);
      text += "</table></details>\n";
    }
    return text;
  }

  const Report& report_;
  std::vector<Column> columns_;
};

}  // namespace

std::string html_page(const Report& report) { return Page(report).html(); }

std::optional<std::string> front_plot(const Report& report) {
  const auto found = front_of_all(report);
  if (!found) return std::nullopt;
  const auto [plot, curves] = plot_of(*found, report);
  return svg_file(plot, curves);
}

}  // namespace displayfile::bench
