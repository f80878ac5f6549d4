#include "tests/bench/seams/true_coverage.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "clip/error.h"

namespace displayfile::bench {

namespace {

constexpr int kSamples = 16;
constexpr std::uint32_t kNothing = 0xffffffff;

/// Up to two colours, and whether there are more.
struct FewColours {
  std::array<std::uint32_t, 2> some{kNothing, kNothing};
  bool more = false;

  void add(std::uint32_t colour) {
    if (colour == kNothing || colour == some[0] || colour == some[1]) return;
    if (some[0] == kNothing) {
      some[0] = colour;
    } else if (some[1] == kNothing) {
      some[1] = colour;
    } else {
      more = true;
    }
  }
  void add(const FewColours& other) {
    add(other.some[0]);
    add(other.some[1]);
    more = more || other.more;
  }
  std::uint8_t count() const {
    return static_cast<std::uint8_t>((some[0] != kNothing ? 1 : 0) + (some[1] != kNothing ? 1 : 0) +
                                     (more ? 1 : 0));
  }
};

struct SampledTile {
  std::vector<Point2> loop;  // in samples
  int first_row, end_row;
  std::uint32_t colour;
};

int first_centre_at_or_after(double v) { return static_cast<int>(std::ceil(v - 0.5)); }

std::vector<SampledTile> sampled_tiles(const Tiling& tiling, double scale, double precision,
                                       int samples) {
  std::vector<SampledTile> tiles;
  for (const auto& tile : tiling.tiles) {
    SampledTile sampled{{}, samples, 0, pixel_of(tile.colour)};
    double low = samples, high = 0.0;
    for (const Point3& v : tile.vertices) {
      const Point2 pixel = pixel_at(v, tiling.side, tiling.side);
      const auto rounded = [&](double c) {
        return std::round(c / precision) * precision * scale * kSamples;
      };
      sampled.loop.emplace_back(rounded(pixel.x), rounded(pixel.y));
      low = std::min(low, sampled.loop.back().y);
      high = std::max(high, sampled.loop.back().y);
    }
    sampled.first_row = std::max(0, first_centre_at_or_after(low));
    sampled.end_row = std::min(samples, first_centre_at_or_after(high));
    if (sampled.first_row < sampled.end_row) tiles.push_back(std::move(sampled));
  }
  std::ranges::sort(tiles, {}, &SampledTile::first_row);
  return tiles;
}

/// The tile's samples in a row.
void cover_row(const SampledTile& tile, int row, std::vector<double>& crossings,
               std::vector<std::uint32_t>& of_row) {
  crossings.clear();
  const double y = row + 0.5;
  Point2 from = tile.loop.back();
  for (const Point2& to : tile.loop) {
    if ((from.y <= y) != (to.y <= y)) {
      crossings.push_back(from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x));
    }
    from = to;
  }
  std::ranges::sort(crossings);
  const int samples = static_cast<int>(of_row.size());
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const int first = std::clamp(first_centre_at_or_after(crossings[k]), 0, samples);
    const int end = std::clamp(first_centre_at_or_after(crossings[k + 1]), first, samples);
    std::fill(of_row.begin() + first, of_row.begin() + end, tile.colour);
  }
}

/// What is in a square around each, one direction after the other.
void reach_out(std::vector<FewColours>& colours, int side, int reach) {
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(x);
  };
  for (const bool along_x : {true, false}) {
    const std::vector<FewColours> before = colours;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const int middle = along_x ? x : y;
        FewColours& all = colours[at(x, y)];
        for (int k = std::max(0, middle - reach); k <= std::min(side - 1, middle + reach); ++k) {
          if (all.more) break;
          all.add(before[along_x ? at(k, y) : at(x, k)]);
        }
      }
    }
  }
}

}  // namespace

TrueCoverage true_coverage(const Tiling& tiling, double scale, double precision, double reach) {
  TrueCoverage truth{static_cast<int>(std::lround(tiling.side * scale)), {}};
  const auto side = static_cast<std::size_t>(truth.side);
  const int samples = truth.side * kSamples;
  truth.pixels.resize(side * side);
  std::vector<FewColours> colours(side * side);
  const std::vector<SampledTile> tiles = sampled_tiles(tiling, scale, precision, samples);
  std::vector<const SampledTile*> active;
  std::vector<std::uint32_t> of_row(static_cast<std::size_t>(samples));
  std::vector<double> crossings;
  auto next = tiles.begin();
  for (int row = 0; row < samples; ++row) {
    while (next != tiles.end() && next->first_row <= row) active.push_back(&*next++);
    std::erase_if(active, [&](const SampledTile* tile) { return tile->end_row <= row; });
    std::ranges::fill(of_row, kNothing);
    for (const SampledTile* tile : active) cover_row(*tile, row, crossings, of_row);
    for (std::size_t x = 0; x < side; ++x) {
      const std::size_t at = static_cast<std::size_t>(row / kSamples) * side + x;
      auto& pixel = truth.pixels[at];
      for (const std::uint32_t seen : std::span(of_row).subspan(x * kSamples, kSamples)) {
        for (unsigned k = 0; k < 3; ++k) {
          pixel.colour[k] += static_cast<float>((seen >> (8 * k)) & 255);  // white where it is none
        }
        if (seen != kNothing) pixel.covered += 1.0f;
        colours[at].add(seen);
      }
    }
  }
  constexpr float kAll = kSamples * kSamples;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    auto& pixel = truth.pixels[i];
    for (float& channel : pixel.colour) channel /= kAll;
    pixel.covered /= kAll;
    pixel.colours = colours[i].count();
  }
  for (int y = 1; y + 1 < truth.side; ++y) {
    for (int x = 1; x + 1 < truth.side; ++x) {
      const auto covered = [&](int dx, int dy) {
        return truth
                   .pixels[static_cast<std::size_t>(y + dy) * side +
                           static_cast<std::size_t>(x + dx)]
                   .covered == 1.0f;
      };
      bool deep = true;
      for (int d = 0; d < 9; ++d) deep = deep && covered(d % 3 - 1, d / 3 - 1);
      truth.pixels[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)].deep = deep;
    }
  }
  reach_out(colours, truth.side, 1);
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    truth.pixels[i].near = colours[i].count();
    truth.pixels[i].mixed = colours[i].some;
  }
  reach_out(colours, truth.side, static_cast<int>(std::ceil(reach * scale)));
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    truth.pixels[i].in_reach = colours[i].count();
  }
  return truth;
}

