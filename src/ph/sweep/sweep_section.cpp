#include "phrame/ph/sweep/sweep_section.hpp"

#include <algorithm>
#include <cmath>

#include "phrame/algebra/nearest_float.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

constexpr long section_bits = 128;

/// A double in the ball, and a bound of how far a number of the ball is from it.
std::pair<double, double> middle_of(const RealBall& a) {
  const double middle = approximate(a);
  const RealBall at = exact_sum(middle, 0);
  return {middle, std::max(upper_double(subtract(a, at, section_bits)),
                           upper_double(subtract(at, a, section_bits)))};
}

double size(const Vector<double>& v) { return std::hypot(v[0], v[1], v[2]); }

/// To such numbers; what the point, a sum of two with an error of 2^−50 of itself, is off then.
double round_point(Vector<double>& point, Coordinates numbers) {
  double off = 0x1p-50 * size(point);
  if (numbers == Coordinates::doubles) return off;
  const Vector<double> exact = point;
  for (double& x : point) x = static_cast<double>(as_float(x));
  return off + size(point - exact);
}

}  // namespace

SweepSections::PathDerivatives SweepSections::derivatives_at(std::size_t segment, double t) const {
  const RealBall at(exact_rational(t), section_bits);
  const auto series = path_.series.position(segment, at, 3, section_bits);
  const auto motion = along_motion(path_.series, segment, at, series, 2, section_bits);
  PathDerivatives found{};
  Vector<double> rate{};
  Vector<double> along{};
  Vector<double> along_rate{};
  for (std::size_t k = 0; k < 3; ++k) {
    found.place[k] = series[k].coefficient(0);
    rate[k] = approximate(series[k].coefficient(1));
    along[k] = approximate(motion[k].coefficient(0));
    along_rate[k] = approximate(motion[k].coefficient(1));
  }
  const double length = size(along);
  found.speed = size(rate);
  found.tangent = 1 / length * along;
  found.tangent_rate = 1 / length * (along_rate - dot(found.tangent, along_rate) * found.tangent);
  return found;
}

SweepSections::SweepSections(const SweepPath& path, const SweepForm& form, const SweepTurn& turn)
    : path_(path), form_(form), turn_(turn), scale_(form.scale, path.series.segments) {
  if (form.origin)
    for (std::size_t k = 0; k < 3; ++k) origin_[k] = RealBall(form.origin->at(k), section_bits);
  for (const auto& [x, y] : form.profile.corners())
    corners_.push_back({round_to_double(x), round_to_double(y)});
}

bool SweepSections::has_corner(std::size_t segment) const {
  return std::binary_search(path_.corners.begin(), path_.corners.end(), segment);
}

std::size_t SweepSections::before(std::size_t segment) const {
  return (segment > 0 ? segment : path_.series.segments) - 1;
}

namespace {

/// v turned by the least rotation that takes the unit vector a to b.
Vector<double> carried(const Vector<double>& v, const Vector<double>& a, const Vector<double>& b) {
  const Vector<double> axis = cross(a, b);
  return dot(a, b) * v + cross(axis, v) + (dot(axis, v) / (1 + dot(a, b))) * axis;
}

}  // namespace

Frame<double> frame_at_end(const SweepPath& path) {
  const Frame<double> last = path.frames(static_cast<double>(path.series.segments));
  if (path.corners.empty() || path.corners.front() != 0) return last;
  const Vector<double> first = path.frames(0).e1;
  return {first, carried(last.e2, last.e1, first), carried(last.e3, last.e1, first)};
}

// The frames of a joint are those behind the corner.
Frame<double> SweepSections::frame(std::size_t segment, double t) const {
  const Frame<double> found = path_.frames(static_cast<double>(segment) + t);
  if (t < 1 || segment + 1 == path_.series.segments || !has_corner(segment + 1)) return found;
  const Vector<double> here = tangent(segment + 1, 0);
  const Vector<double> back = tangent(segment, 1);
  return {carried(found.e1, here, back), carried(found.e2, here, back),
          carried(found.e3, here, back)};
}

std::vector<Vector<double>> SweepSections::outline(std::size_t segment, double t) const {
  const Frame<double> axes = frame(segment, t);
  const double phi = turn_.angle(segment, t);
  const double scale = scale_.at(0, segment, t);
  const double cos = scale * std::cos(phi);
  const double sin = scale * std::sin(phi);
  std::vector<Vector<double>> points;
  points.reserve(corners_.size());
  for (const auto& [x, y] : corners_)
    points.push_back((cos * x - sin * y) * axes.e2 + (sin * x + cos * y) * axes.e3);
  return points;
}

