// Along a line of any degree the nearest point is the foot of the perpendicular, or an end. Else
// |(x, y) − w·at|² − r² is a polynomial of s over ℚ for a rational point. Its sign on [0, 1] is
// that of its Bernstein coefficients on short parts; where it has a zero without a change of sign,
// as at the disc that the boundary belongs to, if that is not taken out, its roots and their orders
// decide.
#include "phrame/ph/offset/disc_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "phrame/algebra/ball_order.hpp"
#include "phrame/algebra/ball_polynomial.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/offset/plane_tangent.hpp"

namespace phrame::inline v0 {
namespace {

/// Powers of t cancel by up to 3ⁿ there.
std::vector<RealBall> bernstein_balls(const Polynomial& p, long n, long bits) {
  const long working = bits + 2 * n;
  return to_bernstein(BallPolynomial(p, working), n, working);
}

/// Where a polynomial is negative.
struct NegativePlace {
  std::optional<Rational> at;  ///< on [0, 1], where one was found
  bool is_decided = true;      ///< else, is there none?
};

/// Of one with these Bernstein coefficients on [lower, upper].
NegativePlace negative_place(const std::vector<RealBall>& coefficients, const Rational& lower,
                             const Rational& upper, int depth) {
  constexpr long bits = 128;
  if (sign(coefficients.front()) < 0) return {lower};
  if (sign(coefficients.back()) < 0) return {upper};
  if (std::ranges::all_of(coefficients, [](const RealBall& c) { return sign(c) > 0; })) return {};
  if (depth == 0) return {std::nullopt, false};
  const auto [left, right] = split(coefficients, Rational(1, 2), bits);
  const Rational middle = (lower + upper) / 2;
  const NegativePlace one = negative_place(left, lower, middle, depth - 1);
  if (one.at) return one;
  const NegativePlace other = negative_place(right, middle, upper, depth - 1);
  return {other.at, one.is_decided && other.is_decided};
}

/// Where p < 0 between its roots in (0, 1), if anywhere.
std::optional<Rational> negative_between(const std::vector<RealRoot>& roots, const Polynomial& p) {
  if (std::ranges::none_of(roots, [](const RealRoot& root) { return root.order % 2 != 0; }))
    return std::nullopt;
  for (long bits = 64;; bits *= 2) {
    std::vector<std::array<Rational, 2>> places{{0, 0}};
    for (const RealRoot& root : roots) {
      const RealBall at = enclose(root.at, bits);
      places.push_back({at.lower(), at.upper()});
    }
    places.push_back({1, 1});
    bool are_apart = true;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      are_apart = are_apart && places[k][1] < places[k + 1][0];
      const Rational middle = (places[k][1] + places[k + 1][0]) / 2;
      if (middle > 0 && middle < 1 && p(middle) < 0) return middle;
    }
    if (are_apart) return std::nullopt;
  }
}

double size_of(const PlaneBox& box) {
  double size = 0;
  for (const DoubleInterval& x : box) size = std::max({size, std::abs(x.lower), std::abs(x.upper)});
  return size;
}

/// A little more than [x, x].
DoubleInterval around(const Rational& x) {
  const auto near = static_cast<double>(x);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(near, -infinity), std::nextafter(near, infinity)};
}

/// Of the points of two boxes, in one coordinate.
double gap(const DoubleInterval& a, const DoubleInterval& b) {
  return std::max({a.lower - b.upper, b.lower - a.upper, 0.0});
}

bool is_beyond(const PlaneBox& a, const PlaneBox& b, double reach) {
  return gap(a[0], b[0]) > reach || gap(a[1], b[1]) > reach;
}

/// All values of a polynomial with these Bernstein coefficients.
DoubleInterval range_of(const std::vector<RealBall>& bernstein) {
  DoubleInterval range{std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity()};
  for (const RealBall& c : bernstein) {
    const DoubleInterval here = doubles_around(c);
    range.lower = std::min(range.lower, here.lower);
    range.upper = std::max(range.upper, here.upper);
  }
  return range;
}

