#include "tests/bench/sketch.h"

#include <fmt/format.h>

#include <fstream>

#include "clip/error.h"
#include "tests/bench/text.h"

namespace displayfile::bench {

std::optional<std::string> Sketch::version() {
  const Finished answer = run({"sketch", "-v"});
  const std::string before = "version ";
  const std::size_t at = answer.output.find(before);
  if (!answer.succeeded || at == std::string::npos) return std::nullopt;
  const std::string rest = answer.output.substr(at + before.size());
  return "Sketch " + rest.substr(0, rest.find(' '));
}

Sketch::Sketch(const DeviceScene& scene, const TemporaryFolder& folder)
    : input_(folder.file("scene.sk")), output_(folder.file("scene.tex")) {
  std::ofstream file(input_);
  constexpr double kCentimetres = 10.0;
  for (const Primitives::Item& item : scene.polygons) {
    file << "polygon[cull=false]";
    for (std::uint32_t i = 0; i < item.sides; ++i) {
      const Point3 p = kCentimetres * scene.points[item.first + i];
      file << fmt::format("({:.15f},{:.15f},{:.15f})", p.x, p.y, p.z);
    }
    file << '\n';
  }
  file.close();
  if (!file) throw Error(input_ + ": cannot be written");
}

void Sketch::draw(Sort sort) const {
  std::vector<std::string> command{"sketch"};
  if (sort == Sort::bsp) command.push_back("-b");
  command.insert(command.end(), {input_, "-o", output_});
  if (!run(command).succeeded) throw Error("sketch failed on " + input_);
}

std::size_t Sketch::fragments(Sort sort) const {
  draw(sort);
  return occurrences(read_text(output_), "\\pspolygon");
}

}  // namespace displayfile::bench
