// 44 random Bézier, rational and B-spline curves and NURBS of degree 2 to 12 against mpmath's
// quadrature (tests/data/any_curves.py).
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "io/reference.hpp"
#include "phrame/algebra/ball_order.hpp"
#include "phrame/io/read/any_path.hpp"
#include "phrame/io/read/json_node.hpp"
#include "phrame/io/read/number.hpp"
#include "phrame/ph/along/path_angle.hpp"
#include "phrame/ph/along/path_length.hpp"

using namespace phrame;

namespace {

/// Are 32 significant digits, or places where the number is below 1, those of the reference?
bool is_quadrature(const Real& x, const Rational& reference) {
  const RealBall off = subtract(x.enclose(130), RealBall(reference, 140), 130);
  const Rational size = std::max(Rational(1), abs(reference));
  return absolute(off).upper() < parse_rational("1e-32") * size;
}

}  // namespace

TEST_CASE("any curve: angles and lengths are those of quadrature") {
  std::istringstream lines(test::read_data("any_curves.jsonl"));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    CAPTURE(line);
    const JsonValue document = parse_json_file(line, "line");
    const JsonNode node(document);
    const Path path = read_any_path(node.at("file")).path;
    REQUIRE_FALSE(path.is_ph());
    const std::vector<Rational> up = node.at("up").numbers(3);
    const PathAngle angle(path, {up[0], up[1], up[2]});
    CHECK(is_quadrature(angle.value({0, Rational(1, 3)}), node.at("third").number()));
    CHECK(is_quadrature(angle.value({path.segments().size() - 1, Rational(1)}),
                        node.at("theta").number()));
    CHECK(is_quadrature(PathLength(path).total(), node.at("length").number()));
  }
  CHECK(count == 44);
}
