#include "phrame/ph/proof/path_certificate.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/curve/identify.hpp"
#include "phrame/ph/proof/certify.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/rational_curves.hpp"

using namespace phrame;

namespace path_certificate_test {

std::vector<std::string> not_proved(const PathCertificate& c) {
  std::vector<std::string> found;
  for (const Statement& statement : verify(c)) {
    if (statement.is_proved()) continue;
    const auto* name = std::get_if<std::string>(&statement.what);
    found.push_back(name != nullptr ? *name : to_string(std::get<AngleClaim>(statement.what).t));
  }
  return found;
}

}  // namespace path_certificate_test

using namespace path_certificate_test;

// Of a curve that is cut, and so has joints, the angles are those of the curve.
TEST_CASE("certificate of a path: a curve in parts has the angles that it has as a whole") {
  const Rational cut(1, 3);
  const PhPath path = test::cut(test::quintic, {cut});
  const std::vector<Rational> on_path{0, Rational(1, 2), 1, Rational(5, 4), 2};
  const std::vector<Rational> on_curve{0, Rational(1, 6), cut, cut + Rational(1, 6), 1};
  const PathCertificate parts = certify(path, on_path, 25);
  const Certificate whole = certify(test::quintic, Reference::euler_rodrigues, on_curve, 25);
  REQUIRE(parts.segments.size() == 2);
  for (std::size_t k = 0; k < on_path.size(); ++k) {
    CHECK(parts.claims[k].t == on_path[k]);
    CHECK(parts.claims[k].theta == whole.claims[k].theta);
    CHECK(parts.claims[k].radius == whole.claims[k].radius);
  }
  CHECK(not_proved(parts).empty());
}

TEST_CASE("certificate of a path: what does not follow is not proved") {
  const PathCertificate honest = certify(test::cut(test::quintic, {Rational(1, 3), Rational(1, 2)}),
                                         {Rational(1, 2), 2, 3}, 20);
  using Names = std::vector<std::string>;
  CHECK(not_proved(honest) == Names{});
  PathCertificate lie = honest;
  lie.claims[1].theta.back() = lie.claims[1].theta.back() == '5' ? '6' : '5';
  CHECK(not_proved(lie) == Names{"2"});
  lie = honest;
  lie.segments[1].claims.clear();
  CHECK(not_proved(lie) == Names{"2", "3"});
  lie = honest;
  std::swap(lie.segments[1], lie.segments[2]);
  CHECK(not_proved(lie) == Names{"joint 1", "joint 2", "2", "3"});
  // A·(1 + 2i) is the same curve with another Euler–Rodrigues frame.
  lie = honest;
  const auto [alpha, beta] = hopf_form(honest.segments[2].curve.preimage());
  const GaussianPolynomial turn{{1}, {2}};
  const Curve& last = honest.segments[2].curve;
  lie.segments[2] = certify(Curve(from_hopf_form({alpha * turn, beta * turn}),
                                  Rational(1, 5) * last.multiplier(), last.start()),
                            Reference::euler_rodrigues, {1}, 30);
  CHECK(not_proved(lie) == Names{"joint 2", "2", "3"});
}

TEST_CASE(
    "certificate of a path: places that are not on it are refused, and the writhe of corners") {
  CHECK_THROWS_AS(certify(test::cut(test::quintic, {Rational(1, 3)}), {3}, 20), DomainError);
  CHECK_THROWS_AS(certify(test::cut(test::quintic, {Rational(1, 3)}), {-1}, 20), DomainError);
  PhPath corner(Curve({{1}, {}, {}, {}}));
  corner.append(Curve({{1}, {}, {}, {1}}, Polynomial{1}, {1, 0, 0}));
  REQUIRE(corner.corners().size() == 1);
  CHECK(not_proved(certify(corner, {2}, 20)).empty());
  CHECK_THROWS_WITH_AS(
      certify(corner, {2}, 20, {.writhe = true}),
      "certify: the path has a corner at t = 1, and no certificate tells of its writhe",
      DomainError);
}

TEST_CASE("certificate of a path: rational and polynomial curves, one behind the other") {
  const Rational c(2);
  const Curve rational = std::get<Curve>(identify(test::reparametrized(test::quintic, c)));
  PhPath path = test::cut(rational, {Rational(1, 2)});  // at 2/3 of the quintic
  path = PhPath(path.segments().front());
  path.append(segment(test::quintic, Rational(2, 3), 1));
  REQUIRE_FALSE(path.segments()[0].is_polynomial());
  REQUIRE(path.segments()[1].is_polynomial());
  const PathCertificate honest = certify(path, {1, 2}, 25);
  const Certificate whole =
      certify(test::quintic, Reference::euler_rodrigues, {Rational(2, 3), 1}, 25);
  for (std::size_t k = 0; k < 2; ++k) CHECK(honest.claims[k].theta == whole.claims[k].theta);
  CHECK(not_proved(honest).empty());
  // The weight is 0 where the second segment begins.
  PathCertificate lie = honest;
  lie.segments[0].curve = test::with_factor(lie.segments[0].curve, Polynomial{1, -1});
  const auto failed = not_proved(lie);
  for (const char* name : {"weight", "joint 1", "2"})
    CHECK(std::ranges::find(failed, name) != failed.end());
}
