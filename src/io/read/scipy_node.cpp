#include "phrame/io/read/scipy_node.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/as_written.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/rounding.hpp"
#include "phrame/io/read/bspline_node.hpp"
#include "phrame/io/write/text.hpp"
#include "phrame/ph/curve/bspline.hpp"
#include "phrame/ph/curve/vector.hpp"

namespace phrame::inline v0 {
namespace {

using Kind = JsonNode::Kind;
using Points = std::vector<Vector<Rational>>;

bool is_tck(const JsonNode& node) {
  return node.is(Kind::array) && node.size() == 3 && node.item(0).is(Kind::array) &&
         node.item(1).is(Kind::array) && node.item(2).is(Kind::number);
}

/// A list of numbers for each point, or of points for each coordinate.
Points read_columns(const JsonNode& list, bool is_by_coordinate) {
  list.require(Kind::array, "a list of coefficients");
  std::vector<std::vector<Rational>> rows;
  for (std::size_t k = 0; k < list.size(); ++k) {
    list.item(k).require(Kind::array, "a list of numbers");
    rows.push_back(list.item(k).numbers());
    if (rows.back().size() != rows.front().size())
      list.item(k).fail(fmt::format("{} here, but {} in the first list",
                                    counted(rows.back().size(), "number"), rows.front().size()));
  }
  const std::size_t inner = rows.empty() ? 0 : rows.front().size();
  const std::size_t dimension = is_by_coordinate ? rows.size() : inner;
  if (dimension != 2 && dimension != 3)
    list.fail(fmt::format("the curve has {}: 2 and 3 are read", counted(dimension, "coordinate")));
  Points points(is_by_coordinate ? inner : rows.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t c = 0; c < dimension; ++c)
      points[k][c] = is_by_coordinate ? rows[c][k] : rows[k][c];
  return points;
}

PointCurve read_bspline(const JsonNode& t, const JsonNode& c, const JsonNode& k, bool is_of_splprep,
                        const CurveLimits& limits) {
  BSpline spline;
  spline.degree = read_degree(k, limits);
  t.require(Kind::array, "a list of knots");
  spline.knots = t.numbers();
  const auto count = static_cast<long>(spline.knots.size()) - spline.degree - 1;
  if (count <= spline.degree)
    t.fail(fmt::format("{} are too few for the degree {}", counted(spline.knots.size(), "knot"),
                       spline.degree));
  c.require(Kind::array, "a list of coefficients");
  const bool is_by_coordinate =
      is_of_splprep || (c.size() <= 3 && static_cast<long>(c.size()) < count);
  spline.points = read_columns(c, is_by_coordinate);
  if (static_cast<long>(spline.points.size()) < count)
    c.fail(fmt::format("{} coefficients for {} and the degree {}", spline.points.size(),
                       counted(spline.knots.size(), "knot"), spline.degree));
  spline.points.resize(static_cast<std::size_t>(count));
  if (const auto fault = fault_of(spline)) t.fail(fault->reason);
  return {"", span_segments(spline, t.place())};
}

/// Σ a_k z^k on [0, 1], in the basis of Bernstein: b_i = Σ_{j ≤ i} C(i, j)/C(n, j) a_j.
RationalBezier bezier_of_powers(const Points& a) {
  RationalBezier bezier;
  const auto n = static_cast<long>(a.size()) - 1;
  for (long i = 0; i <= n; ++i) {
    Vector<Rational> b;
    Rational factor(1);  // C(i, j)/C(n, j)
    for (long j = 0; j <= i; ++j) {
      b = b + factor * a[static_cast<std::size_t>(j)];
      if (j < i) factor *= Rational(i - j, n - j);
    }
    bezier.points.push_back(b);
  }
  return bezier;
}

Rational largest(const Vector<Rational>& v) {
  return std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
}

/// The pieces, on [0, 1] each, with the lengths of their intervals.
struct Pieces {
  std::vector<RationalBezier> beziers;
  std::vector<Rational> steps;
};

/// By x, from the right.
Vector<Rational> slope_at_start(const RationalBezier& b, const Rational& step) {
  return Rational(3 / step) * (b.points[1] - b.points[0]);
}
Vector<Rational> slope_at_end(const RationalBezier& b, const Rational& step) {
  return Rational(3 / step) * (b.points[3] - b.points[2]);
}

/// Makes cubic pieces meet; how far they were apart, in position or in the derivative.
Rational join(Pieces& pieces, const JsonNode& node) {
  Rational apart;
  Rational size;
  Rational slope_apart;
  Rational slope_size;
  auto& beziers = pieces.beziers;
  for (std::size_t k = 0; k + 1 < beziers.size(); ++k) {
    const Vector<Rational> slope = slope_at_start(beziers[k + 1], pieces.steps[k + 1]);
    apart = std::max(apart, largest(beziers[k + 1].points[0] - beziers[k].points[3]));
    size = std::max(size, largest(beziers[k].points[3] - beziers[k].points[0]));
    slope_apart = std::max(slope_apart, largest(slope - slope_at_end(beziers[k], pieces.steps[k])));
    slope_size = std::max(slope_size, largest(slope));
    beziers[k].points[3] = beziers[k + 1].points[0];
    beziers[k].points[2] = beziers[k].points[3] - Rational(pieces.steps[k] / 3) * slope;
  }
  const Rational tolerance = power_of_ten(-9);
  if (apart > tolerance * size || slope_apart > tolerance * slope_size)
    node.fail(
        fmt::format("the pieces are apart at the breakpoints, by up to {} in position and {} "
                    "in the derivative: this is no smooth curve",
                    as_written(apart), as_written(slope_apart)));
  return std::max(apart, slope_apart);
}

Pieces read_pieces(const JsonNode& c, const JsonNode& x, const CurveLimits& limits) {
  c.require(Kind::array, "a list of coefficients");
  x.require(Kind::array, "a list of breakpoints");
  const std::vector<Rational> breaks = x.numbers();
  if (c.size() < 2 || static_cast<long>(c.size()) - 1 > limits.max_degree)
    c.fail(fmt::format("the degree {} is not from 1 to {}", static_cast<long>(c.size()) - 1,
                       limits.max_degree));
  std::vector<Points> powers;  // the highest first
  for (std::size_t i = 0; i < c.size(); ++i) {
    powers.push_back(read_columns(c.item(i), false));
    if (powers.back().size() + 1 != breaks.size())
      c.item(i).fail(fmt::format("{} for {}", counted(powers.back().size(), "piece"),
                                 counted(breaks.size(), "breakpoint")));
  }
  Pieces pieces;
  for (std::size_t j = 0; j + 1 < breaks.size(); ++j) {
    const Rational step = breaks[j + 1] - breaks[j];
    if (step <= 0) x.item(j + 1).fail("the breakpoint is not greater than that before it");
    Points scaled;
    Rational power(1);
    for (std::size_t i = c.size(); i-- > 0; power *= step) scaled.push_back(power * powers[i][j]);
    pieces.beziers.push_back(bezier_of_powers(scaled));
    pieces.steps.push_back(step);
  }
  return pieces;
}

PointCurve read_ppoly(const JsonNode& c, const JsonNode& x, const CurveLimits& limits) {
  Pieces pieces = read_pieces(c, x, limits);
  const std::vector<Rational> breaks = x.numbers();
  PointCurve curve;
  if (c.size() == 4 && pieces.beziers.size() > 1)
    if (const Rational apart = join(pieces, c); apart > 0)
      curve.notes.push_back(fmt::format(
          "the pieces are up to {} apart, as those in doubles are: the curve is the C1 cubic with "
          "their values and derivatives at the breakpoints",
          upper_bound_text(apart)));
  for (std::size_t k = 0; k < pieces.beziers.size(); ++k)
    curve.segments.push_back(span_segment({pieces.beziers[k], breaks[k], breaks[k + 1]},
                                          x.item(k).place(), "the curve from here on"));
  return curve;
}

}  // namespace

bool is_scipy_curve(const JsonNode& node) {
  if (is_tck(node)) return true;
  if (node.is(Kind::array)) return node.size() == 2 && is_tck(node.item(0));
  if (!node.is(Kind::object) || node.find("phrame") || !node.find("c")) return false;
  return node.find("x") || (node.find("t") && node.find("k"));
}

PointCurve read_scipy(const JsonNode& node, const CurveLimits& limits) {
  if (node.is(Kind::array)) {
    const JsonNode tck = is_tck(node) ? node : node.item(0);
    return read_bspline(tck.item(0), tck.item(1), tck.item(2), true, limits);
  }
  if (node.find("t")) return read_bspline(node.at("t"), node.at("c"), node.at("k"), false, limits);
  return read_ppoly(node.at("c"), node.at("x"), limits);
}

}  // namespace phrame
