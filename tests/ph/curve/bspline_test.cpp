#include "phrame/ph/curve/bspline.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/curve.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

/// By the recursion of Cox and de Boor, which blossoms know nothing of: N_{k,p}(u), continuous from
/// the right, 0/0 = 0.
Rational basis(const std::vector<Rational>& u, std::size_t k, std::size_t p, const Rational& at) {
  if (p == 0) return u[k] <= at && at < u[k + 1] ? 1 : 0;
  const auto part = [&](const Rational& above, const Rational& below, std::size_t next) {
    return below == 0 ? Rational(0) : above / below * basis(u, next, p - 1, at);
  };
  return part(at - u[k], u[k + p] - u[k], k) +
         part(u[k + p + 1] - at, u[k + p + 1] - u[k + 1], k + 1);
}

Vector<Rational> value(const BSpline& spline, const Rational& at) {
  Vector<Rational> sum{};
  Rational below;
  for (std::size_t k = 0; k < spline.points.size(); ++k) {
    const Rational weight = (spline.weights.empty() ? Rational(1) : spline.weights[k]) *
                            basis(spline.knots, k, static_cast<std::size_t>(spline.degree), at);
    sum = sum + weight * spline.points[k];
    below += weight;
  }
  return Rational(1 / below) * sum;
}

/// Of a Bézier curve, by the Bernstein polynomials.
Vector<Rational> value(const BezierPiece& piece, const Rational& u) {
  const Rational t = (u - piece.lower) / (piece.upper - piece.lower);
  std::vector<Rational> weights = piece.curve.weights;
  if (weights.empty()) weights.assign(piece.curve.points.size(), 1);
  Vector<Rational> sum;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<Rational> coefficients;
    for (std::size_t k = 0; k < weights.size(); ++k)
      coefficients.push_back(weights[k] * piece.curve.points[k][c]);
    sum[c] = from_bernstein(coefficients)(t);
  }
  return Rational(1 / from_bernstein(weights)(t)) * sum;
}

BSpline random_spline(Random& random) {
  BSpline spline;
  spline.degree = random.integer(1, 5);
  const long count = spline.degree + random.integer(1, 5);
  Rational knot = random.rational();
  long multiplicity = 1;
  for (long k = 0; k < count + spline.degree + 1; ++k) {
    spline.knots.push_back(knot);
    if (multiplicity < spline.degree && random.chance(2)) {
      ++multiplicity;
    } else {
      knot += abs(random.rational()) + Rational(1, 7);
      multiplicity = 1;
    }
  }
  const bool is_rational = random.chance(2);
  for (long k = 0; k < count; ++k) {
    spline.points.push_back({random.rational(), random.rational(), random.rational()});
    if (is_rational) spline.weights.push_back(abs(random.rational()) + Rational(1, 9));
  }
  return spline;
}

std::string fault(const BSpline& spline) {
  const auto found = fault_of(spline);
  return found ? found->reason : "none";
}

/// With points and knots 0, 1, 2, ….
BSpline spline_with(long degree, std::vector<Rational> knots, long count) {
  BSpline spline{degree, std::move(knots), {}};
  for (long k = 0; k < count; ++k) spline.points.push_back({k, k * k, 0});
  return spline;
}

}  // namespace

TEST_CASE("the pieces of a B-spline are it, by the recursion of Cox and de Boor") {
  for_samples(60, [](Random& random) {
    const BSpline spline = random_spline(random);
    const auto p = static_cast<std::size_t>(spline.degree);
    if (fault_of(spline)) return;
    const auto pieces = bezier_pieces(spline);
    CHECK(pieces.front().lower == spline.knots[p]);
    CHECK(pieces.back().upper == spline.knots[spline.points.size()]);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const BezierPiece& piece = pieces[k];
      CHECK(piece.curve.points.size() == p + 1);
      if (k > 0) CHECK(piece.lower == pieces[k - 1].upper);
      for (const Rational& share : {Rational(0), Rational(1, 3), Rational(7, 8)}) {
        const Rational u = piece.lower + share * (piece.upper - piece.lower);
        CHECK(value(piece, u) == value(spline, u));
      }
      for (const Rational& w : piece.curve.weights) CHECK(w > 0);
    }
  });
}

