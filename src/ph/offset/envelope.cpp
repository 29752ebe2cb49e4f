// As complex numbers 2(x + iy) = (a − ib)(c + id) and 2(r + is) = (a + ib)(c + id), so that the
// unit vectors n with n·(x, y) = −r, −(r ± is)/(x − iy), are −(c + id)²/(c² + d²) and −(a −
// ib)²/(a² + b²), in lowest terms. The points center + radius·n are on the discs, and (center′ +
// radius′·n + radius·n′)·n = f·(n·(x, y) + r) = 0, so that the tangent is that of the disc. With τ,
// n turned to the left, it is (f·s + radius·n′·τ)·τ to the right: of the gap |center(s) − Q|² −
// radius(s)² at the point Q of t, the second derivative at t is 2f·s times that factor, so that Q
// is in no disc near t only if the sign of the factor is that of s: the boundary goes along τ, with
// the domain on its left, and along the piece where s > 0.
//
// On a last disc the points with n·(x, y) ≥ −r, the cap, are inside of no disc next to it, and all
// others are. So on a disc at which several segments end all of the boundary is on the cap of each,
// and one is enough.
#include "phrame/ph/offset/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/axis_end.hpp"
#include "phrame/ph/offset/offset_join.hpp"
#include "phrame/ph/offset/offset_meeting.hpp"

namespace phrame::inline v0 {
namespace {

/// n as a fraction.
struct NormalFraction {
  Polynomial x;
  Polynomial y;
  Polynomial weight;
};

NormalFraction normal_of(const MinkowskiCurve& curve, Side side) {
  const auto abcd = null_factors(curve);
  const Polynomial& c = abcd[side == Side::right ? 2 : 0];
  const Polynomial d = side == Side::right ? abcd[3] : -abcd[1];
  return {d * d - c * c, Rational(-2) * c * d, c * c + d * d};
}

Vector<Rational> in_plane(const Vector<Rational>& disc) { return {disc[0], disc[1], 0}; }

void require_radii(const MedialAxis& axis) {
  for (std::size_t k = 0; k < axis.size(); ++k) {
    const Polynomial radius = position(axis[k])[2];
    const auto fail = [&](const std::string& what) {
      throw DomainError(fmt::format("envelope: the radius is {} in segment {}", what, k + 1));
    };
    if (radius.is_zero()) fail("0 everywhere");
    for (const long end : {0L, 1L})
      if (radius(end) < 0)
        fail(fmt::format("{} at t = {}", abbreviated(to_string(radius(end))), end));
    const auto roots = odd(real_roots(radius, open_interval(0, 1)));
    if (!roots.empty()) fail("negative next to " + place_text("t", roots.front().at));
  }
}

class EnvelopeMaker {
 public:
  explicit EnvelopeMaker(MedialAxis axis) : made_{std::move(axis), {}, {}} {
    for (const MinkowskiCurve& curve : made_.axis) {
      starts_.push_back(end_of(curve, 0));
      ends_.push_back(end_of(curve, 1));
    }
  }

  Envelope make() {
    const std::size_t count = made_.axis.size();
    const auto goes_on = [&](std::size_t k) { return ends_[k] == starts_[(k + 1) % count]; };
    std::size_t first = 0;
    while (first < count && goes_on((first + count - 1) % count)) ++first;
    if (first == count) {
      add_sides(0, count - 1);
      return std::move(made_);
    }
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t from = first + j;
      while (goes_on((first + j) % count)) ++j;
      add_group(from, first + j);
    }
    return std::move(made_);
  }

 private:
  std::size_t segment(std::size_t k) const { return k % made_.axis.size(); }

  /// What is closed.
  void add_sides(std::size_t from, std::size_t to) {
    for (std::size_t k = from; k <= to; ++k) add_side(segment(k), Side::right);
    close_loop();
    for (std::size_t k = to + 1; k-- > from;) add_side(segment(k), Side::left);
    close_loop();
  }

  void add_group(std::size_t from, std::size_t to) {
    using Kind = EnvelopePiece::Kind;
    for (std::size_t k = from; k <= to; ++k) add_side(segment(k), Side::right);
    const AxisEnd& end = ends_[segment(to)];
    if (end.grows >= 0) add_cap(end.disc, end.right, end.left, segment(to), Kind::end_cap);
    for (std::size_t k = to + 1; k-- > from;) add_side(segment(k), Side::left);
    const AxisEnd& start = starts_[segment(from)];
    if (start.grows <= 0)
      add_cap(start.disc, start.left, start.right, segment(from), Kind::start_cap);
    close_loop();
  }

