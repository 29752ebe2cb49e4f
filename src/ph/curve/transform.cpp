// With w(t) = a + (b − a)t, (r∘w)′ = (b − a)·(f∘w)·(A∘w) i (A∘w)*. And U(f·A i A*)U* = f·(UA) i
// (UA)*.
#include "phrame/ph/curve/transform.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/power_series.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

void require_apart(const Rational& a, const Rational& b) {
  if (a == b)
    throw DomainError("segment: its ends are equal, t = " + as_written(a) + ", so it is a point");
}

void require_nonzero(const Rational& c) {
  if (c == 0) throw DomainError("scaled: the factor is 0, so the curve is a point");
}

void require_nonzero(const RationalQuaternion& u) {
  if (norm(u) == 0) throw DomainError("rotated: the quaternion is 0, so the curve is a point");
}

using Matrix = std::array<Vector<Rational>, 3>;  ///< by columns

/// A + (B − A)·t for numbers A and B; numbers where they are that.
Formula between(const Formula& from, const Formula& to, const Rational& t) {
  if (t == 0) return from;
  if (t == 1) return to;
  const auto is_number = [](const Formula& f) {
    return f.steps().size() == 1 && f.steps().front().operation == Formula::Operation::number;
  };
  if (!is_number(from) || !is_number(to)) return from + Formula(t) * (to - from);
  const Formula::Step& a = from.steps().front();
  const Formula::Step& b = to.steps().front();
  return {a.number + t * (b.number - a.number),
          a.pi_multiple + t * (b.pi_multiple - a.pi_multiple)};
}

/// M·r, without what is 0.
template <class T>
Vector<T> product(const Matrix& m, const Vector<T>& r) {
  Vector<T> result;
  for (std::size_t row = 0; row < 3; ++row) {
    bool is_empty = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (m[k][row] == 0) continue;
      const T term = m[k][row] == 1 ? r[k] : T(m[k][row] * r[k]);
      result[row] = is_empty ? term : T(result[row] + term);
      is_empty = false;
    }
  }
  return result;
}

// ---- the same of a segment of every kind

Segment part(const PhSegment& ph, const Rational& a, const Rational& b) {
  return PhSegment(segment(ph.curve(), a, b));
}
Segment part(const RationalCurve& curve, const Rational& a, const Rational& b) {
  const Polynomial w{a, b - a};
  const auto& [x, y, z] = curve.numerator();
  return RationalCurve({compose(x, w), compose(y, w), compose(z, w)}, compose(curve.weight(), w));
}
Segment part(const ExpressionCurve& curve, const Rational& a, const Rational& b) {
  return ExpressionCurve(curve.position(), between(curve.from(), curve.to(), a),
                         between(curve.from(), curve.to(), b), curve.variable());
}

Segment moved(const RationalCurve& curve, const Matrix& m, const Vector<Rational>& v) {
  Vector<Polynomial> numerator = product(m, curve.numerator());
  for (std::size_t k = 0; k < 3; ++k) numerator[k] += v[k] * curve.weight();
  return RationalCurve(numerator, curve.weight());
}
Segment moved(const ExpressionCurve& curve, const Matrix& m, const Vector<Rational>& v) {
  Vector<Formula> position = product(m, curve.position());
  for (std::size_t k = 0; k < 3; ++k)
    if (v[k] != 0) position[k] = position[k] + Formula(v[k]);
  return ExpressionCurve(position, curve.from(), curve.to(), curve.variable());
}

/// f of PH curves, else M·r + v.
template <class F>
Path mapped(const Path& path, const F& f, const Matrix& m, const Vector<Rational>& v = {}) {
  std::vector<Segment> segments;
  for (const Segment& segment : path.segments())
    if (const Curve* ph = ph_curve(segment))
      segments.emplace_back(PhSegment(f(*ph)));
    else if (const auto* curve = std::get_if<RationalCurve>(&segment))
      segments.push_back(moved(*curve, m, v));
    else
      segments.push_back(moved(std::get<ExpressionCurve>(segment), m, v));
  return Path::of_continuous(std::move(segments), path.corners());
}

// ---- all of a rational curve

/// Dⁿ·p(1/D), D = 1 − 2s, n ≥ deg p.
Polynomial through_infinity(const Polynomial& p, long n) {
  return compose(reversed(p, n + 1), Polynomial{1, -2});
}
Vector<Polynomial> through_infinity(const Vector<Polynomial>& r, long n) {
  return {through_infinity(r[0], n), through_infinity(r[1], n), through_infinity(r[2], n)};
}

