#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/python/system.h"

namespace displayfile::python {

inline int next_name(const GraphicsSystem& system) {
  std::int64_t name = 0;
  for (const Segment& segment : system.display_file().segments()) {
    name = std::max<std::int64_t>(name, segment.name());
  }
  if (name == std::numeric_limits<int>::max())
    throw Error("no segment name is left above all others");
  return static_cast<int>(name + 1);
}

/// Calls enter() within the open segment, or else in one of its own. Returns the segment's name.
template <class Enter>
int in_segment(GraphicsSystem& system, const std::optional<int>& name, const Enter& enter) {
  if (const auto open = system.open_segment_name(); open && !name) {
    enter();
    return *open;
  }
  const int own = name ? *name : next_name(system);
  if (system.open_segment_name()) system.open_segment(own);  // which is refused
  system.enter_segments([&] {
    system.open_segment(own);
    enter();
    system.close_segment();
  });
  return own;
}

/// How arrays are entered.
struct Entry {
  std::optional<int> segment;
  bool is_lit = true;  ///< false: a default light leaves fills in their colours
};

/// Calls enter() in a segment, with the looks of meshes. If it throws, looks are as they were.
template <class Enter>
int in_segment_with_looks(GraphicsSystem& system, FollowedView& followed, const Entry& entry,
                          const Enter& enter) {
  followed.place(system);
  int segment = 0;
  const auto enter_all = [&] {
    with_mesh_looks(system, {}, [&] {
      if (!entry.is_lit) {
        SystemInside::by_default(system, Setting::light,
                                 [&] { system.set_light(mesh_light(system), 1.0); });
      }
      segment = in_segment(system, entry.segment, enter);
    });
  };
  // If no segment is open and this throws, the system is unchanged.
  system.open_segment_name() ? enter_all() : system.enter_segments(enter_all);
  return segment;
}

/// The same as in_segment, seen by a camera that follows it if no view was set, and with the looks
/// of meshes then. Calls enter(system).
template <class Enter>
int in_followed_segment(System& self, const Entry& entry, const Enter& enter) {
  return self.work([&](GraphicsSystem& system, Renderer&) {
    FollowedView& followed = self.followed();
    const auto enter_in = [&] { enter(system); };
    if (followed.follows()) return in_segment_with_looks(system, followed, entry, enter_in);
    if (!followed.would_begin(system)) return in_segment(system, entry.segment, enter_in);
    const FollowedView before = followed;
    int segment = 0;
    try {
      system.all_or_nothing([&] {  // there is little yet
        followed.begin_by_default(system);
        segment = in_segment_with_looks(system, followed, entry, enter_in);
      });
    } catch (...) {
      followed = before;
      throw;
    }
    return segment;
  });
}

/// Enters pieces of faces without their sides; and then, if sides are drawn, calls enter_whole(),
/// which enters the faces, for their sides alone.
inline void enter_in_pieces(GraphicsSystem& system, const ManyPolygons& pieces,
                            const std::function<void()>& enter_whole) {
  const bool draws_sides = system.looks().attributes.is_outlined();
  SystemInside::keep_line_style(system, [&] {
    if (draws_sides) system.set_line_style({LineStyle::Kind::none});
    system.polygons_abs_3(pieces);
  });
  if (!draws_sides) return;
  SystemInside::keep_fill_style(system, [&] {
    system.set_fill_style({FillStyle::Kind::hollow});
    enter_whole();
  });
}

}  // namespace displayfile::python