/// All values of p/w on [0, 1], w > 0: between those of the quotients of the coefficients, as they
/// are means of these. Parts are halved until the coefficients of w are positive.
DoubleInterval range_of(const std::vector<RealBall>& p, const std::vector<RealBall>& w) {
  constexpr long bits = 64;
  std::vector<RealBall> quotients;
  for (std::size_t k = 0; k < w.size(); ++k) {
    if (sign(w[k]) <= 0) {
      const auto [p1, p2] = split(p, Rational(1, 2), 2 * bits);
      const auto [w1, w2] = split(w, Rational(1, 2), 2 * bits);
      const DoubleInterval a = range_of(p1, w1);
      const DoubleInterval b = range_of(p2, w2);
      return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
    }
    quotients.push_back(divide(p[k], w[k], bits));
  }
  return range_of(quotients);
}

DoubleInterval range_of(const Polynomial& p, const Polynomial& w) {
  constexpr long bits = 64;
  const long n = std::max({p.degree(), w.degree(), 0L});
  if (w == Polynomial{1}) return range_of(bernstein_balls(p, n, bits));
  return range_of(bernstein_balls(p, n, 4 * bits), bernstein_balls(w, n, 4 * bits));
}

/// As many points as are next to each other by a quarter of |d|, within bounds.
long count_of(const PlaneBox& box, double reach) {
  const double size = std::hypot(box[0].upper - box[0].lower, box[1].upper - box[1].lower);
  constexpr double least = 8;
  constexpr double most = 128;
  return static_cast<long>(std::clamp(4 * size / reach, least, most));
}

std::vector<DiscTrack> tracks_of(const PhPath& path, const Rational& d) {
  std::vector<DiscTrack> tracks;
  for (const Curve& curve : path.segments()) {
    const Vector<Polynomial> X = numerator(curve);
    tracks.push_back({X[0], X[1], abs(d) * curve.weight(), curve.weight()});
  }
  return tracks;
}

std::optional<DiscLine> line_of(const Curve& curve) {
  if (!plane_tangent(curve).turn.is_zero() || constant_sign(curve.multiplier()) == 0)
    return std::nullopt;
  return DiscLine{curve.start(), end_point(curve) - curve.start()};
}

/// Where the disc on a line is around the point, if anywhere: by the foot of the perpendicular, or
/// the end that is nearest, whatever the degree is.
std::optional<Rational> place_on_line(const DiscTrack& track, const DiscLine& line,
                                      const Vector<Rational>& at) {
  const auto is_inside = [&at](const Disc& disc) {
    const Vector<Rational> gap{disc.center[0] - at[0], disc.center[1] - at[1], 0};
    return dot(gap, gap) < disc.radius * disc.radius;
  };
  const auto share = [&](const Vector<Rational>& to) -> Rational {
    return (line.way[0] * (to[0] - line.start[0]) + line.way[1] * (to[1] - line.start[1])) /
           dot(line.way, line.way);
  };
  const Rational foot = share(at);
  const Rational nearest = std::clamp(foot, Rational(0), Rational(1));
  Disc disc = track.at(nearest);
  disc.center = line.start + nearest * line.way;
  if (!is_inside(disc)) return std::nullopt;
  if (nearest != foot) return nearest;
  Rational lower = 0;
  Rational upper = 1;
  for (;;) {
    const Rational t = (lower + upper) / 2;
    disc = track.at(t);
    if (is_inside(disc)) return t;
    (share(disc.center) < foot ? lower : upper) = t;
  }
}

}  // namespace

std::optional<Rational> negative_place(const Polynomial& p) {
  if (p.is_zero()) return std::nullopt;
  constexpr long bits = 128;
  constexpr int depth = 10;
  const NegativePlace seen = negative_place(bernstein_balls(p, p.degree(), bits), 0, 1, depth);
  if (seen.at || seen.is_decided) return seen.at;
  return negative_between(real_roots(p, open_interval(0, 1)), p);
}

Disc DiscTrack::at(const Rational& t) const {
  const Rational w = weight(t);
  return {{x(t) / w, y(t) / w, 0}, radius(t) / w};
}

DiscCover::DiscCover(const PhPath& path, const Rational& d) : DiscCover(tracks_of(path, d)) {
  for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k].line = line_of(path.segments()[k]);
}