TEST_CASE("without its outermost knots a B-spline is the same") {
  for_samples(20, [](Random& random) {
    const BSpline spline = random_spline(random);
    if (fault_of(spline)) return;
    BSpline shorter = spline;
    shorter.knots.erase(shorter.knots.begin());
    shorter.knots.pop_back();
    const auto a = bezier_pieces(spline);
    const auto b = bezier_pieces(shorter);
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      CHECK(a[k].curve.points == b[k].curve.points);
      CHECK(a[k].curve.weights == b[k].curve.weights);
    }
  });
}

TEST_CASE("a Bézier curve is its own piece; equal weights are none") {
  const BSpline line = spline_with(3, {0, 0, 0, 0, 2, 2, 2, 2}, 4);
  CHECK(bezier_pieces(line).front().curve.points == line.points);
  BSpline weighted = line;
  weighted.weights = {3, 3, 3, 3};
  CHECK(bezier_pieces(weighted).front().curve.points == line.points);
  CHECK(bezier_pieces(weighted).front().curve.weights.empty());
}

TEST_CASE("B-splines and NURBS have the points that SciPy and geomdl find") {
  std::ifstream file(test::data("/splines.json"));
  const auto document = nlohmann::json::parse(file);
  const auto rational = [](const nlohmann::json& x) { return exact_rational(x.get<double>()); };
  for (const auto& given : document["bsplines"]) {
    CAPTURE(given["name"].get<std::string>());
    BSpline spline{given["degree"].get<long>(), {}, {}};
    for (const auto& u : given["knots"]) spline.knots.push_back(rational(u));
    for (const auto& p : given["control_points"])
      spline.points.push_back({rational(p[0]), rational(p[1]), rational(p[2])});
    if (given.contains("weights"))
      for (const auto& w : given["weights"]) spline.weights.push_back(rational(w));
    const auto pieces = bezier_pieces(spline);
    for (std::size_t k = 0; k < given["at"].size(); ++k) {
      const Rational u = rational(given["at"][k]);
      const auto piece = std::find_if(pieces.begin(), pieces.end(),
                                      [&](const BezierPiece& x) { return u <= x.upper; });
      REQUIRE(piece != pieces.end());
      for (std::size_t c = 0; c < 3; ++c)
        CHECK(static_cast<double>(value(*piece, u)[c]) ==
              doctest::Approx(given["values"][k][c].get<double>()).epsilon(1e-12));
    }
  }
}

TEST_CASE("what is no B-spline is refused") {
  CHECK(fault(spline_with(2, {0, 0, 0, 1, 1, 1}, 3)) == "none");
  CHECK(fault(spline_with(0, {0, 1}, 1)) == "the degree 0 is less than 1");
  CHECK(fault(spline_with(3, {0, 0, 0, 1, 1, 1}, 3)) ==
        "degree 3 needs 4 control points at least, not 3");
  CHECK(fault(spline_with(2, {0, 0, 0, 1, 1}, 3)) ==
        "3 control points and degree 2 need 6 knots (or 4 without the outermost two), not 5");
  CHECK(fault(spline_with(2, {0, 0, 2, 1, 3, 3}, 3)) == "the knots decrease, from 2 to 1");
  CHECK(fault(spline_with(2, {0, 0, 1, 1, 2, 2}, 3)) ==
        "the curve is empty: it begins and ends at the knot 1");
  CHECK(fault(spline_with(2, {0, 0, 0, 0, 1, 1, 1}, 4)) ==
        "the knot 0 has the multiplicity 4, more than 3 in degree 2");
  CHECK(fault(spline_with(2, {0, 0, 0, 1, 1, 1, 2, 2, 2}, 6)) ==
        "the knot 1 has the multiplicity 3: the curve of degree 2 is in two parts");
  BSpline spline = spline_with(2, {0, 0, 0, 1, 1, 1}, 3);
  spline.weights = {1, 2};
  CHECK(fault(spline) == "2 weights for 3 control points");
  spline.weights = {1, 0, 1};
  CHECK(fault(spline) == "the weight 0 is not greater than 0");
  CHECK(fault_of(spline)->index == 1);
  CHECK(fault_of(spline)->member == BSplineFault::Member::weights);
  spline.weights = {1, 1, Rational(-1, 2)};
  CHECK_THROWS_AS(bezier_pieces(spline), DomainError);
}
