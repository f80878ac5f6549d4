#include "interp/vector/path_data.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <tuple>
#include <vector>

namespace displayfile {

namespace {

/// The height, in units, of the rows in which loops are ordered: a few pixels.
constexpr std::int32_t kRowOfLoops = 1500;

std::size_t digits(std::int32_t value) {
  char text[12];
  return static_cast<std::size_t>(std::to_chars(text, text + sizeof text, value).ptr - text);
}

/// Writes commands and numbers with the fewest separators that readers need.
class PathWriter {
 public:
  explicit PathWriter(std::string& out) : out_(out) {}

  void move_to(const LatticePoint& p) {
    command('m');
    number(p.x - at_.x);
    number(p.y - at_.y);
    command_ = 'l';  // what follows a move without a command
    at_ = start_ = p;
  }
  void line_to(const LatticePoint& p) {
    const std::int32_t dx = p.x - at_.x, dy = p.y - at_.y;
    if (dx == 0 || dy == 0) {
      command(dx == 0 ? 'v' : 'h');
      number(dx == 0 ? dy : dx);
    } else {
      command('l');
      number(dx);
      number(dy);
    }
    at_ = p;
  }
  void close() {
    command('z');
    at_ = start_;
  }

 private:
  void command(char letter) {
    if (letter == command_) return;
    out_.push_back(letter);
    command_ = letter;
  }
  void number(std::int32_t value) {
    char text[12];
    const char* end = std::to_chars(text, text + sizeof text, value).ptr;
    if (value >= 0 && out_.back() >= '0' && out_.back() <= '9') out_.push_back(' ');
    out_.append(static_cast<const char*>(text), end);
  }

  std::string& out_;
  char command_ = '\0';
  LatticePoint at_{0, 0}, start_{0, 0};
};

/// The first vertex of a loop, so that its last side, which is not written, is the longest to
/// write.
std::size_t first_of(std::span<const LatticePoint> loop) {
  std::size_t first = 0, most = 0;
  LatticePoint from = loop.back();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t length = digits(loop[i].x - from.x) + digits(loop[i].y - from.y);
    if (length > most) {
      most = length;
      first = i;
    }
    from = loop[i];
  }
  return first;
}

/// Orders loops from left to right in one row and back in the next.
template <class FirstVertex>
std::vector<std::size_t> along_rows(std::size_t count, const FirstVertex& first_vertex) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::size_t k) {
    const LatticePoint p = first_vertex(k);
    const std::int32_t row = p.y / kRowOfLoops;
    return std::tuple(row, row % 2 == 0 ? p.x : -p.x, k);
  });
  return order;
}

}  // namespace

void append_loops(std::string& out, const LatticeLoops& loops) {
  PathWriter writer(out);
  for (const std::size_t k :
       along_rows(loops.size(), [&](std::size_t i) { return loops.loop(i)[0]; })) {
    const auto loop = loops.loop(k);
    const std::size_t first = first_of(loop);
    writer.move_to(loop[first]);
    for (std::size_t i = 1; i < loop.size(); ++i) writer.line_to(loop[(first + i) % loop.size()]);
    writer.close();
  }
}

void append_chains(std::string& out, const LatticeChains& chains) {
  PathWriter writer(out);
  for (const std::size_t k :
       along_rows(chains.size(), [&](std::size_t i) { return chains.chain(i)[0]; })) {
    const auto chain = chains.chain(k);
    writer.move_to(chain[0]);
    for (const LatticePoint& p : chain.subspan(1)) writer.line_to(p);
    if (chains.closed[k]) writer.close();
  }
}

}  // namespace displayfile