SweepSection SweepSections::around(const PathDerivatives& at, double along,
                                   const std::vector<Vector<double>>& outline) const {
  Vector<double> center{};
  double off = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, error] = middle_of(subtract(at.place[k], origin_[k], section_bits));
    center[k] = x;
    off += error;
  }
  SweepSection section{along, {}};
  section.points.reserve(outline.size());
  for (const Vector<double>& out : outline) {
    Vector<double> point = center + out;
    section.rounding = std::max(section.rounding, round_point(point, form_.numbers));
    section.points.push_back(point);
  }
  section.rounding = (section.rounding + off) * sweep_slack;
  return section;
}

SweepSection SweepSections::section(std::size_t segment, double t) const {
  const PathDerivatives at = derivatives_at(segment, t);
  const auto outline = this->outline(segment, t);
  SweepSection section = around(at, static_cast<double>(segment) + t, outline);
  // Along T it moves by |r′| − v·T′, which at a cusp of a straight line is 0, too.
  for (const Vector<double>& out : outline) {
    const double back = dot(out, at.tangent_rate);
    if (back > 0 && back >= at.speed) ++section.folds;
  }
  return section;
}

// The reflection in the plane through the center that is normal to m = T₋ + T₊, unit tangents,
// takes T₋ to −T₊ and what is normal to T₋ to where the least rotation takes it: the lines along
// the tangents through a corner of the profile before and behind, v, meet in that plane, in v −
// (v·m)/(T₊·m)·T₊.
std::vector<double> SweepSections::mitre_offsets(std::size_t segment) const {
  const Vector<double> forward = tangent(segment, 0);
  const Vector<double> m = forward + tangent(before(segment), 1);
  std::vector<double> offsets;
  for (const Vector<double>& out : outline(segment, 0))
    offsets.push_back(-dot(out, m) / dot(forward, m));
  return offsets;
}

SweepSection SweepSections::mitre(std::size_t segment) const {
  const Vector<double> forward = tangent(segment, 0);
  auto outline = this->outline(segment, 0);
  const std::vector<double> offsets = mitre_offsets(segment);
  for (std::size_t k = 0; k < outline.size(); ++k) outline[k] = outline[k] + offsets[k] * forward;
  return around(derivatives_at(segment, 0), static_cast<double>(segment), outline);
}

double SweepSections::chord(std::size_t segment) const {
  const auto from = derivatives_at(segment, 0).place;
  const auto to = derivatives_at(segment, 1).place;
  Vector<double> way{};
  for (std::size_t k = 0; k < 3; ++k) way[k] = approximate(subtract(to[k], from[k], section_bits));
  return size(way);
}

SweepMotion SweepSections::motion(std::size_t segment, double t) const {
  const PathDerivatives at = derivatives_at(segment, t);
  const Frame<double> frame = this->frame(segment, t);
  const double phi = turn_.angle(segment, t);
  SweepMotion motion{};
  motion.speed = at.speed;
  motion.tangent = at.tangent;
  motion.tangent_rate = at.tangent_rate;
  motion.x = std::cos(phi) * frame.e2 + std::sin(phi) * frame.e3;
  motion.y = std::cos(phi) * frame.e3 - std::sin(phi) * frame.e2;
  motion.scale = scale_.at(0, segment, t);
  motion.scale_rate = scale_.at(1, segment, t);
  motion.turn_rate = turn_.rate(segment, t) * at.speed + turn_.roll_rate(segment, t);
  return motion;
}

// ---- triangles and patches

// The two triangles of four corners are as near to the patch as the lines through its diagonals
// are to each other, where the diagonals cross in projection along their common normal: the patch
// and the triangles are graphs above the same quadrilateral then, between the two parallel planes
// of the diagonals. Otherwise a quarter of |P₀₀ − P₀₁ − P₁₀ + P₁₁| is a bound.

