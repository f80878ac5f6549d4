#include "programs/sheet/segment_origins.h"

#include <utility>

#include "displayfile/segments/display_file.h"
#include "displayfile/text/characters.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

SegmentOrigin SegmentOrigins::of(int segment) const {
  const auto found = of_.find(segment);
  return found == of_.end() ? SegmentOrigin{last_input_} : found->second;
}

void SegmentOrigins::rename(int from, int to) {
  if (auto node = of_.extract(from)) {
    node.key() = to;
    of_.insert(std::move(node));
  }
}

void SegmentOrigins::after_line(std::string_view routine, std::string_view text,
                                const GraphicsSystem& system) {
  if (routine == "open-segment") {
    const int segment = *system.open_segment_name();
    of_[segment] = {.input = last_input_, .segment = segment};
  } else if (routine == "rename-segment") {
    ProgramLine line;
    line.split(text);
    const int from = line.take<int>();
    rename(from, line.take<int>());
  } else if (makes_turned_shape(routine)) {
    auto shape = turned_shape(text, system.modelling_transformation());
    if (shape) of_[*system.open_segment_name()].turned.push_back(*std::move(shape));
  }
}

void SegmentOrigins::replay_program(std::string_view program, std::string_view file_name,
                                    std::size_t input, GraphicsSystem& system) {
  last_input_ = input;
  std::string_view rest = without_byte_order_mark(program);
  std::size_t next = 1;  // the number of the line that the rest begins with
  replay_lines(program, file_name, system, [&](std::size_t number, std::string_view routine) {
    for (; next < number; ++next) rest.remove_prefix(rest.find('\n') + 1);
    after_line(routine, rest.substr(0, rest.find('\n')), system);
  });
}

void SegmentOrigins::add_mesh(const Mesh& mesh, std::size_t input, const GraphicsSystem& system) {
  last_input_ = input;
  const auto& segments = system.display_file().segments();
  const std::size_t first = segments.size() - mesh.objects.size();
  for (std::size_t k = 0; k < mesh.objects.size(); ++k) {
    of_[segments[first + k].name()] = {.input = input, .object = mesh.objects[k].name};
  }
}

}  // namespace displayfile
