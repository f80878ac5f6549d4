#pragma once

/// Drawing programs: recording, replaying, routines by name; dumps; output destinations.

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

/// Where output goes: a file, by its path, or a stream of the caller's. A stream gets all of the
/// output at once, or nothing after an error; files are written completely or not at all.
class Destination {
 public:
  Destination(const std::string& path) : path_(path) {}
  Destination(const char* path) : path_(path) {}
  /// A std::filesystem::path.
  template <class Path>
  requires requires(const Path& path) { path.lexically_normal().string(); }
  Destination(const Path& path) : path_(path.string()) {}
  /// The stream must outlive the output.
  Destination(std::ostream& stream) : path_("the stream"), stream_(&stream) {}

  const std::string& name() const { return path_; }  ///< the path, or a name for messages
  std::ostream* stream() const { return stream_; }   ///< null: a file
  bool is_file() const { return stream_ == nullptr; }
  /// With its dot; empty for a stream.
  std::string extension() const;

 private:
  std::string path_;
  std::ostream* stream_ = nullptr;
};

// Drawing programs.

/// Runs a drawing program: UTF-8 text with one user routine per line (the application API's names
/// with hyphens for underscores) followed by its arguments, separated by blanks. `#` starts a
/// comment; blank lines, CR LF and a byte order mark are allowed.
///
/// Throws Error with the message "FILE:LINE:COLUMN: what is wrong and what was expected" for a line
/// that is not understood or that the system refuses, for text that is not UTF-8, and for a segment
/// left open. Columns count characters from 1. Lines before the error keep their effect.
void replay(std::string_view text, std::string_view file_name, GraphicsSystem& system);

/// Runs the drawing program in a file; "-" is standard input. Throws as replay does, and Error if
/// the file cannot be read.
void replay_file(const std::string& path, GraphicsSystem& system);

/// Writes calls of the application API as a drawing program. Replaying it makes the same display
/// file, bit for bit: numbers are written in the shortest form that reads back to the same double.
///
/// If the stream fails, lines are lost and its state says so. If it throws, by its exceptions(),
/// the exception leaves the routine, which has been carried out, or all_or_nothing or
/// enter_segments, which restore the state.
class Recorder {
 public:
  explicit Recorder(std::ostream& out) : out_(out) {}

  using Argument = std::variant<double, int, bool, std::string_view>;  ///< bool: on or off

  /// Writes one line: the routine's name in drawing programs and its arguments, then `numbers`.
  void write(std::string_view routine, std::initializer_list<Argument> arguments,
             std::span<const double> numbers = {});
  /// Writes one line of points with `coordinates` (2 or 3) numbers each.
  void write(std::string_view routine, std::span<const Point3> points, int coordinates);
  /// Writes a comment line. Characters that a drawing program may not hold become '?'.
  void comment(std::string_view text);

  /// Holds back lines during its lifetime: end() writes them; without end() they are dropped. Holds
  /// may nest; the outermost one writes.
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

/// A user routine as drawing programs call it: name, arguments in words, such as "x y z", and
/// meaning.
struct UserRoutine {
  static constexpr int kVaries = -1;

  std::string_view name;
  std::string_view expected;      ///< the arguments; empty: none
  int arguments;                  ///< number of arguments; kVaries: as in `expected`
  std::string_view meaning;       ///< in sentences, with defaults in brackets
  std::string_view section = {};  ///< topic, such as "View"; routines of a topic are adjacent
};

/// All user routines, in the order of the table. Bindings to other languages are made from it or
/// checked against it.
std::span<const UserRoutine> user_routines();

/// Calls a user routine by name, with arguments written as in a drawing program
/// (displayfile/text/drawing_programs.md) on one line. A number is read as the double of its
/// shortest decimal form, so writing it loses nothing. Throws Error for an unknown routine or wrong
/// arguments, and what the routine throws.
void call_user_routine(GraphicsSystem& system, std::string_view name, std::string_view arguments);

// Dumps.

/// Writes the canonical dump: the instructions of every segment as the interpreter reads them, one
/// per line, points after the image transformation (normalised device coordinates), numbers in the
/// shortest form that reads back to the same double.
///
///   displayfile-dump 1
///   segment NAME visible|invisible       (per segment, in order of creation)
///   fill solid R G B | fill hollow
///   shadow R G B X Y Z W                 (after a fill that shows shadows: its colour in shadow,
///                                        and the light as a homogeneous point)
///   line-style solid R G B WIDTH | line-style dashed R G B WIDTH DASH GAP | line-style none
///   pick N
///   intensities I1 I2 ...                (before a shaded polygon: one for each side's end, in
///                                        that order; they multiply the fill colour)
///   move X Y Z
///   line X Y Z
///   polygon SIDES X Y Z                  (its last vertex, its start; SIDES lines follow)
///   line X Y Z | move X Y Z              (a side to that vertex; move: an invisible edge)
///   text-style SIZE left|centre|right [always]
///   text X Y Z "CHARACTERS"              (a backslash before quotation marks and backslashes; the
///                                        pen stays where it is)
///   annotation KIND SIZE mm|px arrow|dot entered|auto R G B DX DY [X Y Z ...] "TEXT" ["NAME"]
///                                        (after all else of its segment: its style, the offset of
///                                        its text, its points, and its text)
///   end                                  (of the dump)
///
/// Sorted segments are dumped back to front, then their texts and annotation. Where all visible
/// segments were sorted together, a segment line marks each change of segment, styles stay in force
/// across it, and segments without output follow at the end.
///
/// With `fills`, all solid fills have that colour, without shadows or intensities, as the colour
/// rule draws them (interp/raster/colour_rule.md).
///
/// If writing fails, the stream's state is bad.
void dump(const DisplayFile& display_file, std::ostream& out,
          const std::optional<Colour>& fills = {});
std::string dump(const DisplayFile& display_file, const std::optional<Colour>& fills = {});

}  // namespace displayfile