namespace {

double channel(std::uint32_t pixel, unsigned k) {
  return static_cast<double>((pixel >> (8 * k)) & 255);
}

/// The largest difference of a channel from the nearest mix of two colours, as pixels hold it:
/// rounded.
double off_the_mix(std::uint32_t seen, std::uint32_t a, std::uint32_t b) {
  double along = 0.0, length = 0.0;
  for (unsigned k = 0; k < 3; ++k) {
    along += (channel(seen, k) - channel(a, k)) * (channel(b, k) - channel(a, k));
    length += (channel(b, k) - channel(a, k)) * (channel(b, k) - channel(a, k));
  }
  constexpr int kAround = 16;  // mixes that are tried on either side of the nearest
  constexpr double kStep = 1.0 / 2048;
  double least = 255.0;
  for (int i = -kAround; i <= kAround; ++i) {
    const double t = length == 0.0 ? 0.0 : std::clamp(along / length + i * kStep, 0.0, 1.0);
    double off = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
      const double mix = std::floor(std::lerp(channel(a, k), channel(b, k), t) + 0.5);
      off = std::max(off, std::abs(channel(seen, k) - mix));
    }
    least = std::min(least, off);
  }
  return least;
}

class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  double value() const { return count_ == 0 ? 0.0 : sum_ / count_; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

}  // namespace

Picture as_one_path(const TrueCoverage& truth, const Picture& black) {
  Picture picture = black;
  const auto side = static_cast<std::size_t>(truth.side);
  for (std::size_t i = 0; i < side * side; ++i) {
    std::uint32_t& pixel =
        picture.pixels[i / side * static_cast<std::size_t>(picture.width) + i % side];
    const auto& wanted = truth.pixels[i];
    const double covered = 1.0 - channel(pixel, 0) / 255.0;
    const auto own = static_cast<double>(wanted.covered);
    pixel = 0xff000000;
    for (unsigned k = 0; k < 3; ++k) {
      const auto mixed = static_cast<double>(wanted.colour[k]);
      const double inside = own == 0.0 ? 0.0 : (mixed - 255.0 * (1.0 - own)) / own;
      const double seen = covered * inside + (1.0 - covered) * 255.0;
      pixel |= static_cast<std::uint32_t>(std::lround(std::clamp(seen, 0.0, 255.0))) << (8 * k);
    }
  }
  return picture;
}

SeamError seam_error(const TrueCoverage& truth, const Picture& picture) {
  if (picture.width < truth.side || picture.height < truth.side) {
    throw Error("a picture that is too small");
  }
  SeamError error;
  Mean two, more, outline, outline_meeting;
  const auto side = static_cast<std::size_t>(truth.side);
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto& wanted = truth.pixels[i];
    const std::uint32_t seen =
        picture.pixels[i / side * static_cast<std::size_t>(picture.width) + i % side];
    double off = 0.0;
    for (unsigned k = 0; k < 3; ++k) {
      off = std::max(off, std::abs(channel(seen, k) - static_cast<double>(wanted.colour[k])));
    }
    if (wanted.covered == 0.0f) {
      error.outside = std::max(error.outside, off);
      continue;
    }
    if (wanted.covered < 1.0f) {
      (wanted.colours == 1 ? outline : outline_meeting).add(off);
      continue;
    }
    if (wanted.colours > 1) (wanted.colours == 2 ? two : more).add(off);
    if (wanted.near > 2 || !wanted.deep) continue;
    const double leak = off_the_mix(seen, wanted.mixed[0], wanted.mixed[wanted.near == 2 ? 1 : 0]);
    double& largest = wanted.in_reach > 2 ? error.near_others
                      : wanted.near == 2  ? error.two
                                          : error.one;
    largest = std::max(largest, leak);
  }
  error.mean_two = two.value();
  error.mean_more = more.value();
  error.outline = outline.value();
  error.outline_meeting = outline_meeting.value();
  return error;
}

}  // namespace displayfile::bench