namespace {

/// For the corners a, b of one section and c, d of the next, the diagonal being that from a to d.
double distance_to_patch(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c,
                         const Vector<double>& d) {
  const Vector<double> first = d - a;
  const Vector<double> second = c - b;
  const Vector<double> to_b = b - a;
  const double any_way = size(to_b - (d - c)) / 4;
  const Vector<double> normal = cross(first, second);
  const double length = size(normal);
  // Each diagonal has the ends of the other on both its sides, clearly.
  const auto side = [&](const Vector<double>& along, const Vector<double>& from_it) {
    return dot(cross(along, from_it), normal);
  };
  const double margin = 0x1p-30 * length * length;
  const bool is_convex = side(first, to_b) < -margin && side(first, c - a) > margin &&
                         side(second, a - b) > margin && side(second, d - b) < -margin;
  if (!is_convex) return any_way;
  return std::min(any_way, std::abs(dot(to_b, normal)) / length);
}

}  // namespace

double patch_error(const SweepSections& sections, const SweepSection& a, const SweepSection& b) {
  double greatest = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const std::size_t next = sections.next(k);
    greatest = std::max(
        greatest, distance_to_patch(a.points[k], a.points[next], b.points[k], b.points[next]));
  }
  return greatest * sweep_slack;
}

// ---- normals

// On a side with the direction d, a unit vector of the section, and m = d turned by a quarter, the
// corner v = λ(c d + e m) has
//   S_u ∥ d,  S_t = gT + p d + q m,  g = |r′| − v·T′,  q = λ′e + φ′λc,
// since f₂′ = −(f₂·T′)T and f₃′ likewise, so that the outward normal is
//   n = (qT − gm)/√(g² + q²) = sin ψ T − cos ψ m,  ψ = atan(q/g),  where g > 0.
// On a section it lies between those of the two ends of a side, on an arc, as q and g are linear
// in u. Along t, with m′ = −φ′d − (m·T′)T,
//   n′ = (ψ′ + m·T′)(cos ψ T + sin ψ m) + (sin ψ d·T′ + cos ψ φ′)d,
//   |n′| ≤ |ψ′| + |T′| + |φ′|,  ψ′ = (q′g − qg′)/(g² + q²),
//   |g′| ≤ |r″| + ρ((|λ′| + λ|φ′|)|T′| + λ|T″|),  |q′| ≤ ρ(|λ″| + |λ′φ′| + λ|φ″|),
// so that a normal N of a triangle is within α + max|n′|·Δt/2 of all of them, if it is within α <
// π/2 of those at the four corners: caps of a sphere smaller than half of it are convex. Where the
// side stands for a curve, β being the angle between them and δ their distance, n is elsewhere by
// β and by what ψ moves with g, by λδ|T′| at most, and q, by (|λ′| + λ|φ′|)(δ + ρβ).

namespace {

/// g, q and n at a corner of a side.
struct CornerNormal {
  double g;
  double q;
  Vector<double> n;
  double slack;  ///< of the angle, from rounding
};

CornerNormal normal_at(const SweepMotion& motion, const std::array<double, 2>& corner,
                       const std::array<double, 2>& d) {
  const auto& [x, y] = corner;
  const Vector<double> out = (motion.scale * x) * motion.x + (motion.scale * y) * motion.y;
  const Vector<double> m = d[0] * motion.y - d[1] * motion.x;
  const double along = x * d[0] + y * d[1];
  const double across = d[0] * y - d[1] * x;
  CornerNormal at{};
  at.g = motion.speed - dot(out, motion.tangent_rate);
  at.q = motion.scale_rate * across + motion.turn_rate * motion.scale * along;
  const double length = std::hypot(at.g, at.q);
  at.n = at.q / length * motion.tangent - at.g / length * m;
  // Numbers are within 2^−44 of themselves or of what they are sums of.
  const double terms =
      motion.speed + size(out) * size(motion.tangent_rate) +
      std::hypot(x, y) * (std::abs(motion.scale_rate) + std::abs(motion.turn_rate) * motion.scale);
  at.slack = 0x1p-40 * terms / length;
  return at;
}

double angle_between(const Vector<double>& a, const Vector<double>& b) {
  return std::atan2(size(cross(a, b)), dot(a, b));
}

/// N, of any length, and how far its computed direction may be from it.
struct TriangleNormal {
  Vector<double> n;
  double slack;
};

TriangleNormal triangle_normal(const Vector<double>& a, const Vector<double>& b,
                               const Vector<double>& c) {
  const Vector<double> n = cross(b - a, c - a);
  return {n, 0x1p-48 * size(b - a) * size(c - a) / size(n)};
}

std::array<double, 2> direction_between(const std::array<double, 2>& from,
                                        const std::array<double, 2>& to) {
  const double x = to[0] - from[0];
  const double y = to[1] - from[1];
  const double length = std::hypot(x, y);
  return {x / length, y / length};
}

/// On a strip of triangles along a side: the least g, the greatest |q|.
struct SideTilt {
  double g;
  double q;