DiscCover::DiscCover(const std::vector<DiscTrack>& tracks) {
  double size = 0;
  for (const DiscTrack& track : tracks) {
    Part part{track, {}, {range_of(track.x, track.weight), range_of(track.y, track.weight)}};
    const DoubleInterval radii = range_of(track.radius, track.weight);
    const double most = std::max(radii.upper, -radii.lower);
    reach_ = std::max(reach_, most * (1 + 1e-12));
    const long count = count_of(part.box, most);
    for (long k = 0; k <= count; ++k) {
      const auto [center, radius] = track.at(Rational(k, count));
      part.discs.push_back({static_cast<double>(center[0]), static_cast<double>(center[1]),
                            static_cast<double>(Rational(radius * radius))});
    }
    size = std::max(size, size_of(part.box));
    parts_.push_back(std::move(part));
  }
  boxes_.resize(4 * parts_.size());
  add_boxes(1, 0, parts_.size());
  // A point and a corner of a box are off by 2⁻⁵⁰ of their sizes.
  const double error = 0x1p-46 * (size + reach_) * (size + reach_);
  for (Part& part : parts_)
    for (auto& [x, y, squared] : part.discs) squared = squared * (1 - 1e-9) - error;
}

void DiscCover::add_boxes(std::size_t node, std::size_t first, std::size_t last) {
  if (last - first == 1) {
    boxes_[node] = parts_[first].box;
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  add_boxes(2 * node, first, middle);
  add_boxes(2 * node + 1, middle, last);
  boxes_[node] = hull_of(boxes_[2 * node], boxes_[2 * node + 1]);
}

/// Is any of the parts wanted that are within reach of the box, as far as their boxes tell?
bool DiscCover::any_within(const PlaneBox& box, double reach,
                           const std::function<bool(std::size_t part)>& is_wanted) const {
  const auto visit = [&](const auto& self, std::size_t node, std::size_t first,
                         std::size_t last) -> bool {
    if (is_beyond(boxes_[node], box, reach)) return false;
    if (last - first == 1) return is_wanted(first);
    const std::size_t middle = first + (last - first) / 2;
    return self(self, 2 * node, first, middle) || self(self, 2 * node + 1, middle, last);
  };
  return visit(visit, 1, 0, parts_.size());
}

std::optional<std::size_t> DiscCover::covering(const Part& part, const PlaneBox& box) {
  const double error = 0x1p-46 * size_of(box) * size_of(box);
  const auto farthest = [](const DoubleInterval& x, double at) {
    return std::max(std::abs(x.lower - at), std::abs(x.upper - at));
  };
  const auto found = std::ranges::find_if(part.discs, [&](const std::array<double, 3>& disc) {
    const double dx = farthest(box[0], disc[0]);
    const double dy = farthest(box[1], disc[1]);
    return dx * dx + dy * dy < disc[2] - error;
  });
  if (found == part.discs.end()) return std::nullopt;
  return static_cast<std::size_t>(found - part.discs.begin());
}

bool DiscCover::covers(const PlaneBox& box) const {
  return any_within(box, reach_,
                    [&](std::size_t k) { return covering(parts_[k], box).has_value(); });
}

bool DiscCover::any_near(const Vector<Rational>& at,
                         const std::function<bool(std::size_t track)>& is_wanted) const {
  const PlaneBox box{around(at[0]), around(at[1])};
  return any_within(box, reach_ * (1 + 1e-12) + 0x1p-40 * size_of(box), is_wanted);
}

std::optional<Disc> DiscCover::disc_around(const Vector<Rational>& at, std::size_t track,
                                           const Polynomial& known) const {
  std::optional<Disc> found;
  const auto take = [&](const DiscTrack& of, const std::optional<Rational>& t) {
    if (!t) return false;
    found = of.at(*t);
    found->center[2] = at[2];
    return true;
  };
  const PlaneBox here{around(at[0]), around(at[1])};
  const auto sees = [&](std::size_t k) {
    const auto number = covering(parts_[k], here);
    const auto last = static_cast<long>(parts_[k].discs.size()) - 1;
    return number && take(parts_[k].track, Rational(static_cast<long>(*number), last));
  };
  if (any_near(at, sees)) return found;
  any_near(at, [&](std::size_t k) {
    const auto& [disc, discs, box, line] = parts_[k];
    if (line) return take(disc, place_on_line(disc, *line, at));
    const Polynomial x = disc.x - at[0] * disc.weight;
    const Polynomial y = disc.y - at[1] * disc.weight;
    Polynomial gap = x * x + y * y - disc.radius * disc.radius;
    if (k == track) gap = exact_quotient(gap, known);
    return take(disc, negative_place(gap));
  });
  return found;
}

std::optional<Disc> DiscCover::disc_around(const Vector<Rational>& at) const {
  return disc_around(at, parts_.size(), Polynomial{1});
}

Polynomial double_zero(const Rational& t) { return Polynomial{t * t, -2 * t, 1}; }

}  // namespace phrame
