#pragma once

namespace displayfile {

/// What an application may say of how things are drawn. Where it did not, a default holds, and a
/// mesh brings its own (displayfile/mesh/mesh.h).
enum class Setting {
  camera,  ///< reference point, normal, distance and up of the view plane, and the projection
  view_depth,
  front_plane_clipping,
  back_plane_clipping,
  window,
  viewport,
  window_fit,
  fill_style,
  line_style,
  light,
  hidden_line_removal,
  hidden_method,
  back_face_removal,
  lines,
};

/// Those settings that an application said.
class SaidSettings {
 public:
  bool contains(Setting setting) const { return (bits_ & bit(setting)) != 0; }
  void insert(Setting setting) { bits_ |= bit(setting); }

 private:
  static unsigned bit(Setting setting) { return 1u << static_cast<unsigned>(setting); }
  unsigned bits_ = 0;
};

}  // namespace displayfile
