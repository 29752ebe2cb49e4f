#include "phrame/ph/frame/signed_frenet.hpp"

#include <cmath>

#include "phrame/algebra/error.hpp"
#include "phrame/io/read/formula.hpp"
#include "phrame/ph/along/curvature.hpp"
#include "phrame/ph/along/path_totals.hpp"
#include "phrame/ph/frame/closed_curve.hpp"
#include "phrame/ph/frame/path_frame.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace signed_frenet_test {

using namespace phrame;
using test::for_samples;
using test::Random;

namespace {

Path by_formulas(const std::array<const char*, 3>& position, const char* to = "2*pi",
                 const char* from = "0") {
  const auto read = [](const char* text) { return parse_formula(text, "p").value; };
  return Path(ExpressionCurve({read(position[0]), read(position[1]), read(position[2])}, read(from),
                              read(to), "p"));
}

double product(const Vector<Real>& a, const Vector<Real>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += round_to_double(a[k]) * round_to_double(b[k]);
  return sum;
}

/// No step of n is more than a right angle, and off inflections it is Frenet's or its opposite, as
/// the sign of κ says.
void check_continued(const Path& path, long steps) {
  const SignedFrenet frames(path);
  Vector<Real> last = frames.frame({0, Rational(0)}).e2;
  for (std::size_t k = 0; k < path.segments().size(); ++k)
    for (long j = 0; j <= steps; ++j) {
      const Place at(k, Rational(j, steps));
      const Frame<Real> frame = frames.frame(at);
      CHECK(product(frame.e2, last) > 0);
      last = frame.e2;
      const double kappa = round_to_double(frames.curvature(at));
      CHECK(std::abs(std::abs(kappa) - round_to_double(curvature(path, at))) < 1e-12);
      if (kappa != 0) CHECK(product(frame.e2, frenet_frame(path, at).e2) * kappa > 0);
    }
}

/// The axis of a stellarator, with κ = 0 at p = 0 and π.
const std::array<const char*, 3> axis{"(1-cos(2*p)/5)*cos(p)", "(1-cos(2*p)/5)*sin(p)",
                                      "3/10*sin(2*p)"};
const std::array<const char*, 3> three_zeros{"(1+cos(3*p)/10)*cos(p)", "(1+cos(3*p)/10)*sin(p)",
                                             "sin(3*p)/5"};
const std::array<const char*, 3> trefoil{"(2 + cos(3*p))*cos(2*p)", "(2 + cos(3*p))*sin(2*p)",
                                         "sin(3*p)"};

}  // namespace

TEST_CASE("signed Frenet: of PH, rational curves and formulas n goes on through inflections") {
  // A = (1 + i(t − 1/2)²…): a plane quintic with κ = 0 at t = 1/2, and the same by its positions.
  const Polynomial x{Rational(-1, 2), 1};
  const Curve inflected({{1}, {}, {}, x * x * Polynomial{3}});
  check_continued(Path(inflected), 8);
  check_continued(test::by_positions(PhPath(inflected)), 8);
  check_continued(Path(test::cut(inflected, {Rational(1, 2)})), 6);
  check_continued(Path(test::cut(inflected, {Rational(1, 3)})), 6);
  // (t, t³, t⁵) in space: r′ × r″ = t·(…).
  check_continued(Path(RationalCurve(
                      {Polynomial{-1, 2}, pow(Polynomial{-1, 2}, 3), pow(Polynomial{-1, 2}, 5)})),
                  8);
  check_continued(by_formulas({"p", "p^3", "p^5"}, "1", "-1"), 8);
  check_continued(by_formulas({"p", "p^3", "p^5"}, "-1", "1"), 8);
  check_continued(by_formulas({"p", "p^4", "p^6"}, "1", "-1"), 8);  // of order 2: no change
  check_continued(by_formulas(axis), 12);
  check_continued(by_formulas(trefoil), 60);
}

TEST_CASE("signed Frenet: at the zero it is the limit, exactly where that is rational") {
  // r′ × r″ = 6p·(5p⁴, −10p²/3…): along (0, 0, 1) at p = 0, r′ along x.
  const Frame<Real> at =
      SignedFrenet(by_formulas({"p", "p^3", "p^5"}, "1", "-1")).frame({0, Rational(1, 2)});
  const double n = round_to_double(at.e2[1]);
  CHECK(std::abs(n) == 1);  // Frenet's n before, at p < 0, is along −y
  CHECK(n == -1);
  CHECK(SignedFrenet(by_formulas({"p", "p^3", "p^5"}, "1", "-1"))
            .curvature({0, Rational(1, 2)})
            .exact() == Rational(0));
  CHECK(round_to_double(SignedFrenet(by_formulas(axis)).frame({0, Rational(0)}).e2[1]) == 0.6);
}

// Turns of n against v × e₁ by 20 000 points in NumPy, n carried on from one to the next: 0.99994,
// −2.99995, −1.49988, less of which is what is between the last and the first point.
TEST_CASE("signed Frenet: helicity") {
  CHECK(SignedFrenet(by_formulas(axis)).turns_about({0, 0, 1}) == 1);
  CHECK(SignedFrenet(by_formulas(trefoil)).turns_about({0, 0, 1}) == -3);
  CHECK(SignedFrenet(by_formulas(three_zeros)).turns_about({0, 0, 1}) == Rational(-3, 2));
  CHECK(SignedFrenet(by_formulas(three_zeros, "0", "2*pi")).turns_about({0, 0, 1}) ==
        Rational(-3, 2));
  CHECK_THROWS_WITH_AS(
      SignedFrenet(by_formulas({"p", "p^3", "p^5"}, "1", "-1")).turns_about({0, 0, 1}),
      doctest::Contains("not closed"), DomainError);
}

// The copy of the curve along n winds about it as often as that along v, and by the turns between.
TEST_CASE(
    "signed Frenet: law: without inflections the self-linking number is that of v and turns") {
  const Path path = by_formulas(trefoil);
  const long linked = self_linking_number(closed_frame(path), total_torsion(path).value);
  for (const Vector<Rational>& v : {Vector<Rational>{0, 0, 1}, Vector<Rational>{0, 1, 5}}) {
    const auto frame = closed_frame(path, v);
    REQUIRE(frame);
    CHECK(Rational(linked - frame->linking) == SignedFrenet(path).turns_about(v));
  }
}

TEST_CASE("signed Frenet: lines, jumps at joints and zeros that are not told are refused") {
  CHECK_THROWS_WITH_AS(SignedFrenet(test::polygon({{0, 0, 0}, {1, 1, 0}})),
                       doctest::Contains("straight line"), DomainError);
  // κ = 0 where sin p = p/2, which is no simple place; in a plane b is known.
  CHECK_THROWS_WITH_AS(
      SignedFrenet(by_formulas({"p", "p^3/12 + sin(p)", "p^4/24 + 2*cos(p) + p*sin(p)"}, "3", "1")),
      doctest::Contains("not told"), Undecided);
  check_continued(by_formulas({"p", "p^3/12 + sin(p)", "2*p"}, "3", "1"), 9);
}

}  // namespace signed_frenet_test
