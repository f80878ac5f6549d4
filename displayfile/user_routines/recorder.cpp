#include "displayfile/files.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <ostream>
#include <utility>

#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

struct Append {
  std::string& line;
  void operator()(double v) const {
    if (std::isnan(v)) {
      line += " nan";  // of either sign
    } else {
      fmt::format_to(std::back_inserter(line), " {}", v);
    }
  }
  void operator()(int v) const { fmt::format_to(std::back_inserter(line), " {}", v); }
  void operator()(bool v) const { line += v ? " on" : " off"; }
  void operator()(std::string_view v) const { (line += ' ') += v; }
};

}  // namespace

void Recorder::write(std::string_view routine, std::initializer_list<Argument> arguments,
                     std::span<const double> numbers) {
  line_ = routine;
  for (const Argument& a : arguments) std::visit(Append{line_}, a);
  for (const double number : numbers) Append{line_}(number);
  write_line();
}

void Recorder::write(std::string_view routine, std::span<const Point3> points, int coordinates) {
  line_ = routine;
  for (const Point3& p : points) {
    if (points.size() > 1) line_ += ' ';  // two blanks between points
    for (int i = 0; i < coordinates; ++i) Append{line_}(p[i]);
  }
  write_line();
}

void Recorder::comment(std::string_view text) {
  line_ = "# " + drawable(text);
  write_line();
}

void Recorder::write_line() {
  line_ += '\n';
  if (holds_ == 0) {
    out_ << line_;
  } else {
    held_ += line_;
  }
}

Recorder::Hold::Hold(Recorder* recorder) : recorder_(recorder) {
  if (recorder_ == nullptr) return;
  begin_ = recorder_->held_.size();
  ++recorder_->holds_;
}

Recorder::Hold::~Hold() {
  if (recorder_ == nullptr) return;
  recorder_->held_.resize(begin_);
  --recorder_->holds_;
}

void Recorder::Hold::end() {
  Recorder* const recorder = std::exchange(recorder_, nullptr);
  if (recorder == nullptr || --recorder->holds_ > 0) return;
  const std::string held = std::exchange(recorder->held_, {});
  recorder->out_ << held;
}

}  // namespace displayfile
