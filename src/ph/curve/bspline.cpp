#include "phrame/ph/curve/bspline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "phrame/algebra/error.hpp"

// On [uᵢ, uᵢ₊₁] = [a, b] the control points P_{i−p} … P_i are the values of the blossom at any p
// successive ones of the knots u_{i−p+1} … u_{i+p}. Inserting a in place of the knots before it
// leaves b(a, …, a, uᵢ₊₁, …, uᵢ₊ⱼ), and b then in place of those behind b(a, …, a, b, …, b). The
// blossom is affine in each argument: from the values at x and y, with the others the same, comes
// that at any other number. Points are homogeneous, (wx, wy, wz, w).

namespace phrame::inline v0 {
namespace {

using HomogeneousPoint = std::array<Rational, 4>;
using Member = BSplineFault::Member;

std::string short_text(const Rational& x) { return abbreviated(to_string(x)); }

/// The knots of the definition, n + p + 2.
std::vector<Rational> all_knots(const BSpline& spline) {
  std::vector<Rational> knots = spline.knots;
  if (knots.size() < spline.points.size() + static_cast<std::size_t>(spline.degree) + 1) {
    knots.insert(knots.begin(), spline.knots.front());
    knots.push_back(spline.knots.back());
  }
  return knots;
}

std::optional<BSplineFault> fault_of_counts(const BSpline& spline) {
  if (spline.degree < 1)
    return BSplineFault{
        Member::degree, {}, fmt::format("the degree {} is less than 1", spline.degree)};
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::size_t count = spline.points.size();
  if (count <= p)
    return BSplineFault{
        Member::points,
        {},
        fmt::format("degree {} needs {} control points at least, not {}", p, p + 1, count)};
  const std::size_t knots = spline.knots.size();
  if (knots != count + p + 1 && knots + 1 != count + p)
    return BSplineFault{
        Member::knots,
        {},
        fmt::format("{} control points and degree {} need {} knots (or {} without the outermost "
                    "two), not {}",
                    count, p, count + p + 1, count + p - 1, knots)};
  return std::nullopt;
}

std::optional<BSplineFault> fault_of_knots(const BSpline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::vector<Rational>& u = spline.knots;
  for (std::size_t k = 1; k < u.size(); ++k)
    if (u[k] < u[k - 1])
      return BSplineFault{
          Member::knots, k,
          fmt::format("the knots decrease, from {} to {}", short_text(u[k - 1]), short_text(u[k]))};
  const std::size_t outer = u.size() == spline.points.size() + p + 1 ? p : p - 1;
  const Rational& first = u[outer];
  const Rational& last = u[u.size() - 1 - outer];
  if (first == last)
    return BSplineFault{
        Member::knots, outer,
        fmt::format("the curve is empty: it begins and ends at the knot {}", short_text(first))};
  for (std::size_t k = 0, next = 0; k < u.size(); k = next) {
    while (next < u.size() && u[next] == u[k]) ++next;
    const std::size_t multiplicity = next - k;
    if (multiplicity > p + 1)
      return BSplineFault{Member::knots, k,
                          fmt::format("the knot {} has the multiplicity {}, more than {} in degree "
                                      "{}",
                                      short_text(u[k]), multiplicity, p + 1, p)};
    if (multiplicity > p && first < u[k] && u[k] < last)
      return BSplineFault{Member::knots, k,
                          fmt::format("the knot {} has the multiplicity {}: the curve of degree {} "
                                      "is in two parts",
                                      short_text(u[k]), multiplicity, p)};
  }
  return std::nullopt;
}

std::optional<BSplineFault> fault_of_weights(const BSpline& spline) {
  const std::vector<Rational>& w = spline.weights;
  if (w.empty()) return std::nullopt;
  if (w.size() != spline.points.size())
    return BSplineFault{
        Member::weights,
        {},
        fmt::format("{} weights for {} control points", w.size(), spline.points.size())};
  for (std::size_t k = 0; k < w.size(); ++k)
    if (w[k] <= 0)
      return BSplineFault{Member::weights, k,
                          fmt::format("the weight {} is not greater than 0", short_text(w[k]))};
  return std::nullopt;
}

/// ((y − at)·below + (at − x)·above)/(y − x), x < y, of the first `dimension` coordinates.
HomogeneousPoint blossom_between(const HomogeneousPoint& below, const Rational& x,
                                 const HomogeneousPoint& above, const Rational& y,
                                 const Rational& at, std::size_t dimension) {
  if (at == x) return below;
  if (at == y) return above;
  const Rational share = (at - x) / (y - x);
  HomogeneousPoint result;
  for (std::size_t k = 0; k < dimension; ++k) result[k] = below[k] + share * (above[k] - below[k]);
  return result;
}

/// Of the span from knot i to the next, which is greater.
std::vector<HomogeneousPoint> span_points(const std::vector<Rational>& u, std::size_t p,
                                          std::size_t i,
                                          const std::vector<HomogeneousPoint>& points,
                                          std::size_t dimension) {
  const auto from = points.begin() + static_cast<std::ptrdiff_t>(i - p);
  std::vector<HomogeneousPoint> left(from, from + static_cast<std::ptrdiff_t>(p) + 1);
  std::vector<HomogeneousPoint> middle(p + 1);
  middle[p] = left[p];
  for (std::size_t r = 1; r <= p; ++r) {  // left[j] has a r times, and p − r knots up to u_{i+j}
    for (std::size_t j = 0; j + r <= p; ++j)
      left[j] =
          blossom_between(left[j], u[i - p + r + j], left[j + 1], u[i + j + 1], u[i], dimension);
    middle[p - r] = left[p - r];
  }
  std::vector<HomogeneousPoint> result{middle[0]};
  for (std::size_t r = 1; r <= p;
       ++r) {  // b r times, then a p − r − j times, and knots up to u_{i+j}
    for (std::size_t j = 0; j + r <= p; ++j)
      middle[j] =
          blossom_between(middle[j], u[i], middle[j + 1], u[i + j + 1], u[i + 1], dimension);
    result.push_back(middle[0]);
  }
  return result;
}

}  // namespace

std::optional<BSplineFault> fault_of(const BSpline& spline) {
  if (auto fault = fault_of_counts(spline)) return fault;
  if (auto fault = fault_of_knots(spline)) return fault;
  return fault_of_weights(spline);
}

std::vector<BezierPiece> bezier_pieces(const BSpline& spline) {
  if (const auto fault = fault_of(spline)) throw DomainError(fault->reason);
  const bool is_rational = std::any_of(spline.weights.begin(), spline.weights.end(),
                                       [&](const auto& w) { return w != spline.weights.front(); });
  std::vector<HomogeneousPoint> points;
  for (std::size_t k = 0; k < spline.points.size(); ++k) {
    const auto& [x, y, z] = spline.points[k];
    const Rational w = is_rational ? spline.weights[k] : Rational(1);
    points.push_back({w * x, w * y, w * z, w});
  }
  const auto p = static_cast<std::size_t>(spline.degree);
  const std::vector<Rational> u = all_knots(spline);
  std::vector<BezierPiece> pieces;
  for (std::size_t i = p; i < spline.points.size(); ++i) {
    if (u[i] == u[i + 1]) continue;
    BezierPiece& piece = pieces.emplace_back();
    piece.lower = u[i];
    piece.upper = u[i + 1];
    for (const HomogeneousPoint& h : span_points(u, p, i, points, is_rational ? 4 : 3)) {
      if (is_rational) piece.curve.weights.push_back(h[3]);
      piece.curve.points.push_back(is_rational
                                       ? Vector<Rational>{h[0] / h[3], h[1] / h[3], h[2] / h[3]}
                                       : Vector<Rational>{h[0], h[1], h[2]});
    }
  }
  return pieces;
}

namespace {

/// Parts of a curve with Bernstein coefficients of W that are > 0, one after the other.
class ClampedMaker {
 public:
  explicit ClampedMaker(long degree) { made_.degree = degree; }

