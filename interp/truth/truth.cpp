#include "interp/truth/truth.h"

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "clip/error.h"
#include "clip/memory.h"

namespace displayfile {

namespace {

using Integer = mpz_class;

constexpr int kMantissaBits = 53;
constexpr double kBackgroundDepth = -std::numeric_limits<double>::infinity();

// ---- Doubles as whole numbers ------------------------------------------------------------

/// How many binary digits the double has after its point.
int binary_places(double value) {
  if (value == 0.0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, kMantissaBits));
  const int trailing_zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
  return std::max(0, kMantissaBits - exponent - trailing_zeros);
}

/// value 2^places, which must be whole.
Integer scaled(double value, int places) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Integer digits(std::ldexp(fraction, kMantissaBits));
  const int shift = exponent - kMantissaBits + places;
  if (shift >= 0) {
    digits <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    digits >>= static_cast<mp_bitcnt_t>(-shift);  // zeros
  }
  return digits;
}

/// Quotients of whole numbers, with memory of their own.
class Division {
 public:
  /// The least whole number that is not less than a / b, but from 0 to `most`; b > 0.
  int ceiling(const Integer& a, const Integer& b, int most) {
    mpz_cdiv_q(quotient_.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
    if (quotient_ <= 0) return 0;
    return quotient_ >= most ? most : static_cast<int>(quotient_.get_si());
  }

  /// The double nearest to a / b, of two equally near the even one; infinite beyond the largest
  /// double; b > 0. It grows with the quotient: where a / b < c / d, it is no greater for a / b.
  double nearest_double(const Integer& a, const Integer& b);

 private:
  Integer quotient_, rest_, shifted_;
};

double Division::nearest_double(const Integer& a, const Integer& b) {
  constexpr int kLeastPlaces = 1074;  // of the smallest double's digit
  const auto bits = [](const Integer& n) {
    return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2));
  };
  if (a == 0) return 0.0;
  // |a / b| 2^places has 62 or 63 binary digits before the point, or, if a double does not
  // reach as far, two digits more than it does.
  const int places = std::min(62 - bits(a) + bits(b), kLeastPlaces + 2);
  if (places >= 0) {
    mpz_mul_2exp(shifted_.get_mpz_t(), a.get_mpz_t(), static_cast<mp_bitcnt_t>(places));
    mpz_tdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), shifted_.get_mpz_t(), b.get_mpz_t());
  } else {
    mpz_mul_2exp(shifted_.get_mpz_t(), b.get_mpz_t(), static_cast<mp_bitcnt_t>(-places));
    mpz_tdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), a.get_mpz_t(), shifted_.get_mpz_t());
  }
  // The last digit says whether anything follows it.
  std::uint64_t digits = 0;
  mpz_export(&digits, nullptr, -1, sizeof digits, 0, 0, quotient_.get_mpz_t());
  if (rest_ != 0) digits |= 1;
  const int dropped =
      std::max(static_cast<int>(std::bit_width(digits)) - kMantissaBits, places - kLeastPlaces);
  const std::uint64_t cut = digits & ((std::uint64_t{1} << dropped) - 1);
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
  std::uint64_t kept = digits >> dropped;
  if (cut > half || (cut == half && kept % 2 == 1)) ++kept;
  const double magnitude = std::ldexp(static_cast<double>(kept), dropped - places);
  return a < 0 ? -magnitude : magnitude;
}

// ---- The support plane -------------------------------------------------------------------

using Support = std::array<Point3, 3>;

/// Which vertices the definition takes, computed in doubles as it says; nothing if edge-on.
std::optional<Support> support_of(std::span<const Point3> v) {
  const Point3& p = v[0];
  const auto distance = [&](const Point3& i) {
    return (i.x - p.x) * (i.x - p.x) + (i.y - p.y) * (i.y - p.y);
  };
  const auto beside_line = [&](const Point3& q, const Point3& i) {
    return std::abs((q.x - p.x) * (i.y - p.y) - (q.y - p.y) * (i.x - p.x));
  };
  std::size_t q = 0, r = 0;
  if (v.size() == 3) {
    q = 1;
    r = 2;
  } else {
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (distance(v[i]) > distance(v[q])) q = i;
    }
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (beside_line(v[q], v[i]) > beside_line(v[q], v[r])) r = i;
    }
  }
  if (beside_line(v[q], v[r]) == 0.0) return std::nullopt;
  return Support{p, v[q], v[r]};
}

