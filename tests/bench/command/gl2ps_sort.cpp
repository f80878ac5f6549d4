#include "tests/bench/command/gl2ps_sort.h"

#include <fmt/format.h>
#include <gl2ps.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/common.hpp>
#include <string_view>

#include "clip/base/error.h"
#include "tests/bench/command/timing.h"

namespace displayfile::bench {

namespace {

/// A triangle's number in its colour, eight bits a component. Cuts interpolate between equal
/// colours, which moves them by less than half a step.
constexpr std::uint32_t kSteps = 256;

void write_number(std::uint32_t number, GLfloat* colour) {
  for (int i = 0; i < 3; ++i, number /= kSteps) {
    colour[i] = static_cast<GLfloat>(number % kSteps) / static_cast<GLfloat>(kSteps);
  }
}

std::uint32_t read_number(const std::array<double, 3>& colour) {
  std::uint32_t number = 0;
  for (std::size_t i = 3; i-- > 0;) {
    number = number * kSteps + static_cast<std::uint32_t>(std::lround(colour[i] * kSteps));
  }
  return number;
}

/// A page of gl2ps, written to memory.
class Page {
 public:
  Page(const Gl2psSort& sort, GLint format) : stream_(open_memstream(&text_, &size_)) {
    std::array<GLint, 4> viewport{0, 0, sort.window.width, sort.window.height};
    constexpr GLint kOptions = GL2PS_NO_OPENGL_CONTEXT | GL2PS_NO_BLENDING | GL2PS_SILENT;
    const GLint options = kOptions | (sort.options.best_root ? GL2PS_BEST_ROOT : GL2PS_NONE) |
                          (sort.options.occlusion_cull ? GL2PS_OCCLUSION_CULL : GL2PS_NONE);
    if (stream_ == nullptr ||
        gl2psBeginPage("", "", viewport.data(), format, GL2PS_BSP_SORT, options, GL_RGBA, 0,
                       nullptr, 0, 0, 0, 0, stream_, "") != GL2PS_SUCCESS) {
      throw Error("gl2ps: the page cannot be begun");
    }
    for (std::size_t i = 0; i + 2 < sort.corners.size(); i += 3) {
      add(sort.corners.subspan(i, 3), sort.window, static_cast<std::uint32_t>(i / 3));
    }
  }
  ~Page() {
    std::fclose(stream_);
    std::free(text_);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void end() {
    const GLint ended = gl2psEndPage();
    if (ended != GL2PS_SUCCESS && ended != GL2PS_NO_FEEDBACK) {
      throw Error("gl2ps: the page cannot be ended");
    }
  }
  const char* text() {
    std::fflush(stream_);
    return text_;
  }

 private:
  static void add(std::span<const Point3> corners, const PictureSize& window,
                  std::uint32_t number) {
    std::array<GL2PSvertex, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      // A window's depth is smaller where it is nearer.
      triangle[i] = {{static_cast<GLfloat>(corners[i].x * window.width),
                      static_cast<GLfloat>(corners[i].y * window.height),
                      static_cast<GLfloat>(1.0 - corners[i].z)},
                     {0.0f, 0.0f, 0.0f, 1.0f}};
      write_number(number, triangle[i].rgba);
    }
    gl2psAddPolyPrimitive(GL2PS_TRIANGLE, 3, triangle.data(), 0, 0, 0, 0, 0, 1, 0, 0, 0);
  }

  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_;
};

/// The numbers that stand after a word, each led by a brace or a comma.
template <std::size_t kNumbers>
std::array<double, kNumbers> numbers_after(const char* at) {
  std::array<double, kNumbers> numbers{};
  for (double& number : numbers) {
    while (*at == '{' || *at == '}' || *at == ',' || *at == 'p' || *at == 't') ++at;
    char* end = nullptr;
    number = std::strtod(at, &end);
    if (end == at) throw Error("gl2ps: its output cannot be read");
    at = end;
  }
  return numbers;
}

/// A piece as written in PostScript, whose numbers have six digits: its triangle, and the sum of
/// its corners, in pixels.
struct Written {
  std::uint32_t triangle;
  Point2 sum;
};

/// On a page each line is a colour, "r g b C", a triangle in it, "x y x y x y T", or a triangle
/// with a colour for each corner, "x y r g b x y r g b x y r g b ST".
std::vector<Written> written_in_postscript(const Gl2psSort& sort) {
  Page page(sort, GL2PS_EPS);
  page.end();
  std::string_view text = page.text();
  text.remove_prefix(std::min(text.find("%%Page:"), text.size()));
  std::vector<Written> all;
  std::uint32_t triangle = 0;
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
    end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    if (line.ends_with(" C\n")) {
      triangle = read_number(numbers_after<3>(line.data()));
    } else if (line.ends_with(" T\n")) {
      const auto n = numbers_after<6>(line.data());
      all.push_back({triangle, {n[0] + n[2] + n[4], n[1] + n[3] + n[5]}});
    } else if (line.ends_with(" ST\n")) {
      const auto n = numbers_after<15>(line.data());
      all.push_back({read_number({n[2], n[3], n[4]}), {n[0] + n[5] + n[10], n[1] + n[6] + n[11]}});
    }
  }
  return all;
}

}  // namespace

