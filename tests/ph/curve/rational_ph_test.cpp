#include "phrame/ph/curve/rational_ph.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/along/segment_integral.hpp"
#include "phrame/ph/curve/end_point.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/curve/invariants.hpp"
#include "phrame/ph/curve/special_points.hpp"
#include "phrame/ph/curve/transform.hpp"
#include "phrame/ph/curve/vector.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "phrame/ph/offset/offset_trim.hpp"
#include "phrame/ph/offset/trim_measure.hpp"
#include "phrame/ph/proof/classify.hpp"
#include "support/random.hpp"
#include "support/rational_curves.hpp"
#include "support/refusal.hpp"

namespace rational_ph_test {
namespace {

using namespace phrame;
using test::for_samples;
using test::Random;
using test::reparametrized;

Curve random_curve(Random& random, long degree) {
  for (;;) {
    QuaternionPolynomial a{random.polynomial(degree), random.polynomial(degree),
                           random.polynomial(degree), random.nonzero_polynomial(degree)};
    return Curve(std::move(a), Polynomial{1}, {random.rational(), 1, -2});
  }
}

Curve ph_of(const RationalCurve& curve) { return std::get<Curve>(identify(curve)); }

bool agree(const Real& a, const Real& b) { return a.enclose(192).overlaps(b.enclose(192)); }

TangentLines lines_of(Random& random, long m) {
  for (;;) {
    const TangentLines lines{random.nonzero_polynomial(m),
                             random.polynomial(m) + Polynomial{3, 1},
                             {random.nonzero_polynomial(3), Polynomial{2, 0, 1}}};
    const Polynomial turn = differentiate(lines.a) * lines.b - lines.a * differentiate(lines.b);
    if (gcd(lines.a, lines.b).is_constant() && !turn.is_zero() &&
        count_real_roots(turn, closed_interval(0, 1)) == 0)
      return lines;
  }
}

}  // namespace

TEST_CASE("rational PH: a reparametrised curve has the angle, the length and the energies") {
  for_samples(6, [](Random& random) {
    const Curve curve = random_curve(random, random.integer(1, 2));
    if (!cusps(Segment(PhSegment(curve))).empty()) return;
    const RationalCurve given = reparametrized(curve, Rational(random.integer(2, 5), 7));
    const Path path{Segment(PhSegment(ph_of(given)))};
    const Path enclosed{Segment(given)};
    const Path polynomial(std::get<Curve>(identify(hodograph(curve), curve.start())));
    CHECK(!path.is_ph());
    CHECK(path.has_erf());
    const auto to_erf = [](const Path& of) { return PathAngle(of, Reference::euler_rodrigues); };
    CHECK(agree(to_erf(path).value(1), to_erf(polynomial).value(1)));
    // The default is that of other rational curves, and agrees with it.
    const PathAngle angle(path);
    const PathAngle other(enclosed);
    REQUIRE(angle.reference() == Reference::up);
    REQUIRE(angle.closed_form(0) != nullptr);
    REQUIRE(other.closed_form(0) == nullptr);
    for (const Rational& t : {Rational(1, 3), Rational(1)}) {
      CHECK(agree(angle.value(t), other.value(t)));
      const Frame<Real> f = rotation_minimizing_frame(angle, Place(0, t));
      const Frame<Real> g = rotation_minimizing_frame(other, Place(0, t));
      for (std::size_t k = 0; k < 3; ++k) CHECK(agree(f.e2[k], g.e2[k]));
    }
    CHECK(agree(total_length(path).value, total_length(polynomial).value));
    CHECK(agree(total_length(path).value, total_length(enclosed).value));
    CHECK(agree(PathLength(path).value({0, Rational(2, 3)}),
                PathLength(enclosed).value({0, Rational(2, 3)})));
    if (line_direction(curve.preimage())) return;
    CHECK(agree(total_torsion(path).value, total_torsion(polynomial).value));
    CHECK(agree(total_curvature(path).value, total_curvature(polynomial).value));
    const auto energy = [](const Path& of) {
      return std::get<PathTotal>(bending_energy(of)).value;
    };
    CHECK(agree(energy(path), energy(polynomial)));
    CHECK(agree(energy(path), energy(enclosed)));
    CHECK(agree(std::get<PathTotal>(frenet_energy(path)).value,
                std::get<PathTotal>(frenet_energy(polynomial)).value));
    const Classification kinds = classify(ph_of(given));
    CHECK(kinds.rational_frame.index() == classify(curve).rational_frame.index());
  });
}

TEST_CASE("rational PH: law: reparametrised curves with preimages up to m = 10 are found again") {
  for_samples(8, [](Random& random) {
    const Curve curve = random_curve(random, random.integer(1, 10));
    const RationalCurve given = reparametrized(curve, Rational(random.integer(2, 5), 7));
    const Curve found = ph_of(given);
    CHECK(found.weight() == given.weight());
    const RationalCurve again = PhSegment(found).by_positions();
    CHECK(again.numerator() == given.numerator());
    // W²r′ = f·A i A*, so that its square is that of f·|A|².
    const Vector<Polynomial> way = hodograph(given);
    CHECK(way == found.multiplier() * rotated_i(found.preimage()));
    CHECK(dot(way, way) == pow(found.multiplier() * sigma(found.preimage()), 2));
  });
}

TEST_CASE("rational PH: parts, motions and ends are those of the positions") {
  for_samples(10, [](Random& random) {
    const RationalCurve given = reparametrized(random_curve(random, 1), Rational(3, 4));
    const Curve curve = ph_of(given);
    CHECK(end_point(curve) == point(given, 1));
    const RationalQuaternion u{1, random.rational(), 2, random.rational()};
    const Curve moved =
        translated(rotated(segment(curve, Rational(1, 4), Rational(3, 4)), u), {1, 2, 3});
    const Vector<Rational> middle = point(given, Rational(1, 2));
    const Vector<Rational> image = middle[0] * rotated_i(u) + middle[1] * rotated_j(u) +
                                   middle[2] * rotated_k(u) + Vector<Rational>{1, 2, 3};
    CHECK(point(PhSegment(moved).by_positions(), Rational(1, 2)) == image);
    CHECK(point(PhSegment(turned_over(moved)).by_positions(), Rational(1, 2)) == image);
    CHECK(rational_ph_curve(curve.preimage(),
                            RationalFunction(curve.multiplier(), pow(curve.weight(), 2)),
                            curve.start())
              .weight() == curve.weight());
  });
}

TEST_CASE("rational PH: a circle's length and energy are known, and its residues are not 0") {
  const RationalCurve arc = bezier_curve({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {1, 1, 2});
  const Path quarter{Segment(PhSegment(ph_of(arc)))};
  const auto length = total_length(quarter);
  REQUIRE(length.exact);
  CHECK(length.exact->front().of.pi == Rational(1, 2));
  CHECK(std::get<PathTotal>(bending_energy(quarter)).exact->front().of.pi == Rational(1, 2));
  // The arc again, from its preimage 1 + tk turned by 90° and 2/(1 + t²)².
  const Curve again =
      rational_ph_curve({Polynomial{1, -1}, {}, {}, Polynomial{1, 1}},
                        RationalFunction(Polynomial{1}, pow(Polynomial{1, 0, 1}, 2)), {1, 0, 0});
  CHECK(PhSegment(again).by_positions().numerator() == arc.numerator());
  const auto refusal = [](const QuaternionPolynomial& a, const RationalFunction& f) {
    return test::refusal_of<DomainError>([&] { rational_ph_curve(a, f); });
  };
  const QuaternionPolynomial plane{Polynomial{1}, {}, {}, Polynomial{0, 1}};
  // (1 − t², 2t)/(1 + t²): x = 2 arctan t − t, y = log(1 + t²); over its square x is t/(1 + t²).
  CHECK(refusal(plane, {Polynomial{1}, Polynomial{1, 0, 1}}) ==
        "x has a logarithm: its residues at the roots of t^2 + 1 are not 0");
  CHECK(refusal({Polynomial{1}, {}, {}, Polynomial{0, 1}}, {Polynomial{1}, Polynomial{9, 6, 1}}) ==
        "x has a logarithm: its residues at the roots of t + 3 are not 0");
  CHECK(refusal(plane, {Polynomial{1}, Polynomial{1, -4, 4}}) ==
        "the multiplier has a pole at t = 1/2");
}

TEST_CASE("rational PH: a multiplier may cancel what A i A* has in common") {
  // A = t + i: A i A* = (t² + 1, 0, 0).
  const Curve line = rational_ph_curve({Polynomial{0, 1}, Polynomial{1}, {}, {}},
                                       {Polynomial{1}, Polynomial{1, 0, 1}});
  CHECK(PhSegment(line).by_positions().numerator() == Vector<Polynomial>{Polynomial{0, 1}, {}, {}});
}

TEST_CASE("tangents: points are on them, and offsets have the support p + d [PLANE]") {
  for_samples(10, [](Random& random) {
    const TangentLines lines = lines_of(random, random.chance(2) ? 2 : random.integer(3, 10));
    const Curve curve = curve_of_tangents(lines);
    const RationalCurve r = PhSegment(curve).by_positions();
    const auto& [a, b, p] = lines;
    const Polynomial& f = p.numerator();
    const Polynomial& g = p.denominator();
    // Points by the formulas of the dual representation.
    const Polynomial d = differentiate(a) * b - a * differentiate(b);
    const Polynomial s = a * a + b * b;
    const Polynomial w = differentiate(f) * g - f * differentiate(g);
    const RationalCurve expected(
        {Rational(2) * a * b * d * f * g - Rational(1, 2) * (pow(a, 4) - pow(b, 4)) * w,
         (a * a - b * b) * d * f * g + a * b * s * w,
         {}},
        s * d * g * g);
    CHECK(r.numerator() == expected.numerator());
    CHECK(r.weight() == expected.weight());
    // K + L·x + M·y = 0, along the curve, too.
    const Vector<Polynomial> line = line_coordinates(lines);
    const auto& [x, y, z] = r.numerator();
    CHECK((line[0] * r.weight() + line[1] * x + line[2] * y).is_zero());
    CHECK((line[1] * r.direction()[0] + line[2] * r.direction()[1]).is_zero());
    const TangentLines again = tangent_lines(curve);
    CHECK(again.support == p);
    const Rational far = Rational(random.integer(1, 9), 4);
    // To the right of travel, and n is to the right of A i A*.
    const RationalCurve shifted =
        phrame::offset(curve, Rational(sign_after_zero(curve.multiplier())) * far);
    const RationalCurve other =
        PhSegment(curve_of_tangents({a, b, p + RationalFunction(Polynomial{far})})).by_positions();
    CHECK(shifted.numerator() == other.numerator());
    CHECK(shifted.weight() == other.weight());
    const long most = std::max(f.degree(), g.degree());
    CHECK(degree(shifted) <=
          s.degree() + std::max(2 * most + d.degree(), s.degree() + most + g.degree() - 1));
  });
}

// Lengths and areas do not depend on the parameter.
TEST_CASE("rational PH: a trimmed offset is that of the same curve as a polynomial one") {
  const Curve loop(
      {from_bernstein({-4, 6, -6}), {}, {}, from_bernstein({1, Rational(15, 14), -6})});
  const PhPath polynomial(loop);
  const PhPath rational(ph_of(reparametrized(loop, Rational(2, 3))));
  for (const Rational& d : {Rational(33, 25), Rational(-1, 4)}) {
    const TrimmedOffset one = trimmed_offset(polynomial, d);
    const TrimmedOffset other = trimmed_offset(rational, d);
    REQUIRE(one.branches.size() == other.branches.size());
    CHECK(other.undecided.empty());
    for (std::size_t k = 0; k < one.branches.size(); ++k)
      CHECK(agree(measure(polynomial, one, one.branches[k]).length,
                  measure(rational, other, other.branches[k]).length));
  }
}

TEST_CASE("tangents: what is no curve is refused") {
  const auto refusal = [](const TangentLines& lines) {
    return test::refusal_of<DomainError>([&] { curve_of_tangents(lines); });
  };
  const Polynomial t{0, 1};
  CHECK(refusal({t, t, RationalFunction(Polynomial{1})}) ==
        "tangents: a and b have a common factor");
  CHECK(refusal({Polynomial{1}, Polynomial{2}, RationalFunction(t)}) ==
        "tangents: the normal does not turn, the lines are parallel");
  CHECK(refusal({t, Polynomial{1}, {Rational(2) * t, Polynomial{1, 0, 1}}}) ==
        "tangents: all lines go through one point");
  CHECK(refusal({t, Polynomial{1}, {Polynomial{1}, Polynomial{1, -2}}}) ==
        "the curve is at infinity at t = 1/2");
  // The offsets of a PH cubic are PH.
  const Curve cubic({Polynomial{1}, {}, {}, t});
  const Curve offset = ph_of(phrame::offset(cubic, Rational(-1, 3)));
  CHECK(offset.preimage().q == t * offset.preimage().u);
}

}  // namespace rational_ph_test