  void add_side(std::size_t segment, Side side) {
    auto curve = envelope_side(made_.axis[segment], side);
    if (!curve) return;
    if (side == Side::left) {
      const Polynomial back{1, -1};
      Vector<Polynomial> numerator = curve->numerator();
      for (Polynomial& x : numerator) x = compose(x, back);
      const bool is_along = sign_before_one(curve->multiplier()) < 0;
      *curve = RationalCurve(numerator, compose(curve->weight(), back));
      if (!is_along) *curve = curve->turned_over();
    }
    made_.pieces.push_back(
        {std::move(*curve), segment,
         side == Side::right ? EnvelopePiece::Kind::right : EnvelopePiece::Kind::left});
  }

  void add_cap(const Vector<Rational>& disc, const PlaneDirection& from, const PlaneDirection& to,
               std::size_t segment, EnvelopePiece::Kind kind) {
    if (disc[2] == 0 || std::ranges::find(capped_, disc) != capped_.end()) return;
    capped_.push_back(disc);
    for (RationalCurve& arc : circle_arcs(in_plane(disc), from, to, disc[2]))
      made_.pieces.push_back({std::move(arc), segment, kind});
  }

  /// Of the pieces since the last loop.
  void close_loop() {
    const std::size_t first = made_.behind.size();
    const std::size_t end = made_.pieces.size();
    for (std::size_t k = first; k < end; ++k) {
      const std::size_t next = k + 1 < end ? k + 1 : first;
      const bool meets = point(made_.pieces[k].curve, 1) == point(made_.pieces[next].curve, 0);
      made_.behind.push_back(meets ? next : no_segment);
    }
  }

  Envelope made_;
  std::vector<AxisEnd> starts_;
  std::vector<AxisEnd> ends_;
  std::vector<Vector<Rational>> capped_;
};

}  // namespace

PlaneDirection envelope_normal(const MinkowskiCurve& curve, Side side, const Rational& t) {
  const auto [x, y, weight] = normal_of(curve, side);
  const Rational size = weight(t);
  return {x(t) / size, y(t) / size};
}

std::optional<RationalCurve> envelope_side(const MinkowskiCurve& curve, Side side) {
  const auto [x, y, weight] = normal_of(curve, side);
  const Vector<Polynomial> r = position(curve);
  const Vector<Polynomial> points{r[0] * weight + r[2] * x, r[1] * weight + r[2] * y, {}};
  const Rational size = weight(0);
  const Vector<Rational> first{points[0](0) / size, points[1](0) / size, 0};
  if (points == Vector<Polynomial>{first[0] * weight, first[1] * weight, {}}) return std::nullopt;
  RationalCurve found(points, weight);
  const Vector<Rational> h = evaluate(found.direction(), 0);
  return h[1] * x(0) - h[0] * y(0) > 0 ? found : found.turned_over();
}

Rational greatest_radius(const MedialAxis& axis) {
  Rational most;
  for (const MinkowskiCurve& curve : axis) {
    const Polynomial radius = position(curve)[2];
    for (const Rational& r : to_bernstein(radius, radius.degree())) most = std::max(most, r);
  }
  return most;
}

AxisEnd end_of(const MinkowskiCurve& curve, const Rational& t) {
  AxisEnd end{evaluate(position(curve), t), envelope_normal(curve, Side::right, t),
              envelope_normal(curve, Side::left, t), 0};
  const Polynomial s = spacelike_root(curve);
  if (t == 1 && sign_before_one(s) < 0) std::swap(end.right, end.left);
  if (end.right == end.left) end.grows = Rational(direction(curve)[2](t)).sign();
  return end;
}

Envelope envelope(MedialAxis axis) {
  if (axis.empty()) throw DomainError("envelope: the axis has no segment");
  require_radii(axis);
  return EnvelopeMaker(std::move(axis)).make();
}

std::vector<Path> paths(const Envelope& envelope) { return joined_paths(branches_of(envelope)); }

}  // namespace phrame