std::optional<std::string> Gl2psSort::version() {
  return fmt::format("{}.{}.{}", GL2PS_MAJOR_VERSION, GL2PS_MINOR_VERSION, GL2PS_PATCH_VERSION);
}

double Gl2psSort::sort() const {
  Page page(*this, GL2PS_TEX);
  return seconds_each(Clock::processor, 1, [&] { page.end(); });
}

bool Gl2psSort::ends() const {
  const pid_t child = fork();
  if (child < 0) throw Error("gl2ps: no process can be started to try it in");
  if (child == 0) {
    const double times = options.occlusion_cull ? 10.0 : 1.0;  // which takes many times as long
    const double limit = 1.0 + times * 3e-4 * static_cast<double>(corners.size()) / 3.0;
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(std::ceil(limit));
    setitimer(ITIMER_PROF, &timer, nullptr);  // its signal ends the process
    try {
      Page(*this, GL2PS_TEX).end();
    } catch (const Error&) {
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<Gl2psSort::Piece> Gl2psSort::pieces() const {
  if (corners.size() / 3 > std::size_t{kSteps} * kSteps * kSteps)
    throw Error("gl2ps: too many triangles");
  Page page(*this, GL2PS_PGF);
  page.end();
  constexpr std::string_view kColour = "\\color[rgb]", kMove = "\\pgfpathmoveto{\\pgfpoint",
                             kLine = "\\pgflineto{\\pgfpoint";
  std::vector<Piece> pieces;
  std::uint32_t triangle = 0;
  std::string_view text = page.text();
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
    end = std::min(text.find('\n'), text.size() - 1) + 1;
    if (text.starts_with(kColour)) {
      triangle = read_number(numbers_after<3>(text.data() + kColour.size()));
    }
    const bool moves = text.starts_with(kMove);
    if (!moves && !text.starts_with(kLine)) continue;
    if (moves) pieces.push_back({triangle, {}});
    const auto [x, y] = numbers_after<2>(text.data() + (moves ? kMove : kLine).size());
    pieces.back().corners.emplace_back(x / window.width, y / window.height);
  }
  if (options.occlusion_cull) leave_out_hidden(pieces);
  return pieces;
}

/// PGF includes hidden triangles in any case. PostScript has only the others, in the same order.
void Gl2psSort::leave_out_hidden(std::vector<Piece>& pieces) const {
  constexpr double kRounding =
      1e-5;  // more than the rounding to six digits, and to six after the point
  const std::vector<Written> written = written_in_postscript(*this);
  auto next = written.begin();
  std::erase_if(pieces, [&](const Piece& piece) {
    if (next == written.end()) return true;
    Point2 sum(0.0), sizes(1.0);
    for (const Point2& corner : piece.corners) {
      const Point2 p(corner.x * window.width, corner.y * window.height);
      sum += p;
      sizes += glm::abs(p);
    }
    const Point2 apart = glm::abs(sum - next->sum);
    const bool is_written = piece.triangle == next->triangle && apart.x < kRounding * sizes.x &&
                            apart.y < kRounding * sizes.y;
    if (is_written) ++next;
    return !is_written;
  });
  if (next != written.end()) throw Error("gl2ps: its two outputs have not the same pieces");
}

}  // namespace displayfile::bench