  /// The curve on [from, to], with knots that much behind `start`. W > 0 there.
  void add(const RationalCurve& curve, const Rational& start, const Rational& from,
           const Rational& to) {
    const long n = made_.degree;
    const Polynomial t{from, to - from};
    std::vector<Rational> weights = to_bernstein(compose(curve.weight(), t), n);
    if (std::ranges::any_of(weights, [](const Rational& w) { return w <= 0; })) {
      const Rational middle = (from + to) / 2;
      add(curve, start, from, middle);
      add(curve, start, middle, to);
      return;
    }
    // What ends and what begins at a joint has one weight there.
    const Rational scale = made_.weights.empty() ? 1 : made_.weights.back() / weights[0];
    std::array<std::vector<Rational>, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = to_bernstein(compose(curve.numerator()[k], t), n);
    const bool is_first = made_.points.empty();
    for (std::size_t j = is_first ? 0 : 1; j < weights.size(); ++j) {
      made_.points.push_back({x[0][j] / weights[j], x[1][j] / weights[j], x[2][j] / weights[j]});
      made_.weights.push_back(scale * weights[j]);
    }
    made_.knots.insert(made_.knots.end(), static_cast<std::size_t>(is_first ? n + 1 : n),
                       start + from);
    end_ = start + to;
  }

  BSpline made() && {
    made_.knots.insert(made_.knots.end(), static_cast<std::size_t>(made_.degree + 1), end_);
    if (std::ranges::all_of(made_.weights, [](const Rational& w) { return w == 1; }))
      made_.weights.clear();
    return std::move(made_);
  }

 private:
  BSpline made_;
  Rational end_;
};

}  // namespace

BSpline as_bspline(const Path& path) {
  long most = 1;
  for (const Segment& segment : path.segments()) {
    const RationalCurve* curve = rational_curve(segment);
    if (curve == nullptr) throw DomainError("as_bspline: a segment is given by formulas");
    most = std::max(most, degree(*curve));
  }
  ClampedMaker maker(most);
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    maker.add(*rational_curve(path.segments()[k]), Rational(static_cast<long>(k)), 0, 1);
  return std::move(maker).made();
}

}  // namespace phrame
