// On the projective line of φ the polynomials are forms: X, Y and W of the degree n, H of the
// degree e, p of the degree 2n − 2 − e and H × H′ of the degree 2e − 2. A polynomial of a lower
// degree than its form has a zero at ∞.
//
// Where p and H × H′ have no real zero U turns one way, and is convex if it turns once: if H₂ has
// two zeros. Then no point is met twice by real φ.
//
// Let U be traced once by complex φ, but for some points. Curves X/W and A/C, of irreducible
// algebraic curves, have the same one if X(φ)C(ψ) − A(ψ)W(φ) and Y(φ)C(ψ) − B(ψ)W(φ) have a common
// factor, as that has, for nearly each φ, a zero ψ, and otherwise finitely many common zeros. The
// real points of that curve are those of U and finitely many others, which only complex φ lead to:
// so −U is the curve U where it is on the same algebraic one. And U is traced k times where the
// common factor for U and U itself has the degree k in ψ.
#include "phrame/ph/offset/gauge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "phrame/algebra/bivariate_factor.hpp"
#include "phrame/algebra/error.hpp"
#include "phrame/algebra/real_algebraic.hpp"
#include "phrame/ph/offset/gauge_normal.hpp"

namespace phrame::inline v0 {
namespace {

[[noreturn]] void refuse_gauge(const std::string& reason) { throw DomainError("gauge: " + reason); }

/// Where a form of the degree n has a real zero: "phi = 1/2", "phi = infinity"; empty where it has
/// none.
std::string zero_of_form(const Polynomial& p, long n) {
  if (p.is_zero()) return "every phi";
  const std::vector<RealRoot> roots = real_roots(p, real_line());
  if (!roots.empty()) return place_text("phi", roots.front().at);
  return p.degree() < n ? "phi = infinity" : "";
}

/// The factor that X(φ)C(ψ) − A(ψ)W(φ) and Y(φ)C(ψ) − B(ψ)W(φ) have in common, φ being t, for the
/// curves (X, Y)/W and (A, B)/C.
Bivariate common_factor(const GaugeVector& a, const GaugeVector& b) {
  const auto gap = [&](const Polynomial& of_a, const Polynomial& of_b) {
    std::vector<Polynomial> rows;
    for (long k = 0; k <= std::max(of_a.degree(), a.weight.degree()); ++k)
      rows.push_back(of_a.coefficient(k) * b.weight - a.weight.coefficient(k) * of_b);
    return Bivariate(std::move(rows));
  };
  return gcd(gap(a.x, b.x), gap(a.y, b.y));
}

const RationalCurve& rational_part(const Segment& segment) {
  const RationalCurve* curve = rational_curve(segment);
  if (curve == nullptr) refuse_gauge("it is given by formulas, and no rational curve");
  if (!curve->numerator()[2].is_zero()) refuse_gauge("it is not in the plane z = 0");
  return *curve;
}

GaugeVector plane_form(const RationalCurve& curve) {
  const Vector<Polynomial> r = curve.numerator();
  return {r[0], r[1], curve.weight()};
}

/// Throws where it is not closed, or not strictly convex.
void require_convex(const RationalCurve& curve, const GaugeVector& u) {
  const long n = std::max({u.x.degree(), u.y.degree(), u.weight.degree()});
  if (const std::string pole = zero_of_form(u.weight, n); !pole.empty())
    refuse_gauge("it is not closed: it goes to infinity at " + pole);
  const auto& [a, b, z] = curve.direction();
  const long e = std::max(a.degree(), b.degree());
  if (const std::string zero = zero_of_form(curve.multiplier(), 2 * n - 2 - e); !zero.empty())
    refuse_gauge("it is not strictly convex: U' = 0 at " + zero);
  const Polynomial bend = a * differentiate(b) - differentiate(a) * b;
  if (const std::string zero = zero_of_form(bend, 2 * e - 2); !zero.empty())
    refuse_gauge("it is not strictly convex: U' x U'' = 0 at " + zero);
  const long level = count_real_roots(b, real_line()) + (b.degree() < e ? 1 : 0);
  if (level != 2)
    refuse_gauge(fmt::format("it is not convex: it turns {} times as it goes round", level / 2));
}

}  // namespace

Gauge::Gauge(const Path& path) {
  const RationalCurve& curve = rational_part(path.segments().front());
  const GaugeVector u = plane_form(curve);
  for (std::size_t k = 1; k < path.segments().size(); ++k)
    if (common_factor(u, plane_form(rational_part(path.segments()[k]))).degree() < 1)
      refuse_gauge(
          fmt::format("it is one rational curve, whole as phi goes from -infinity to infinity, and "
                      "segment {} is "
                      "on another one than the first",
                      k + 1));
  require_convex(curve, u);
  if (const long times = common_factor(u, u).degree(); times > 1)
    refuse_gauge(
        fmt::format("it is traced {} times by complex phi: the curve has a lower degree", times));
  if (common_factor(u, {-u.x, -u.y, u.weight}).degree() < 1)
    refuse_gauge("it is not symmetric about (0, 0): -U is another curve");
  x_ = u.x;
  y_ = u.y;
  weight_ = u.weight;
  direction_ = {curve.direction()[0], curve.direction()[1]};
}

}  // namespace phrame
