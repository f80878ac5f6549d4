#include <fmt/format.h>

#include <iterator>

#include "interp/device/picture.h"
#include "interp/steps/steps.h"

// The core has no JSON library; the document consists of lists of numbers and a few words.

namespace displayfile {

namespace {

using Text = std::back_insert_iterator<std::string>;

/// A JSON string, also safe inside a script element: every < is escaped.
std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '<') {
      quoted += "\\u003c";
    } else {
      quoted += c;
    }
  }
  return quoted += '"';
}

template <class List, class Write>
void write_list(Text& to, const List& list, Write&& write) {
  fmt::format_to(to, "[");
  bool first = true;
  for (const auto& entry : list) {
    if (!first) fmt::format_to(to, ",");
    first = false;
    write(entry);
  }
  fmt::format_to(to, "]");
}

std::string hex(const Colour& colour) {
  const std::uint32_t p = pixel_of(colour);
  return fmt::format("\"#{:02x}{:02x}{:02x}\"", p & 0xFF, p >> 8 & 0xFF, p >> 16 & 0xFF);
}

/// A coordinate of a piece, and, with fewer digits, one of a mark.
std::string coordinate(double value) { return fmt::format("{:.6g}", value); }
std::string place(double value) { return fmt::format("{:.4g}", value); }

long long piece_of(std::uint32_t piece) {
  return piece == StepRow::kNoPiece ? -1 : static_cast<long long>(piece);
}

void write(Text& to, const StepMark& mark) {
  static constexpr std::string_view kKinds[] = {"piece", "points", "line", "box"};
  fmt::format_to(to, "[\"{}\",\"{}\"", kKinds[static_cast<std::size_t>(mark.kind)],
                 name_of(mark.role));
  switch (mark.kind) {
    case StepMark::Kind::piece: fmt::format_to(to, ",{}", mark.piece); break;
    case StepMark::Kind::box:
      fmt::format_to(to, ",{},{},{},{}", mark.box.first_column, mark.box.end_column,
                     mark.box.first_row, mark.box.end_row);
      break;
    case StepMark::Kind::points:
    case StepMark::Kind::line:
      for (const Point2& p : mark.points) {
        fmt::format_to(to, ",{},{}", place(p.x), place(p.y));
      }
  }
  fmt::format_to(to, "]");
}

/// Most rows are a piece's name alone: these are written as the number of the piece.
void write(Text& to, const StepRow& row, const std::vector<StepPiece>& pieces) {
  const bool is_name = row.piece != StepRow::kNoPiece && row.cells.size() == 1 &&
                       row.cells[0] == pieces[row.piece].name;
  if (is_name && row.role == StepRole::none) {
    fmt::format_to(to, "{}", row.piece);
    return;
  }
  fmt::format_to(to, "[{},\"{}\"", piece_of(row.piece), name_of(row.role));
  if (!is_name) {
    for (const std::string& cell : row.cells) fmt::format_to(to, ",{}", json_string(cell));
  }
  fmt::format_to(to, "]");
}

void write(Text& to, const PanelChange& change, const std::vector<StepPiece>& pieces) {
  fmt::format_to(to, "{{\"panel\":{}", change.panel);
  if (!change.nodes.empty()) {
    fmt::format_to(to, ",\"nodes\":");
    write_list(to, change.nodes, [&](const StepNode& n) {
      fmt::format_to(to, "[{},{},{},{},{},\"{}\"]", n.node, n.parent, n.branch, json_string(n.text),
                     piece_of(n.piece), name_of(n.role));
    });
  } else if (!change.segments.empty()) {
    fmt::format_to(to, ",\"segments\":");
    write_list(to, change.segments, [&](const StepSegment& s) {
      fmt::format_to(to, "[{},{},{},{},{},\"{}\"]", place(s.x0), place(s.z0), place(s.x1),
                     place(s.z1), piece_of(s.piece), name_of(s.role));
    });
  } else {
    fmt::format_to(to, ",\"rows\":");
    write_list(to, change.rows, [&](const StepRow& row) { write(to, row, pieces); });
  }
  fmt::format_to(to, "}}");
}

