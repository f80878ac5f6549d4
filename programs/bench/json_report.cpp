#include "programs/bench/json_report.h"

#include "programs/bench/analysis.h"

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

Json to_json(const AutoBounds& bounds) {
  return {{"scenes", bounds.scenes},           {"total_over_best_fixed", bounds.total},
          {"best_fixed", bounds.best_fixed},   {"worst_over_best", bounds.worst},
          {"worst_scene", bounds.worst_scene}, {"best_there", bounds.best_there}};
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
  json["wrong_pixels"] = cell.wrong_pixels;
  json["largest_depth_error"] = cell.largest_depth_error;
  json["mean_depth_error"] = cell.mean_depth_error;
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
  cell.wrong_pixels = json.at("wrong_pixels");
  cell.largest_depth_error = json.at("largest_depth_error");
  cell.mean_depth_error = json.at("mean_depth_error");
  if (json.contains("fragments_per_polygon")) cell.fragments = json.at("fragments_per_polygon");
  if (json.contains("bytes")) cell.bytes = json.at("bytes");
  cell.exact_calls = json.at("exact_stage_calls");
  cell.time = spread_from_json(json.at("time"));
  if (json.contains("time_again")) cell.again = spread_from_json(json.at("time_again"));
  return cell;
}

Json to_json(const SceneRow& row) {
  Json json{{"scene", row.scene.id()},
            {"name", row.scene.name},
            {"kind", name_of(row.scene.kind)},
            {"polygons", row.polygons},
            {"pixels", row.scene.pixels()}};
  if (row.scene.kind == BenchScene::Kind::hard_case) json["severity"] = row.scene.severity;
  if (row.growth) json["reference_growth"] = to_json(*row.growth);
  return json;
}

Json to_json(const Report& report) {
  Json json{{"format", 1}, {"reference", report.reference}};
  for (const auto& [name, value] : report.environment) json["environment"][name] = value;
  for (const SceneRow& row : report.scenes) json["scenes"].push_back(to_json(row));
  for (const SceneRow& row : report.scenes) {
    for (const Cell& cell : row.cells) json["cells"].push_back(to_json(cell));
  }
  json["fits"] = Json::array();
  for (const Fit& fit : fits(report)) json["fits"].push_back(to_json(fit));
  if (const auto bounds = auto_bounds(report)) json["auto"] = to_json(*bounds);
  return json;
}

std::string number(double value) { return Json(value).dump(); }

}  // namespace displayfile::bench
