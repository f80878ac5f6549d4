#include "tests/bench/gl2ps_sort.h"

#include <fmt/format.h>
#include <gl2ps.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "clip/error.h"
#include "programs/bench/side_by_side.h"
#include "tests/bench/text.h"

namespace displayfile::bench {

namespace {

constexpr GLint kWindow = 1024;

/// A page of gl2ps, written to memory.
class Page {
 public:
  Page(const DeviceScene& triangles, GLint format) : stream_(open_memstream(&text_, &size_)) {
    std::array<GLint, 4> viewport{0, 0, kWindow, kWindow};
    constexpr GLint kOptions = GL2PS_NO_OPENGL_CONTEXT | GL2PS_NO_BLENDING | GL2PS_SILENT;
    if (stream_ == nullptr ||
        gl2psBeginPage("", "", viewport.data(), format, GL2PS_BSP_SORT, kOptions, GL_RGBA, 0,
                       nullptr, 0, 0, 0, 0, stream_, "") != GL2PS_SUCCESS) {
      throw Error("gl2ps: the page cannot be begun");
    }
    for (const SortItems::Item& item : triangles.polygons) add(&triangles.points[item.first]);
  }
  ~Page() {
    std::fclose(stream_);
    std::free(text_);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void end() {
    if (gl2psEndPage() != GL2PS_SUCCESS) throw Error("gl2ps: the page cannot be ended");
  }
  std::string_view text() {
    std::fflush(stream_);
    return {text_, size_};
  }

 private:
  static void add(const Point3* corners) {
    std::array<GL2PSvertex, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      // A window's depth is smaller where it is nearer.
      triangle[i] = {
          {static_cast<GLfloat>(corners[i].x * kWindow),
           static_cast<GLfloat>(corners[i].y * kWindow), static_cast<GLfloat>(1.0 - corners[i].z)},
          {0.5f, 0.5f, 0.5f, 1.0f}};
    }
    gl2psAddPolyPrimitive(GL2PS_TRIANGLE, 3, triangle.data(), 0, 0, 0, 0, 0, 1, 0, 0, 0);
  }

  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;
};

}  // namespace

std::optional<std::string> Gl2psSort::version() {
  return fmt::format("gl2ps {}.{}.{}", GL2PS_MAJOR_VERSION, GL2PS_MINOR_VERSION,
                     GL2PS_PATCH_VERSION);
}

double Gl2psSort::seconds(const DeviceScene& triangles) {
  Page page(triangles, GL2PS_TEX);
  return bench::seconds([&] { page.end(); });
}

std::size_t Gl2psSort::fragments(const DeviceScene& triangles) {
  Page page(triangles, GL2PS_SVG);
  page.end();
  return occurrences(page.text(), "<polygon");
}

}  // namespace displayfile::bench