void write(Text& to, const Step& step, const std::vector<StepPiece>& pieces) {
  fmt::format_to(to, "{{\"line\":{},\"say\":{}", step.line, json_string(step.sentence));
  for (const bool stays : {false, true}) {
    std::vector<StepMark> marks;
    for (const StepMark& mark : step.marks) {
      if (mark.stays == stays) marks.push_back(mark);
    }
    if (marks.empty()) continue;
    fmt::format_to(to, ",\"{}\":", stays ? "stays" : "marks");
    write_list(to, marks, [&](const StepMark& mark) { write(to, mark); });
  }
  if (!step.gained.empty()) {
    fmt::format_to(to, ",\"gained\":");
    write_list(to, step.gained, [&](const StepRun& r) {
      fmt::format_to(to, "[{},{},{},{}]", r.row, r.first, r.end, r.polygon);
    });
  }
  if (!step.lines.empty()) {
    fmt::format_to(to, ",\"lines\":");
    write_list(to, step.lines, [&](const StepLine& l) {
      fmt::format_to(to, "[{},{},{},{},{},{}]", l.polygon, l.hidden ? 1 : 0, coordinate(l.start.x),
                     coordinate(l.start.y), coordinate(l.end.x), coordinate(l.end.y));
    });
  }
  if (!step.panels.empty()) {
    fmt::format_to(to, ",\"panels\":");
    write_list(to, step.panels, [&](const PanelChange& change) { write(to, change, pieces); });
  }
  fmt::format_to(to, "}}");
}

void write(Text& to, const PanelEntry& panel) {
  static constexpr std::string_view kKinds[] = {"list",    "table", "tree",
                                                "profile", "graph", "depths"};
  fmt::format_to(to, "{{\"title\":{},\"kind\":\"{}\",\"columns\":{}}}", json_string(panel.title),
                 kKinds[static_cast<std::size_t>(panel.kind)], json_string(panel.columns));
}

void write(Text& to, const StepPolygon& polygon) {
  static constexpr std::string_view kKinds[] = {"solid", "hollow", "line"};
  fmt::format_to(
      to, "{{\"kind\":\"{}\",\"colour\":{},\"pick\":{},\"edge_on\":{},\"plane\":[{},{},{}]}}",
      kKinds[static_cast<std::size_t>(polygon.kind)], hex(polygon.colour), polygon.pick,
      polygon.edge_on, coordinate(polygon.z0), coordinate(polygon.dz_dx),
      coordinate(polygon.dz_dy));
}

void write(Text& to, const StepPiece& piece) {
  fmt::format_to(to, "{{\"name\":{},\"polygon\":{},\"points\":", json_string(piece.name),
                 piece.polygon);
  write_list(to, piece.points, [&](const Point3& p) {
    fmt::format_to(to, "{},{},{}", coordinate(p.x), coordinate(p.y), coordinate(p.z));
  });
  fmt::format_to(to, "}}");
}

}  // namespace

std::string as_json(const Steps& steps) {
  std::string text;
  Text to(text);
  fmt::format_to(to, "{{\"displayfile_steps\":1,\"method\":\"{}\",\"title\":{},\"source\":{},",
                 name_of(steps.method), json_string(steps.title), json_string(steps.source));
  fmt::format_to(to, "\"code\":{},", json_string(steps.code));
  fmt::format_to(to, "\"width\":{},\"height\":{},\"background\":{},\n\"listing\":", steps.width,
                 steps.height, hex(steps.background));
  write_list(to, steps.listing, [&](const ListingLine& line) {
    fmt::format_to(to, "[{},{}]", line.indent, json_string(line.text));
  });
  fmt::format_to(to, ",\n\"panels\":");
  write_list(to, steps.panels, [&](const PanelEntry& panel) { write(to, panel); });
  fmt::format_to(to, ",\n\"polygons\":");
  write_list(to, steps.polygons, [&](const StepPolygon& polygon) { write(to, polygon); });
  fmt::format_to(to, ",\n\"pieces\":");
  write_list(to, steps.pieces, [&](const StepPiece& piece) { write(to, piece); });
  fmt::format_to(to, ",\n\"steps\":");
  write_list(to, steps.steps, [&](const Step& step) {
    fmt::format_to(to, "\n");
    write(to, step, steps.pieces);
  });
  fmt::format_to(to, "}}\n");
  return text;
}

}  // namespace displayfile
