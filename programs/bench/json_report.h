#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// Keys in the order written.
using Json = nlohmann::ordered_json;

/// One finished cell, and back. Throws nlohmann::json::exception for anything else.
Json to_json(const Cell& cell);
Cell cell_from_json(const Json& json);

/// Likewise.
Json to_json(const Beside& beside);
Beside beside_from_json(const Json& json);

Json to_json(const SceneRow& row);
Json to_json(const Report& report);

/// A number as it stands in the JSON, for the other outputs.
std::string number(double value);

}  // namespace displayfile::bench
