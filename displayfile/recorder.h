#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "clip/point.h"

namespace displayfile {

/// Writes what is called through the application API as a drawing program. Replayed, the
/// program makes the same display file, bit for bit: numbers are written in the shortest
/// form that reads back to the same double.
///
/// A stream that fails loses lines and tells so itself. If it throws then, as its exceptions() say,
/// that comes out of the routine, which has been carried out, or out of all_or_nothing and
/// enter_segments, which leave the state as it was.
class Recorder {
 public:
  explicit Recorder(std::ostream& out) : out_(out) {}

  using Argument = std::variant<double, int, bool, std::string_view>;  ///< bool: on or off

  /// One line: the routine's name in drawing programs and its arguments, the last of which may be
  /// any number of numbers.
  void write(std::string_view routine, std::initializer_list<Argument> arguments,
             std::span<const double> numbers = {});
  /// One line of points, `coordinates` (2 or 3) of each.
  void write(std::string_view routine, std::span<const Point3> points, int coordinates);
  /// One line that replaying passes over. What a drawing program may not hold becomes '?'.
  void comment(std::string_view text);

  /// While it lives, lines are held back: end() writes them, and without it they are dropped. Holds
  /// may stand within each other: the outermost one writes.
  class Hold {
   public:
    explicit Hold(Recorder* recorder);  ///< null: nothing is recorded
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

    void end();  ///< throws what the stream throws

   private:
    Recorder* recorder_;
    std::size_t begin_ = 0;
  };

 private:
  void write_line();  ///< line_, with its end

  std::ostream& out_;
  std::string line_, held_;
  int holds_ = 0;
};

}  // namespace displayfile
