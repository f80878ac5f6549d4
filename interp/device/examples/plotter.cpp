// A device of an application's own: writes visible lines as HPGL, the language of pen plotters.
//   plotter DRAWING-PROGRAM >plot.hpgl
#include <cmath>
#include <exception>
#include <iostream>

#include "displayfile/displayfile.h"

namespace {

/// A square picture on the paper, 10,000 plotter units (0.025 mm) wide. Each pick identifier modulo
/// the number of pens has a pen.
class Plotter : public displayfile::OutputDevice {
 public:
  explicit Plotter(std::ostream& out) : out_(out) { out_ << "IN;"; }
  ~Plotter() override { out_ << "PU;SP0;\n"; }

  void fill(const displayfile::DrawnPolygon&) override {}  // pens do not fill

  void edges(const displayfile::DrawnPolygon& polygon) override {
    take_pen(polygon.pick);
    displayfile::Point3 from = polygon.vertices.back();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const displayfile::Point3& to = polygon.vertices[i];
      if (polygon.sides[i] == displayfile::DrawnPolygon::kDrawnSide) draw(from, to);
      from = to;
    }
  }

  void line(const displayfile::DrawnLine& line) override {
    take_pen(0);
    draw(line.from, line.to);
  }

 private:
  static constexpr int kPens = 8, kNoPen = -1;
  static constexpr double kUnits = 10'000.0;

  void take_pen(int pick) {
    const int pen = pick % kPens + 1;
    if (pen != pen_) out_ << "SP" << pen << ';';
    pen_ = pen;
  }

  static long units(double coordinate) { return std::lround(kUnits * coordinate); }

  void draw(const displayfile::Point3& from, const displayfile::Point3& to) {
    out_ << "PU" << units(from.x) << ',' << units(from.y) << ';';
    out_ << "PD" << units(to.x) << ',' << units(to.y) << ';';
  }

  std::ostream& out_;
  int pen_ = kNoPen;
};

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) throw displayfile::Error("expected the name of a drawing program");
  displayfile::GraphicsSystem system;
  displayfile::replay_file(arguments[1], system);
  Plotter plotter(std::cout);
  displayfile::draw(system, plotter, {.surfaces = {.method = displayfile::HiddenMethod::franklin}});
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
