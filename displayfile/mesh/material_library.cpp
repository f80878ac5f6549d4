// The material library of Wavefront OBJ: Alias|Wavefront, "MTL material format", 1995.

#include "displayfile/mesh/obj_materials.h"

#include <string_view>
#include <utility>

#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

class MaterialReader {
 public:
  explicit MaterialReader(const MeshFile& file) : text_(text_of(file.path, file.data)) {}

  MaterialLibrary read() && {
    do {
      read_statement(text_.field());
    } while (text_.next_line());
    for (auto& [name, material] : library_) forget_black_under_texture(material);
    return std::move(library_);
  }

 private:
  void read_statement(std::string_view keyword) {
    if (keyword == "newmtl") {
      material_ = &library_[std::string(without_quotation_marks(text_.rest_of_line()))];
      has_dissolve_ = false;
    } else if (material_ == nullptr) {
      return;  // of no material
    } else if (keyword == "Kd") {
      read_colour(text_.field());
    } else if (keyword == "d") {
      material_->transparent = dissolve() < 1.0;
      has_dissolve_ = true;
    } else if (keyword == "Tr" && !has_dissolve_) {
      const double transparency = part(text_.field());
      // Some programs write 1 for opaque.
      material_->transparent = transparency > 0.0 && transparency < 1.0;
    } else if (keyword == "map_Kd" || keyword == "map_kd") {
      material_->textured = true;
    } else if (keyword == "map_d") {
      material_->transparent = true;
    }
  }

  /// Programs that write black beside a texture mean the texture alone, which is not drawn.
  static void forget_black_under_texture(Mesh::Material& material) {
    if (material.textured && material.colour == Colour(0.0)) material.colour.reset();
  }

  /// Reads r g b, or r for all three; the colour stays unknown if it is given by a spectrum or as
  /// CIE XYZ.
  void read_colour(std::string_view red) {
    if (red == "spectral" || red == "xyz") return;
    Colour colour(part(red));
    if (const std::string_view green = text_.field(); TextCursor::is_content(green)) {
      colour.g = part(green);
      colour.b = part(text_.field());
    }
    material_->colour = brought_into_range(colour);
  }

  double dissolve() {
    const std::string_view f = text_.field();
    return part(f == "-halo" ? text_.field() : f);
  }

  double part(std::string_view f) const { return text_.finite(f, "a part of a colour"); }

  TextCursor text_;
  MaterialLibrary library_;
  Mesh::Material* material_ = nullptr;  // to which the statements apply
  bool has_dissolve_ = false;
};

}  // namespace

MaterialLibrary read_material_library(const MeshFile& file) { return MaterialReader(file).read(); }

}  // namespace displayfile
