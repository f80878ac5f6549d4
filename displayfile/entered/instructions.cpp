#include "displayfile/entered/instructions.h"

#include <algorithm>

#include "clip/base/growing_array.h"

namespace displayfile {

void Instructions::set_style(const FillStyle& fill) {
  if (fill_ == fill) return;
  if (fill.kind == FillStyle::Kind::solid) {
    op_.push_back(fill.shadow ? op::fill_shadowed : op::fill_solid);
    style_operands_.insert(style_operands_.end(), {fill.colour.r, fill.colour.g, fill.colour.b});
    if (fill.shadow) {
      const auto& [c, light] = *fill.shadow;
      style_operands_.insert(style_operands_.end(),
                             {c.r, c.g, c.b, light.x, light.y, light.z, light.w});
      has_shadows_ = true;
    }
  } else {
    op_.push_back(op::fill_hollow);
  }
  fill_ = fill;
}

void Instructions::set_style(const LineStyle& line) {
  if (line_ == line) return;
  if (line.of_kinds != (line_ ? line_->of_kinds : LineKindStyles())) {
    op_.insert(op_.end(),
               {op::line_kind_styles, static_cast<std::int32_t>(line_kind_styles_.size())});
    line_kind_styles_.push_back(line.of_kinds);
  }
  switch (line.kind) {
    case LineStyle::Kind::none: op_.push_back(op::line_none); break;
    case LineStyle::Kind::solid: op_.push_back(op::line_solid); break;
    case LineStyle::Kind::dashed: op_.push_back(op::line_dashed); break;
  }
  if (line.kind != LineStyle::Kind::none) {
    style_operands_.insert(style_operands_.end(),
                           {line.colour.r, line.colour.g, line.colour.b, line.width});
  }
  if (line.kind == LineStyle::Kind::dashed) {
    style_operands_.insert(style_operands_.end(), {line.dash, line.gap});
  }
  line_ = line;
}

void Instructions::set_style(const TextStyle& text) {
  if (text_style_ == text) return;
  op_.push_back(op::text_style);
  op_.push_back(static_cast<std::int32_t>(text.alignment) + (text.always ? op::text_always : 0));
  style_operands_.push_back(text.size);
  text_style_ = text;
}

/// Begins a run where the identifier is one more than the last, unless polygons have each
/// identifier several times, as triangles of one polygon do.
void Instructions::enter_pick() {
  if (!pick_) return;
  const bool repeats = last_pick_ == pick_;
  const bool known = stored_picks_.in_run ? *pick_ == stored_picks_.next : repeats;
  if (!known) {
    const bool ordinal =
        !last_pick_ || (*pick_ - std::int64_t{1} == *last_pick_ && !last_pick_repeats_);
    stored_picks_ = {!repeats && (stored_picks_.in_run || ordinal), *pick_};
    op_.push_back(stored_picks_.in_run ? op::pick_run : op::pick);
    op_.push_back(*pick_);
  }
  if (stored_picks_.in_run) stored_picks_.take();
  last_pick_ = pick_;
  last_pick_repeats_ = repeats;
}

void Instructions::enter_line(const Point3& from, const Point3& to) {
  if (line_pick_ != last_line_pick_) {
    op_.insert(op_.end(), {op::line_pick, line_pick_});
    last_line_pick_ = line_pick_;
  }
  if (pen_ != from) {
    op_.push_back(op::move);
    enter_points({&from, 1});
  }
  op_.push_back(op::line);
  enter_points({&to, 1});
  pen_ = to;
  ++lines_;
}

void Instructions::enter_polygon(std::span<const Point3> vertices,
                                 std::span<const std::uint8_t> edge_visible,
                                 const VertexShading& shading) {
  enter_pick();
  if (!shading.normals.empty() && light_ != *shading.light) {
    const auto& [toward, ambient] = *shading.light;
    op_.push_back(op::light);
    style_operands_.insert(style_operands_.end(), {toward.x, toward.y, toward.z, ambient});
    light_ = *shading.light;
  }
  if (std::ranges::any_of(edge_visible, has_kind)) {
    op_.push_back(op::side_kinds);
    side_kinds_.insert(side_kinds_.end(), edge_visible.begin(), edge_visible.end());
  }
  if (!shading.intensities.empty()) {
    op_.push_back(op::intensities);
    intensities_.insert(intensities_.end(), shading.intensities.begin(), shading.intensities.end());
  } else if (!shading.normals.empty()) {
    op_.push_back(op::normals);
    normals_.insert(normals_.end(), shading.normals.begin(), shading.normals.end());
  }
  const std::size_t start = op_.size();
  op_.resize(start + 1 + vertices.size());
  op_[start] = static_cast<std::int32_t>(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    op_[start + 1 + i] = edge_visible[i] != 0 ? op::line : op::move;
  }
  enter_points(vertices);
  pen_ = vertices.back();
  ++polygons_;
}

void Instructions::enter_text(const Point3& anchor, std::string_view characters) {
  op_.push_back(op::text);
  characters_ += characters;
  texts_.push_back({anchor, characters_.size()});
}

void Instructions::enter_points(std::span<const Point3> points) {
  if (!stores_z_) {
    if (flat_points_.empty()) flat_z_ = points.front().z;
    for (const Point3& p : points) {
      if (p.z != flat_z_) {
        add_z();
        break;
      }
    }
  }
  if (stores_z_) {
    points_.insert(points_.end(), points.begin(), points.end());
  } else {
    for (const Point3& p : points) flat_points_.emplace_back(p);
  }
}

void Instructions::add_z() {
  points_.reserve(flat_points_.size());
  for (const Point2& p : flat_points_) points_.emplace_back(p, flat_z_);
  std::vector<Point2>().swap(flat_points_);
  stores_z_ = true;
}

bool Instructions::shows() const {
  return std::ranges::any_of(op_, [](std::int32_t code) {
    return code == op::line_solid || code == op::line_dashed || code == op::fill_solid ||
           code == op::fill_shadowed;
  });
}

std::size_t Instructions::bytes() const {
  return op_.size() * sizeof(op_[0]) + points_.size() * sizeof(points_[0]) +
         flat_points_.size() * sizeof(flat_points_[0]) +
         style_operands_.size() * sizeof(style_operands_[0]) +
         intensities_.size() * sizeof(intensities_[0]) + normals_.size() * sizeof(normals_[0]) +
         side_kinds_.size() + line_kind_styles_.size() * sizeof(line_kind_styles_[0]) +
         texts_.size() * sizeof(texts_[0]) + characters_.size() +
         annotations_.size() * sizeof(annotations_[0]) + (as_entered_ ? as_entered_->bytes() : 0);
}

/// Reserves at least twice the present capacity, so that many small calls cost no more than one.
void Instructions::reserve_more(std::size_t codes, std::size_t points, std::size_t fills) {
  const auto make_room = [](auto& array, std::size_t size) {
    if (size > array.capacity()) array.reserve(std::max(size, 2 * array.capacity()));
  };
  make_room(op_, op_.size() + codes + fills);
  make_room(style_operands_, style_operands_.size() + 3 * fills);
  make_room(points_, points_.size() + flat_points_.size() + points);
}

void Instructions::free_room() {
  displayfile::free_room(op_);
  displayfile::free_room(points_);
  displayfile::free_room(flat_points_);
  displayfile::free_room(style_operands_);
  displayfile::free_room(intensities_);
  displayfile::free_room(normals_);
  displayfile::free_room(side_kinds_);
  displayfile::free_room(line_kind_styles_);
  displayfile::free_room(texts_);
  displayfile::free_room(characters_);
  displayfile::free_room(annotations_);
  if (as_entered_) as_entered_->free_room();
}

}  // namespace displayfile
