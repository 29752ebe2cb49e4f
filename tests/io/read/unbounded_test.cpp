#include "io/reference.hpp"
#include "phrame/integrate/path_end.hpp"
#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/read/expression.hpp"

namespace unbounded_test {

// Integrals over unbounded intervals with exact values from tables and derivations,
// tests/data/unbounded.jsonl: each value is decided, with the multiple of π that is recorded.

using namespace phrame;
using test::Json;

namespace {

RealBall enclosed(const ExactValue& x, long bits) {
  RealBall multiple(x.pi, bits);
  if (x.irrational_pi) multiple = enclose(*x.irrational_pi, bits);
  RealBall sum = add(RealBall(x.rational, bits), multiply(multiple, pi(bits), bits), bits);
  for (const auto& [factor, of] : x.logarithms) {
    RealBall term(of, bits);
    arb_log(term.raw(), term.raw(), bits);
    sum = add(sum, multiply(RealBall(factor, bits), term, bits), bits);
  }
  CHECK(x.arctangents.empty());
  return sum;
}

Polynomial polynomial(const Json& list) {
  std::vector<Rational> coefficients;
  for (const Json& c : list) coefficients.push_back(test::rational(c));
  return Polynomial(coefficients);
}

}  // namespace

TEST_CASE("unbounded: every value is known exactly, and is the one in the table") {
  long values = 0;
  std::istringstream lines(test::read_data("unbounded.jsonl"));
  for (std::string line; std::getline(lines, line);) {
    const Json entry = Json::parse(line);
    CAPTURE(entry["id"].get<std::string>());
    const auto at_poles = entry.contains("pv") ? AtPoles::principal_value : AtPoles::refuse;
    const DefiniteIntegral integral =
        path_integral(parse_expression(entry["integrand"].get<std::string>()).value,
                      parse_endpoint(entry["from"].get<std::string>()),
                      parse_endpoint(entry["to"].get<std::string>()), at_poles);
    ++values;
    REQUIRE(integral.exact.has_value());
    const ExactValue& x = *integral.exact;
    const Polynomial of_multiple =
        x.irrational_pi ? x.irrational_pi->polynomial() : RealAlgebraic(x.pi).polynomial();
    CHECK(of_multiple == polynomial(entry["pi"]));
    const Rational truth = test::rational(entry["value"]);
    for (const RealBall& ball : {enclosed(x, 240), integral.value.enclose(240)}) {
      CHECK(ball.is_accurate(200));
      CHECK(abs(ball.midpoint() - truth) <= power_of_ten(-48) * (1 + abs(truth)));
    }
    if (is_rational(x)) CHECK(integral.value.exact() == x.rational);
  }
  CHECK(values == 104);
}

}  // namespace unbounded_test
