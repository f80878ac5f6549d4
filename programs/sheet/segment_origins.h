#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "programs/sheet/turned_shape.h"

namespace displayfile {

/// Where a segment's polygons come from.
struct SegmentOrigin {
  std::size_t input = 0;         ///< index of an input
  std::string object{};          ///< name in a mesh; may be empty
  std::optional<int> segment{};  ///< number in a drawing program
  std::vector<TurnedShape> turned{};
};

/// The origins of a system's segments, by their names, which change while programs are entered.
class SegmentOrigins {
 public:
  /// The origin of a segment; if unknown, that of the input entered last.
  SegmentOrigin of(int segment) const;
  void rename(int from, int to);

  /// Runs a drawing program, as replay does.
  void replay_program(std::string_view program, std::string_view file_name, std::size_t input,
                      GraphicsSystem& system);
  /// For a mesh whose objects have been entered as the system's last segments.
  void add_mesh(const Mesh& mesh, std::size_t input, const GraphicsSystem& system);

 private:
  void after_line(std::string_view routine, std::string_view line, const GraphicsSystem& system);

  std::map<int, SegmentOrigin> of_;
  std::size_t last_input_ = 0;
};

}  // namespace displayfile
