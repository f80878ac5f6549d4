#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/draw/picture_plan.h"
#include "programs/options/mesh_words.h"
#include "programs/options/shading_word.h"

namespace displayfile {

/// Inputs entered into a system of their own, as the command draws them.
class DrawnInputs {
 public:
  /// How they are used, besides raster pictures.
  enum class Use { picture, display_file };
  /// Throws Error as enter_inputs does. The inputs must outlive it.
  DrawnInputs(std::span<const std::string> inputs, const PicturePlan& call, const MeshWords& meshes,
              const StartingShading& shading, Use use = Use::display_file);
  DrawnInputs(const DrawnInputs&) = delete;
  DrawnInputs& operator=(const DrawnInputs&) = delete;

  /// Bare meshes for which only a pixel picture by an image-space method is requested are only
  /// retained: the display file is then empty.
  const GraphicsSystem& system() const { return system_; }
  /// That of the call, settled, with the chosen method for meshes alone.
  const PicturePlan& plan() const { return plan_; }

  std::size_t polygons() const;  ///< of the display file, or retained

  /// Draws them; `kept` is the sorted display file, if any. Returns the warnings of the drawing.
  std::vector<DrawWarning> draw(SortedDisplayFile& kept, const WorkProgress& progress) const;

  /// Warns if something reaches beyond a window that no program set, or beyond the paper at an
  /// exact scale in a window that a program set. Error: beyond the paper otherwise. Inputs that
  /// were not retained are entered once more for the former.
  void check_window() const;

  /// Warns, with the reason, if the picture is empty, and returns true then. To work out the
  /// reason, inputs that were not retained are entered once more.
  bool warn_if_nothing_is_seen(const std::vector<DrawWarning>& warned) const;

 private:
  void enter(GraphicsSystem& system) const;
  bool are_bare_meshes() const;
  bool are_programs() const;
  std::string first_name() const;
  std::string why_nothing_is_seen() const;

  std::span<const std::string> inputs_;
  PicturePlan plan_;
  MeshWords meshes_;
  StartingShading shading_;
  RetainedScene scene_;  // of the system, if it retains
  GraphicsSystem system_;
};

}  // namespace displayfile
