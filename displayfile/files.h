#pragma once

/// Drawing programs, recorded, replayed and called by name; dumps; and where output goes.

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

class DisplayFile;
class GraphicsSystem;

// Output.

/// Where output goes: to a file, by its path, or to a stream of the caller's, in memory for
/// example. A stream gets all of it at once when it is ready, and nothing if that fails; files
/// appear whole or not at all.
class Destination {
 public:
  Destination(const std::string& path) : path_(path) {}
  Destination(const char* path) : path_(path) {}
  /// A std::filesystem::path.
  template <class Path>
  requires requires(const Path& path) { path.lexically_normal().string(); }
  Destination(const Path& path) : path_(path.string()) {}
  /// It must live on until all is written.
  Destination(std::ostream& stream) : path_("the stream"), stream_(&stream) {}

  const std::string& name() const { return path_; }  ///< the path, or words for messages
  std::ostream* stream() const { return stream_; }   ///< null: a file
  bool is_file() const { return stream_ == nullptr; }
  /// With its dot; of a stream none.
  std::string extension() const;

 private:
  std::string path_;
  std::ostream* stream_ = nullptr;
};

// Drawing programs.

/// Carries out a drawing program: UTF-8 text, one user routine a line (the application API's
/// names, hyphens for underscores) followed by its arguments, separated by blanks. `#` starts
/// a comment; blank lines, CR LF and a byte order mark are passed over.
///
/// Throws Error with the message "FILE:LINE:COLUMN: what is wrong and what was expected" for a
/// line that is not understood or that the system refuses, for text that is not UTF-8, and for
/// a segment that the program leaves open. Columns count characters from 1. What the lines
/// before the error did stands.
void replay(std::string_view text, std::string_view file_name, GraphicsSystem& system);

/// Carries out the drawing program in a file; "-" is standard input. Throws as replay does, and
/// Error if the file cannot be read.
void replay_file(const std::string& path, GraphicsSystem& system);

/// Writes what is called through the application API as a drawing program. Replayed, the
/// program makes the same display file, bit for bit: numbers are written in the shortest
/// form that reads back to the same double.
///
/// A stream that fails loses lines; its state says so. If it throws then, by its exceptions(), that
/// comes out of the routine, which has been carried out, or out of all_or_nothing and
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

/// A user routine as drawing programs call it: its name, its arguments in words, such as "x y z",
/// and what it does.
struct UserRoutine {
  static constexpr int kVaries = -1;

  std::string_view name;
  std::string_view expected;      ///< the arguments; empty: none
  int arguments;                  ///< how many words they are; kVaries: as `expected` says
  std::string_view meaning;       ///< in sentences, with defaults in brackets
  std::string_view section = {};  ///< what it is about, such as "View"; they follow each other
};

/// All of them, in the order of the table: bindings to other languages are made from it, or checked
/// against it.
std::span<const UserRoutine> user_routines();

/// Calls the user routine of that name with arguments written as in a drawing program
/// (displayfile/text/drawing_programs.md), on one line. A number is the double that its shortest
/// decimal form stands for, so nothing is lost by writing it. Throws Error for an unknown routine
/// or wrong arguments, and what the routine throws.
void call_user_routine(GraphicsSystem& system, std::string_view name, std::string_view arguments);

// Dumps.

/// Writes the canonical dump: the instructions of every segment as the interpreter meets them,
/// one a line, points after the image transformation (normalised device coordinates), numbers
/// in the shortest form that reads back to the same double.
///
///   displayfile-dump 1
///   segment NAME visible|invisible       (per segment, in order of creation)
///   fill solid R G B | fill hollow
///   shadow R G B X Y Z W                 (of a fill that shows shadows, after it: its colour
///   there,
///                                        and the light as a homogeneous point)
///   line-style solid R G B WIDTH | line-style dashed R G B WIDTH DASH GAP | line-style none
///   pick N
///   intensities I1 I2 ...                (of a shaded polygon, which follows: one for each side's
///                                        end, in that order; they multiply the fill colour)
///   move X Y Z
///   line X Y Z
///   polygon SIDES X Y Z                  (its last vertex, where it starts; then SIDES lines)
///   line X Y Z | move X Y Z              (a side to that vertex; move: an invisible edge)
///   text-style SIZE left|centre|right [always]
///   text X Y Z "CHARACTERS"              (a backslash before quotation marks and backslashes; the
///                                        pen stays where it is)
///   end                                  (of the dump)
///
/// Sorted segments are dumped back to front, their texts after all else. Where all visible segments
/// were sorted together, a segment line stands wherever the segment changes, styles stay in force
/// across it, and the segments of which nothing is drawn follow at the end.
///
/// With `fills`, all solid fills have that colour, without shadows and intensities, as the colour
/// rule draws them (interp/raster/colour_rule.md).
///
/// The stream's state is bad if it could not be written.
void dump(const DisplayFile& display_file, std::ostream& out,
          const std::optional<Colour>& fills = {});
std::string dump(const DisplayFile& display_file, const std::optional<Colour>& fills = {});

}  // namespace displayfile