  /// As far as ψ moves where g and q move by so much at most: |∂ψ/∂q| = g/(g² + q²).
  double moved(double by_g, double by_q) const {
    return by_q / g + by_g * std::min(q / g / g, 1 / (2 * g));
  }
};

/// What the strip's rates say of all its sides.
struct StripRates {
  double g;        ///< |g′|
  double q;        ///< |q′|
  double curve_g;  ///< by which g of the profile's curve differs from that of the polygon
  double curve_q;
};

StripRates strip_rates(const SweepStrip& strip) {
  const SweepRates& rates = strip.rates;
  const auto& [scale, scale1, scale2] = rates.scale;
  // Of v′ what is along T is not along T′.
  const double g =
      rates.acceleration +
      strip.reach * ((scale1 + scale * rates.turn) * rates.tangent + scale * rates.tangent2);
  const double q = strip.reach * (scale2 + scale1 * rates.turn + scale * rates.turn2);
  const double curve_g = scale * strip.side_error * rates.tangent;
  const double curve_q =
      (scale1 + rates.turn * scale) * (strip.side_error + strip.reach * strip.side_angle);
  return {g * sweep_slack, q * sweep_slack, curve_g * sweep_slack, curve_q * sweep_slack};
}

/// Of the two triangles on one side.
double side_normal_error(const std::array<TriangleNormal, 2>& triangles,
                         const std::array<CornerNormal, 4>& corners, const StripRates& rates,
                         const SweepStrip& strip) {
  SideTilt tilt{HUGE_VAL, 0};
  double angle = 0;
  for (const CornerNormal& at : corners) {
    tilt.g = std::min(tilt.g, at.g);
    tilt.q = std::max(tilt.q, std::abs(at.q));
    for (const TriangleNormal& triangle : triangles)
      angle = std::max(angle, angle_between(triangle.n, at.n) + triangle.slack + at.slack);
  }
  const double half = strip.step / 2;
  tilt.g -= rates.g * half + rates.curve_g;
  tilt.q += rates.q * half + rates.curve_q;
  if (!(tilt.g > 0) || !(angle < M_PI / 2)) return HUGE_VAL;
  const double turn = tilt.moved(rates.g, rates.q) + strip.rates.tangent + strip.rates.turn;
  return angle + turn * half + strip.side_angle + tilt.moved(rates.curve_g, rates.curve_q);
}

}  // namespace

double normal_error(const SweepSections& sections, const SweepSection& a, const SweepSection& b,
                    const SweepStrip& strip) {
  const StripRates rates = strip_rates(strip);
  double greatest = 0;
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    const std::size_t next = sections.next(k);
    const auto& p = sections.corners()[k];
    const auto& o = sections.corners()[next];
    const auto d = direction_between(p, o);
    std::array<TriangleNormal, 2> triangles{
        triangle_normal(a.points[k], a.points[next], b.points[next]),
        triangle_normal(a.points[k], b.points[next], b.points[k])};
    if (strip.is_against)
      for (TriangleNormal& triangle : triangles) triangle.n = -1.0 * triangle.n;
    greatest = std::max(greatest,
                        side_normal_error(triangles,
                                          {normal_at(strip.from, p, d), normal_at(strip.from, o, d),
                                           normal_at(strip.to, p, d), normal_at(strip.to, o, d)},
                                          rates, strip));
  }
  return greatest * sweep_slack;
}

double least_advance(const SweepSections& sections, const SweepMotion& motion) {
  double least = HUGE_VAL;
  for (const auto& corner : sections.corners())
    least = std::min(least, normal_at(motion, corner, {1, 0}).g);
  return least;
}

std::vector<double> normal_turns(const SweepSections& sections, const SweepMotion& motion) {
  std::vector<double> turns;
  for (std::size_t k = 0; k < sections.corners().size(); ++k) {
    const auto& p = sections.corners()[k];
    const auto& o = sections.corners()[sections.next(k)];
    const auto d = direction_between(p, o);
    turns.push_back(angle_between(normal_at(motion, p, d).n, normal_at(motion, o, d).n));
  }
  return turns;
}

}  // namespace phrame