Segment second_half(const RationalCurve& curve) {
  const long n = curve.weight().degree();
  return RationalCurve(through_infinity(curve.numerator(), n), through_infinity(curve.weight(), n));
}
Segment second_half(const Curve& curve) {
  const long n = curve.weight().degree();
  const long m = preimage_degree(curve);
  const auto& [u, v, p, q] = curve.preimage();
  return PhSegment(
      Curve::quotient({through_infinity(u, m), through_infinity(v, m), through_infinity(p, m),
                       through_infinity(q, m)},
                      Rational(2) * through_infinity(curve.multiplier(), 2 * n - 2 - 2 * m),
                      through_infinity(numerator(curve), n), through_infinity(curve.weight(), n)));
}

void require_finite(const RationalCurve& curve) {
  const Polynomial& weight = curve.weight();
  if (weight.is_constant())
    throw DomainError(
        "whole line: the curve is polynomial: it goes to infinity and does not come back");
  const auto poles = real_roots(weight, Interval{});
  if (!poles.empty())
    throw DomainError("whole line: the curve goes to infinity at " +
                      place_text("t", poles.front().at));
  if (degree(curve) > weight.degree())
    throw DomainError(
        fmt::format("whole line: the curve goes to infinity at t = infinity: degree {} over a "
                    "weight of degree {}",
                    degree(curve), weight.degree()));
}

/// The same with X and W in lowest terms, for which A and f are found anew where they were not.
Curve in_lowest_terms(const PhSegment& ph) {
  const RationalCurve& r = ph.by_positions();
  if (r.weight().degree() == ph.curve().weight().degree()) return ph.curve();
  return std::get<Curve>(identify(r));
}

/// The least whole c > 0 with r′ ≠ 0 at t = c and t = −c.
Rational regular_cut(const RationalCurve& curve) {
  const Polynomial& p = curve.multiplier();
  Rational c = 1;
  while (p(c) == 0 || p(-c) == 0) c += 1;
  return c;
}

Matrix diagonal(const Rational& c) {
  return {Vector<Rational>{c, 0, 0}, Vector<Rational>{0, c, 0}, Vector<Rational>{0, 0, c}};
}

}  // namespace

Curve segment(const Curve& curve, const Rational& a, const Rational& b) {
  require_apart(a, b);
  const Polynomial w{a, b - a};
  const auto composed = [&w](const Vector<Polynomial>& r) -> Vector<Polynomial> {
    return {compose(r[0], w), compose(r[1], w), compose(r[2], w)};
  };
  const auto& [u, v, p, q] = curve.preimage();
  QuaternionPolynomial preimage{compose(u, w), compose(v, w), compose(p, w), compose(q, w)};
  Polynomial f = Rational(b - a) * compose(curve.multiplier(), w);
  if (curve.is_polynomial())
    return Curve(std::move(preimage), std::move(f), evaluate(position(curve), a));
  return Curve::quotient(std::move(preimage), std::move(f), composed(numerator(curve)),
                         compose(curve.weight(), w));
}

Curve reversed(const Curve& curve) { return segment(curve, 1, 0); }

Curve translated(const Curve& curve, const Vector<Rational>& v) {
  if (curve.is_polynomial()) return Curve(curve.preimage(), curve.multiplier(), curve.start() + v);
  Vector<Polynomial> moved = numerator(curve);
  for (std::size_t k = 0; k < 3; ++k) moved[k] += v[k] * curve.weight();
  return Curve::quotient(curve.preimage(), curve.multiplier(), std::move(moved), curve.weight());
}

Curve scaled(const Curve& curve, const Rational& c) {
  require_nonzero(c);
  if (curve.is_polynomial())
    return Curve(curve.preimage(), c * curve.multiplier(), c * curve.start());
  return Curve::quotient(curve.preimage(), c * curve.multiplier(),
                         product(diagonal(c), numerator(curve)), curve.weight());
}

Curve rotated(const Curve& curve, const RationalQuaternion& u) {
  require_nonzero(u);
  const QuaternionPolynomial constant{{u.u}, {u.v}, {u.p}, {u.q}};
  const Matrix turn{rotated_i(u), rotated_j(u), rotated_k(u)};
  if (curve.is_polynomial())
    return Curve(constant * curve.preimage(), curve.multiplier(), product(turn, curve.start()));
  return Curve::quotient(constant * curve.preimage(), curve.multiplier(),
                         product(turn, numerator(curve)), curve.weight());
}