/// The support plane's depth at the pixel centres: (origin + row up + column right) / divisor,
/// whole numbers, the divisor positive.
class ExactDepth {
 public:
  ExactDepth(const Support& support, int width, int height);

  /// The three are in line in the projection although the doubles did not show it.
  bool edge_on() const { return divisor_ == 0; }
  const Integer& divisor() const { return divisor_; }
  const Integer& right() const { return right_; }
  void numerator(int column, int row, Integer& to) const {
    to = origin_;
    mpz_addmul_ui(to.get_mpz_t(), right_.get_mpz_t(), static_cast<unsigned long>(column));
    mpz_addmul_ui(to.get_mpz_t(), up_.get_mpz_t(), static_cast<unsigned long>(row));
  }

 private:
  Integer origin_, right_, up_, divisor_;
};

ExactDepth::ExactDepth(const Support& support, int width, int height) {
  int places = 1, z_places = 0;  // one for the centres' halves
  for (const Point3& v : support) {
    places = std::max({places, binary_places(v.x), binary_places(v.y)});
    z_places = std::max(z_places, binary_places(v.z));
  }
  struct Whole {
    Integer x, y, z;
  };
  const auto whole = [&](const Point3& v) {
    return Whole{scaled(v.x, places) * width, scaled(v.y, places) * height, scaled(v.z, z_places)};
  };
  const Whole p = whole(support[0]), q = whole(support[1]), r = whole(support[2]);
  const Whole u = {q.x - p.x, q.y - p.y, q.z - p.z}, v = {r.x - p.x, r.y - p.y, r.z - p.z};
  Integer a = u.y * v.z - u.z * v.y, b = u.z * v.x - u.x * v.z, c = u.x * v.y - u.y * v.x;
  if (c < 0) {
    a = -a;
    b = -b;
    c = -c;
  }
  const Integer half = Integer(1) << static_cast<mp_bitcnt_t>(places - 1);
  origin_ = c * p.z - a * (half - p.x) - b * (half - p.y);
  right_ = -2 * half * a;
  up_ = -2 * half * b;
  divisor_ = c << static_cast<mp_bitcnt_t>(z_places);
}

// ---- Coverage -------------------------------------------------------------------------------

/// The pixels that a polygon covers: for each row, which columns begin after an odd number of
/// its edges.
class CentreMarks {
 public:
  CentreMarks(int width, int height)
      : width_(width),
        height_(height),
        changes_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        reached_(static_cast<std::size_t>(height), kNoColumns) {}

  /// Calls run(row, first, end) for each run of covered pixels first <= i < end.
  template <class Run>
  void for_each_run(std::span<const Point3> polygon, Run&& run) {
    mark(polygon);
    for (int row = first_row_; row < end_row_; ++row) read_row(row, run);
  }

 private:
  struct Columns {
    int first, last;  // of those marked; last may be the width
  };
  struct Vertex {
    Integer x, y;   // in pixels, times 2^places
    int row_above;  // the first row of centres above it
  };
  static constexpr Columns kNoColumns{std::numeric_limits<int>::max(), -1};

  void mark(std::span<const Point3> polygon);
  void mark_edge(const Vertex& low, const Vertex& high, int places);
  int row_above(const Integer& y, int places);

  std::uint8_t* changes(int row) {
    return changes_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  }

  template <class Run>
  void read_row(int row, Run&& run) {
    const auto [first, last] = std::exchange(reached_[static_cast<std::size_t>(row)], kNoColumns);
    if (first > last) return;
    std::uint8_t* change = changes(row);
    std::uint8_t* limit = change + std::min(last + 1, width_);
    const auto next_change = [&](std::uint8_t* from) {
      std::uint8_t* found = std::find(from, limit, std::uint8_t{1});
      if (found != limit) *found = 0;
      return found;
    };
    for (std::uint8_t* at = change + first;;) {
      std::uint8_t* begin = next_change(at);
      if (begin == limit) return;
      std::uint8_t* end = next_change(begin + 1);
      run(row, static_cast<int>(begin - change), static_cast<int>(end - change));
      if (end == limit) return;
      at = end + 1;
    }
  }

