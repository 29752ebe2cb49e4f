#include <algorithm>

#include "io/reference.hpp"
#include "phrame/integrate/definite_integral.hpp"
#include "phrame/integrate/integrate.hpp"
#include "phrame/io/read/endpoint.hpp"
#include "phrame/io/read/expression.hpp"

// The public corpus, tests/data/integrals.jsonl: every integrand is read and integrated, and every
// value agrees with the one computed elsewhere.

using namespace phrame;
using test::Json;

namespace {

std::vector<Json> corpus() {
  std::vector<Json> entries;
  std::istringstream lines(test::read_data("integrals.jsonl"));
  for (std::string line; std::getline(lines, line);) entries.push_back(Json::parse(line));
  return entries;
}

/// The recorded value has 50 digits.
void check_value(const RationalFunction& f, const Json& path) {
  const PathEnd from = parse_endpoint(path["from"].get<std::string>());
  const PathEnd to = parse_endpoint(path["to"].get<std::string>());
  const auto at_poles = path.contains("pv") ? AtPoles::principal_value : AtPoles::refuse;
  const Rational truth = test::rational(path["value"]);
  const Rational value =
      parse_rational(round_to_decimal(path_integral(f, from, to, at_poles).value, 52).value);
  CHECK(abs(value - truth) <= power_of_ten(-48) * (1 + abs(truth)));
}

}  // namespace

TEST_CASE("corpus: every integrand has an integral, and its values are the recorded ones") {
  long values = 0;
  for (const Json& entry : corpus()) {
    CAPTURE(entry["id"].get<std::string>());
    const Expression f = parse_expression(entry["integrand"].get<std::string>(),
                                          entry["variable"].get<std::string>());
    CHECK_NOTHROW(integrate(f.value));
    for (const Json& path : entry.value("definite", Json::array())) {
      check_value(f.value, path);
      ++values;
    }
  }
  CHECK(values == 276);
}

TEST_CASE("corpus: where every residue is 0, the integral is rational") {
  for (const Json& entry : corpus()) {
    CAPTURE(entry["id"].get<std::string>());
    const auto& kinds = entry["kinds"];
    const bool is_rational =
        std::find(kinds.begin(), kinds.end(), "rational-integral") != kinds.end();
    const bool is_polynomial = std::find(kinds.begin(), kinds.end(), "polynomial") != kinds.end();
    const Expression f = parse_expression(entry["integrand"].get<std::string>());
    CHECK(integrate(f.value).logs.empty() == (is_rational || is_polynomial));
  }
}