Path segment(const Path& path, const Rational& a, const Rational& b) {
  require_apart(a, b);
  if (goes_on(path)) return Path(segment(*ph_curve(path.segments().front()), a, b));
  const auto [from, to] = std::minmax(a, b);
  for (const Rational& t : {from, to}) locate(path, t);  // where it throws
  std::vector<Segment> parts;
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < path.segments().size(); ++k) {
    const Rational before(static_cast<long>(k));
    const Rational first = std::max(Rational(from - before), Rational(0));
    const Rational last = std::min(Rational(to - before), Rational(1));
    if (first >= last) continue;
    if (!parts.empty() && path.has_corner(k)) corners.push_back(parts.size());
    parts.push_back(std::visit(
        [&](const auto& curve) {
          return a < b ? part(curve, first, last) : part(curve, last, first);
        },
        path.segments()[k]));
  }
  if (b < a) {
    std::reverse(parts.begin(), parts.end());
    std::reverse(corners.begin(), corners.end());
    for (std::size_t& corner : corners) corner = parts.size() - corner;
  }
  return Path::of_continuous(std::move(parts), std::move(corners));
}

Path reversed(const Path& path) { return segment(path, path.end(), 0); }

Path whole_line(const Path& path) {
  if (path.segments().size() != 1)
    throw DomainError(fmt::format("whole line: a path of {} curves is not one for all t",
                                  path.segments().size()));
  const RationalCurve* curve = rational_curve(path.segments().front());
  if (curve == nullptr)
    throw DomainError("whole line: a curve by formulas is on its interval alone");
  require_finite(*curve);
  const Rational c = regular_cut(*curve);
  const auto* ph = std::get_if<PhSegment>(&path.segments().front());
  if (ph == nullptr)
    return joined({part(*curve, -c, c), second_half(std::get<RationalCurve>(part(*curve, 0, c)))});
  const Curve reduced = in_lowest_terms(*ph);
  return joined({PhSegment(segment(reduced, -c, c)), second_half(segment(reduced, 0, c))});
}

Path translated(const Path& path, const Vector<Rational>& v) {
  return mapped(
      path, [&](const Curve& curve) { return translated(curve, v); }, diagonal(1), v);
}

Path scaled(const Path& path, const Rational& c) {
  require_nonzero(c);
  return mapped(
      path, [&](const Curve& curve) { return scaled(curve, c); }, diagonal(c));
}

Path rotated(const Path& path, const RationalQuaternion& u) {
  require_nonzero(u);
  return mapped(path, [&](const Curve& curve) { return rotated(curve, u); },
                {rotated_i(u), rotated_j(u), rotated_k(u)});
}

Vector<Rational> AffineMap::operator()(const Vector<Rational>& r) const {
  return product(columns, r) + shift;
}

AffineMap affine_map(const std::vector<Rational>& rows) {
  const std::size_t size = rows.size();
  if (size != 9 && size != 12 && size != 16)
    throw DomainError(fmt::format("{} numbers are no matrix: 9, 12 or 16 are, row by row", size));
  const std::size_t width = size == 9 ? 3 : 4;
  if (size == 16 && std::vector(rows.begin() + 12, rows.end()) != std::vector<Rational>{0, 0, 0, 1})
    throw DomainError("the last row of the matrix is not 0, 0, 0, 1");
  AffineMap map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 3; ++k) map.columns[k][row] = rows[width * row + k];
    if (width == 4) map.shift[row] = rows[width * row + 3];
  }
  return map;
}

AffineMap composed(const AffineMap& first, const AffineMap& second) {
  AffineMap both{{}, second(first.shift)};
  for (std::size_t k = 0; k < 3; ++k) both.columns[k] = product(second.columns, first.columns[k]);
  return both;
}

// MᵀM = c²·1, and det M = c³.
std::optional<Similarity> similarity(const AffineMap& map) {
  const auto& [x, y, z] = map.columns;
  const Rational determinant = dot(cross(x, y), z);
  if (determinant == 0) return std::nullopt;
  const Rational factor = determinant / dot(x, x);
  const Rational inverse = 1 / factor;
  const auto rotation = nearest_rotation({inverse * x, inverse * y, inverse * z});
  if (!rotation || rotation->off != 0) return std::nullopt;
  return Similarity{factor, rotation->rotation};
}

Path transformed(const Path& path, const AffineMap& map) {
  if (const auto found = similarity(map)) {
    const Rational factor = found->factor / norm(found->rotation);
    return mapped(
        path,
        [&](const Curve& curve) {
          return translated(scaled(rotated(curve, found->rotation), factor), map.shift);
        },
        map.columns, map.shift);
  }
  std::vector<Segment> segments;
  for (const Segment& segment : path.segments()) {
    Segment next = visit_curve(
        [&](const auto& curve) { return moved(curve, map.columns, map.shift); }, segment);
    const RationalCurve* curve = rational_curve(next);
    if (curve != nullptr && curve->weight().is_constant()) {
      auto ph = identify(hodograph(*curve), point(*curve, 0));
      if (auto* found = std::get_if<Curve>(&ph)) next = PhSegment(std::move(*found));
    }
    segments.push_back(std::move(next));
  }
  return joined(std::move(segments));
}

}  // namespace phrame