  int width_, height_;
  std::vector<std::uint8_t> changes_;  // 1 where a column begins after an odd number of edges
  std::vector<Columns> reached_;       // by row
  int first_row_ = 0, end_row_ = 0;
  std::vector<Vertex> vertices_;
  Integer numerator_, denominator_, step_;
  Division division_;
};

/// The least j, from 0 to the height, with j + 1/2 > y.
int CentreMarks::row_above(const Integer& y, int places) {
  const Integer one = Integer(1) << static_cast<mp_bitcnt_t>(places);
  return division_.ceiling(y - one / 2 + 1, one, height_);
}

void CentreMarks::mark(std::span<const Point3> polygon) {
  int places = 1;
  for (const Point3& v : polygon) {
    places = std::max({places, binary_places(v.x), binary_places(v.y)});
  }
  vertices_.resize(polygon.size());
  first_row_ = height_;
  end_row_ = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    Vertex& v = vertices_[k];
    v.x = scaled(polygon[k].x, places) * width_;
    v.y = scaled(polygon[k].y, places) * height_;
    v.row_above = row_above(v.y, places);
    first_row_ = std::min(first_row_, v.row_above);
    end_row_ = std::max(end_row_, v.row_above);
  }
  const Vertex* from = &vertices_.back();
  for (const Vertex& to : vertices_) {
    if (from->row_above < to.row_above) mark_edge(*from, to, places);
    if (to.row_above < from->row_above) mark_edge(to, *from, places);
    from = &to;
  }
}

/// In each row that the edge crosses, at height cy, the first column whose centre cx is at or
/// right of the crossing: (cx - low.x) rise >= (cy - low.y) run.
void CentreMarks::mark_edge(const Vertex& low, const Vertex& high, int places) {
  const auto one = static_cast<mp_bitcnt_t>(places);
  const Integer half = Integer(1) << (one - 1);
  const Integer rise = high.y - low.y, run = high.x - low.x;
  numerator_ = (low.x - half) * rise + ((2 * low.row_above + 1) * half - low.y) * run;
  denominator_ = rise << one;
  step_ = run << one;
  for (int row = low.row_above; row < high.row_above; ++row, numerator_ += step_) {
    const int column = division_.ceiling(numerator_, denominator_, width_);
    if (column < width_) changes(row)[column] ^= 1;
    auto& [first, last] = reached_[static_cast<std::size_t>(row)];
    first = std::min(first, column);
    last = std::max(last, column);
  }
}

// ---- What is seen ------------------------------------------------------------------------

class TruePicture {
 public:
  TruePicture(int width, int height)
      : width_(width),
        height_(height),
        coverage_(width, height),
        ids_(pixels(), -1),
        depth_(pixels(), kBackgroundDepth),
        owner_(pixels(), kNone) {}

  void enter(std::span<const Point3> polygon, std::int32_t pick);
  Picture take(bool depth);

  /// Coverage, identifier, depth and owner.
  static constexpr std::size_t kBytesOfPixel = 17;

 private:
  /// A polygon that is, or was, seen somewhere: its place in `seen_`.
  using Owner = std::uint32_t;
  static constexpr Owner kNone = std::numeric_limits<Owner>::max();

  struct Entered {
    const Support& support;
    const ExactDepth& depth;
    std::int32_t pick;
    Owner owner = kNone;  // until it is seen
  };

  std::size_t pixels() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  void enter_run(Entered& polygon, int row, int first, int end);
  bool nearer_or_equal(const ExactDepth& depth, Owner owner, int column, int row);
  const ExactDepth& depth_of(Owner owner);

  int width_, height_;
  CentreMarks coverage_;
  std::vector<std::int32_t> ids_;
  std::vector<double> depth_;  // rounded to the nearest double
  std::vector<Owner> owner_;
  std::vector<Support> seen_;

  Integer numerator_, other_numerator_, left_, right_;
  Division division_;
  Owner last_compared_ = kNone;
  std::optional<ExactDepth> depth_of_last_compared_;
};

void TruePicture::enter(std::span<const Point3> polygon, std::int32_t pick) {
  const std::optional<Support> support = support_of(polygon);
  if (!support) return;
  std::optional<ExactDepth> depth;  // not worked out for a polygon between the centres
  std::optional<Entered> entered;
  coverage_.for_each_run(polygon, [&](int row, int first, int end) {
    if (!depth) {
      depth.emplace(*support, width_, height_);
      entered.emplace(Entered{*support, *depth, pick});
    }
    if (!depth->edge_on()) enter_run(*entered, row, first, end);
  });
}

