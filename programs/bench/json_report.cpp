#include "programs/bench/json_report.h"

#include "programs/bench/analysis.h"
#include "programs/bench/line_measure.h"
#include "programs/bench/line_summary.h"
#include "programs/bench/moving_camera_summary.h"

namespace displayfile::bench {

namespace {

Json to_json(const Spread& s) {
  return {{"median", s.median}, {"least", s.least}, {"greatest", s.greatest}};
}

Spread spread_from_json(const Json& json) {
  return {json.at("least"), json.at("median"), json.at("greatest")};
}

Json to_json(const Fit& fit) {
  return {{"scene", fit.scene},         {"method", fit.method},
          {"precision", fit.precision}, {"against", name_of(fit.against)},
          {"points", fit.points},       {"exponent", fit.exponent}};
}

Json to_json(const LineFit& fit) {
  return {{"scene", fit.scene},
          {"method", fit.method},
          {"points", fit.points},
          {"exponent", fit.exponent}};
}

Json to_json(const GrowthOfNewViews& growth) {
  return {{"scene", growth.scene},
          {"threads", growth.threads},
          {"points", growth.points},
          {"exponent", growth.exponent}};
}

Json to_json(const AutoBounds& bounds) {
  return {{"scenes", bounds.scenes},           {"total_over_best_fixed", bounds.total},
          {"best_fixed", bounds.best_fixed},   {"worst_over_best", bounds.worst},
          {"worst_scene", bounds.worst_scene}, {"best_there", bounds.best_there}};
}

template <class T>
void add_off_and_on(const std::optional<FeatureRow::OffAndOn<T>>& count, const char* name,
                    Json& json) {
  if (!count) return;
  json["off"][name] = count->off;
  json["on"][name] = count->on;
}

void add_own(const std::optional<FeatureRow::Own>& own, Json& json) {
  if (!own) return;
  json["own_instructions"] = own->instructions;
  json["own_allocations"] = own->allocations;
}

Json to_json(const ViewingRow& row) {
  return {{"scene", row.scene.id()},
          {"pixels", row.pixels},
          {"different", row.different},
          {"different_and_tied", row.ties}};
}

Json to_json(const FeatureRow& row) {
  Json json{{"feature", row.name}, {"turned_on_by", row.turned_on_by}, {"over", row.over}};
  json["has_functions"] = row.has_functions;
  json["off"] = json["on"] = Json::object();
  if (row.has_functions) {
    add_own(row.own_off, json["off"]);
    add_own(row.own_on, json["on"]);
  }
  add_off_and_on(row.instructions, "instructions", json);
  add_off_and_on(row.allocations, "allocations", json);
  add_off_and_on(row.most_bytes, "most_bytes", json);
  if (row.display_file_on) json["on"]["display_file_bytes_a_polygon"] = *row.display_file_on;
  if (!row.not_counted.empty()) json["on"]["not_counted"] = row.not_counted;
  return json;
}

Json to_json(const FeatureCosts& costs) {
  Json json{{"polygons", costs.polygons},
            {"size", costs.size},
            {"off",
             {{"allocations", costs.allocations},
              {"display_file_bytes_a_polygon", costs.bytes_a_polygon}}}};
  if (costs.instructions) json["off"]["instructions"] = *costs.instructions;
  if (!costs.not_counted.empty()) json["instructions_not_counted"] = costs.not_counted;
  for (const FeatureRow& row : costs.rows) json["features"].push_back(to_json(row));
  return json;
}

}  // namespace

Json to_json(const Cell& cell) {
  Json json{{"scene", cell.key.scene},
            {"method", cell.key.method},
            {"precision", cell.key.precision},
            {"threads", cell.key.threads},
            {"exact", cell.exact}};
  if (!cell.skipped.empty()) {
    json["skipped"] = cell.skipped;
    return json;
  }
  if (cell.lines) {
    const auto& [lines, pieces, length, missing, extra] = *cell.lines;
    json["lines"] = lines;
    json["pieces"] = pieces;
    json["length"] = length;
    json["missing_length"] = missing;
    json["extra_length"] = extra;
  } else {
    json["wrong_pixels"] = cell.wrong_pixels;
    json["largest_depth_error"] = cell.largest_depth_error;
    json["mean_depth_error"] = cell.mean_depth_error;
  }
  if (cell.fragments) json["fragments_per_polygon"] = *cell.fragments;
  if (cell.bytes) json["bytes"] = *cell.bytes;
  json["exact_stage_calls"] = cell.exact_calls;
  json["time"] = to_json(cell.time);
  if (cell.again) json["time_again"] = to_json(*cell.again);
  return json;
}

Cell cell_from_json(const Json& json) {
  Cell cell;
  cell.key = {json.at("scene"), json.at("method"), json.at("precision"), json.at("threads")};
  cell.exact = json.at("exact");
  if (json.contains("skipped")) {
    cell.skipped = json.at("skipped");
    return cell;
  }
  if (json.contains("lines")) {
    cell.lines = LineFigures{json.at("lines"), json.at("pieces"), json.at("length"),
                             json.at("missing_length"), json.at("extra_length")};
  } else {
    cell.wrong_pixels = json.at("wrong_pixels");
    cell.largest_depth_error = json.at("largest_depth_error");
    cell.mean_depth_error = json.at("mean_depth_error");
  }
  if (json.contains("fragments_per_polygon")) cell.fragments = json.at("fragments_per_polygon");
  if (json.contains("bytes")) cell.bytes = json.at("bytes");
  cell.exact_calls = json.at("exact_stage_calls");
  cell.time = spread_from_json(json.at("time"));
  if (json.contains("time_again")) cell.again = spread_from_json(json.at("time_again"));
  return cell;
}

Json to_json(const Beside& beside) {
  Json json{{"scene", beside.scene},
            {"threads", beside.threads},
            {"other", beside.other},
            {"what", beside.what}};
  if (beside.times_faster) json["times_faster"] = to_json(*beside.times_faster);
  if (beside.count) json["count"] = *beside.count;
  if (!beside.left_out.empty()) json["left_out"] = beside.left_out;
  return json;
}

Beside beside_from_json(const Json& json) {
  Beside beside{json.at("scene"), json.at("threads"), json.at("other"), json.at("what")};
  if (json.contains("times_faster")) beside.times_faster = spread_from_json(json["times_faster"]);
  if (json.contains("count")) beside.count = json["count"];
  if (json.contains("left_out")) beside.left_out = json["left_out"];
  return beside;
}

Json to_json(const SceneRow& row) {
  Json json{{"scene", row.scene.id()},
            {"name", row.scene.name},
            {"kind", name_of(row.scene.kind)},
            {"polygons", row.polygons},
            {"pixels", row.scene.pixels()}};
  if (row.scene.kind == BenchScene::Kind::hard_case) json["severity"] = row.scene.severity;
  if (row.growth) json["reference_growth"] = to_json(*row.growth);
  if (row.line_growth) json["line_reference_growth"] = to_json(*row.line_growth);
  return json;
}

Json to_json(const Report& report) {
  Json json{{"format", 1}, {"reference", report.reference}};
  for (const auto& [name, value] : report.environment) json["environment"][name] = value;
  for (const SceneRow& row : report.scenes) json["scenes"].push_back(to_json(row));
  for (const SceneRow& row : report.scenes) {
    for (const Cell& cell : row.cells) json["cells"].push_back(to_json(cell));
  }
  for (const SceneRow& row : report.scenes) {
    for (const Cell& cell : row.line_cells) json["line_cells"].push_back(to_json(cell));
  }
  if (json.contains("line_cells")) json["line_reference"] = kLineReference;
  for (const LineScenes scenes : {LineScenes::any, LineScenes::surfaces}) {
    for (const LineFit& fit : line_fits(report, scenes)) {
      json["line_fits"].push_back(to_json(fit));
    }
  }
  json["beside"] = Json::array();
  for (const Beside& beside : report.beside) json["beside"].push_back(to_json(beside));
  for (const GrowthOfNewViews& growth : growth_of_new_views(report)) {
    json["growth_of_new_views"].push_back(to_json(growth));
  }
  json["fits"] = Json::array();
  for (const Fit& fit : fits(report)) json["fits"].push_back(to_json(fit));
  if (const auto bounds = auto_bounds(report)) json["auto"] = to_json(*bounds);
  for (const ViewingRow& row : report.viewing) json["viewing"].push_back(to_json(row));
  if (report.features) json["feature_costs"] = to_json(*report.features);
  return json;
}

std::string number(double value) { return Json(value).dump(); }

}  // namespace displayfile::bench
