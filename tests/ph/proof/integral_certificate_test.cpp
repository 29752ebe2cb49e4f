#include <doctest/doctest.h>

#include <algorithm>

#include "phrame/algebra/error.hpp"
#include "phrame/ph/proof/certify_integral.hpp"
#include "phrame/ph/proof/verify_integral.hpp"
#include "support/curves.hpp"

using namespace phrame;

namespace integral_certificate_test {

const RationalCurve parabola({Polynomial{0, 1}, Polynomial{0, 0, 1}, Polynomial{}});
const RationalCurve cubic({Polynomial{0, 1}, Polynomial{0, 0, 1}, Polynomial{0, 0, 0, 1}});

/// The objections.
std::vector<std::string> objections(const IntegralCertificate& c) {
  std::vector<std::string> found;
  for (const Statement& statement : verify(c))
    if (!statement.is_proved()) found.push_back(statement.objection);
  return found;
}

template <class C>
auto& first(C& c) {
  return std::get<IntegralSegment>(c.segments.front());
}

}  // namespace integral_certificate_test

using namespace integral_certificate_test;

// √5/2 + arsinh(2)/4, by mpmath.
TEST_CASE("certificate of a length: that of the parabola is what it is by calculus") {
  const IntegralCertificate c = certify_length(Path(parabola), {0, 1}, 40);
  CHECK(c.lengths[0].length == "0");
  CHECK(c.lengths[1].length == "1.478942857544597433827906019433914435072");
  CHECK(objections(c).empty());
  CHECK(std::get<Path>(path_of(c)) == Path(parabola));
  IntegralCertificate wrong = c;
  wrong.lengths[1].length.back() = '1';
  CHECK(objections(wrong) == std::vector<std::string>{"it does not follow from the pieces"});
}

TEST_CASE("certificate of a length: a polynomial PH curve has one piece, whose rate is f sigma") {
  const IntegralCertificate c = certify_length(Path(test::quintic), {1}, 20);
  CHECK(first(c).pieces.size() == 1);
  CHECK(first(c).square.degree() == 4);
  CHECK(objections(c).empty());
}

TEST_CASE("certificate of an angle: pieces that are changed, lost or of another frame do not do") {
  const IntegralCertificate c = certify(PathAngle(Path(cubic), {0, 0, 1}), {Rational(1, 3), 1}, 20);
  REQUIRE(first(c).pieces.size() > 1);
  CHECK(objections(c).empty());
  IntegralCertificate wrong = c;
  first(wrong).pieces.pop_back();
  CHECK(objections(wrong) == std::vector<std::string>{"the pieces of segment 0 end before t"});
  wrong = c;
  first(wrong).pieces.back().rate.terms.front() += 1L << 50;
  CHECK(objections(wrong).size() == 1);
  wrong = c;
  first(wrong).pieces.front().root.terms.clear();
  CHECK(objections(wrong).front() == "piece 0: the root of it is too far off");
  wrong = c;
  wrong.up = {1, 0, 1};
  CHECK(objections(wrong).size() >= 2);
  wrong = c;
  wrong.frame = Reference::frenet;
  CHECK(objections(wrong).size() >= 2);
}

TEST_CASE("certificate of an angle: in a plane it is 0, exactly") {
  const IntegralCertificate c = certify(PathAngle(Path(parabola)), {1}, 20);
  CHECK(c.angles.front().theta == "0");
  CHECK(c.angles.front().radius == "0");
  CHECK(objections(c).empty());
}

TEST_CASE("certificate of an angle: what has none is refused") {
  CHECK_THROWS_WITH_AS(certify(PathAngle(Path(test::quintic)), {1}, 20),
                       "certify: this angle is to the Euler-Rodrigues frame", DomainError);
  CHECK_THROWS_AS(certify_length(Path(cubic), {2}, 20), DomainError);
}