/// Rounding to the nearest double keeps order, so rounded depths that differ are in the order of
/// the exact ones; only where they are equal are the exact ones asked.
void TruePicture::enter_run(Entered& polygon, int row, int first, int end) {
  constexpr int kLongRun = 4;
  const Integer& divisor = polygon.depth.divisor();
  double bound = std::numeric_limits<double>::infinity();
  if (end - first > kLongRun) {  // a plane is nearest at one of the ends
    polygon.depth.numerator(end - 1, row, numerator_);
    bound = division_.nearest_double(numerator_, divisor);
    polygon.depth.numerator(first, row, numerator_);
    bound = std::max(bound, division_.nearest_double(numerator_, divisor));
  } else {
    polygon.depth.numerator(first, row, numerator_);
  }
  auto at = static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(first);
  for (int column = first; column < end; ++column, ++at, numerator_ += polygon.depth.right()) {
    if (depth_[at] > bound) continue;
    const double z = division_.nearest_double(numerator_, divisor);
    const bool is_seen =
        owner_[at] == kNone || z > depth_[at] ||
        (z == depth_[at] && nearer_or_equal(polygon.depth, owner_[at], column, row));
    if (!is_seen) continue;
    if (polygon.owner == kNone) {
      polygon.owner = static_cast<Owner>(seen_.size());
      seen_.push_back(polygon.support);
    }
    owner_[at] = polygon.owner;
    depth_[at] = z;
    ids_[at] = polygon.pick;
  }
}

/// The depth, whose numerator at the centre is numerator_, against that of the polygon seen.
bool TruePicture::nearer_or_equal(const ExactDepth& depth, Owner owner, int column, int row) {
  const ExactDepth& other = depth_of(owner);
  other.numerator(column, row, other_numerator_);
  left_ = numerator_ * other.divisor();
  right_ = other_numerator_ * depth.divisor();
  return left_ >= right_;
}

const ExactDepth& TruePicture::depth_of(Owner owner) {
  if (last_compared_ != owner) {
    last_compared_ = owner;
    depth_of_last_compared_.emplace(seen_[owner], width_, height_);
  }
  return *depth_of_last_compared_;
}

Picture TruePicture::take(bool depth) {
  Picture picture;
  picture.width = width_;
  picture.height = height_;
  picture.ids = std::move(ids_);
  if (depth) picture.depth = std::move(depth_);
  return picture;
}

/// Hands a segment's solid polygons to the picture.
struct SegmentWalk {
  TruePicture& picture;
  int segment;
  const TruthProgress& progress;
  std::size_t& done;
  std::size_t polygons;
  bool solid = true;
  std::int32_t pick_id = -1;

  void fill(const FillStyle& style) { solid = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle&) {}
  void pick(std::int32_t id) { pick_id = id; }
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    if (solid) {
      require_finite(vertices);
      picture.enter(vertices, pick_id);
    }
    ++done;
    if (progress) progress(done, polygons);
  }

  void require_finite(std::span<const Point3> vertices) const {
    for (const Point3& v : vertices) {
      if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) continue;
      throw Error(
          fmt::format("segment {}: a polygon with a vertex {} {} {}: expected finite numbers",
                      segment, v.x, v.y, v.z));
    }
  }
};

}  // namespace

Picture truth(const DisplayFile& display_file, int width, int height, bool depth,
              const TruthProgress& progress) {
  require_picture_size(width, height);
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return with_memory(
      TruePicture::kBytesOfPixel * pixels,
      [&] { return fmt::format("the truth of {} x {} pixels", width, height); },
      [&] {
        TruePicture picture(width, height);
        std::size_t done = 0, polygons = 0;
        for (const Segment& segment : display_file.segments()) {
          if (segment.visible) polygons += segment.polygons();
        }
        for (const Segment& segment : display_file.segments()) {
          if (!segment.visible) continue;
          segment.walk_entered_drawn(
              SegmentWalk{picture, segment.name(), progress, done, polygons});
        }
        return picture.take(depth);
      });
}

}  // namespace displayfile
